# SPDX-License-Identifier: BSD-3-Clause
"""scripts/check_docs.py against documents that are right and wrong in one way each."""

import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SCRIPT = Path(__file__).resolve().parents[2] / "scripts" / "check_docs.py"


def check(text):
    """(exit status, output) for a document with two programs: one succeeds, one exits with 2."""
    with tempfile.TemporaryDirectory() as folder:
        for name, status in (("analyze_app", 0), ("jam_app", 2)):
            program = Path(folder) / name
            program.write_text(f"#!/bin/sh\necho {name} says: $*\nexit {status}\n")
            program.chmod(0o755)
        document = Path(folder) / "page.md"
        document.write_text(text)
        done = subprocess.run([sys.executable, SCRIPT, document, "--programs", folder],
                              capture_output=True, text=True)
        return done.returncode, done.stdout


class CheckDocs(unittest.TestCase):
    def expect_problem(self, text, message):
        status, output = check(text)
        self.assertEqual(status, 1, output)
        self.assertIn(message, output)

    def test_blocks_share_one_folder_and_see_programs_and_docs(self):
        status, output = check("# Page\n```sh run\nanalyze_app > out.txt\n```\ntext [here](page.md)\n"
                               "```sh run\ntest -s out.txt && test -d docs\n```\n")
        self.assertEqual(status, 0, output)

    def test_failing_command_is_reported_with_its_output(self):
        self.expect_problem("\n```sh run\njam_app bad\ntrue\n```\n", "page.md:3: exit status 2, not 0")
        self.expect_problem("```sh run\njam_app bad\n```\n", "jam_app says: bad")

    def test_failure_shown_on_purpose(self):
        status, output = check("```sh run exit=2\njam_app bad\n```\n")
        self.assertEqual(status, 0, output)
        self.expect_problem("```sh run exit=2\nanalyze_app\n```\n", "exit status 0, not 2")

    def test_example_that_nobody_runs(self):
        self.expect_problem("```sh\njam_app run\n```\n", "is not run")
        self.expect_problem("```\n  analyze_app stats\n```\n", "is not run")

    def test_scene_goes_to_the_program(self):
        self.expect_problem("```toml scene\n[sizes]\n```\n", "jam_app says: check block.toml")
        self.assertEqual(check("```toml\n[sizes]\n```\n")[0], 0)

    def test_dead_link(self):
        self.expect_problem("see [there](missing.md#part)\n", "link to missing.md")


if __name__ == "__main__":
    unittest.main()
