#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the examples of a document and follows its links.

Usage: scripts/check_docs.py DOCUMENT.md --programs DIR

A block fenced as ```sh run is run by bash, the document's blocks one after the other, in a scratch
folder that also holds data/ and docs/; the two programs are on the PATH. A block stops at its first
failing command, unless the block shows one on purpose: ```sh run exit=2. A block fenced as
```toml scene is a scene, or the part of one that matters here, and must pass `jam_app check`. Blocks
fenced otherwise are not run, and may not call the programs: an example that nobody runs goes stale.
"""

import argparse
import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
FENCE = re.compile(r"^\s*```\s*(.*?)\s*$")
CALLS_PROGRAM = re.compile(r"^\s*(jam_app|analyze_app)\b", re.MULTILINE)
LINK = re.compile(r"\]\(([^)\s]+)\)")
SECONDS_A_BLOCK = 120


def parts(text):
    """(line number, fence's words or None for prose, text) of the document, in order."""
    fence, start, lines = None, 1, []
    for number, line in enumerate(text.splitlines(), start=1):
        if not (match := FENCE.match(line)):
            lines.append(line)
            continue
        yield start, fence, "\n".join(lines)
        fence = match[1] if fence is None else None
        start, lines = number + 1, []
    yield start, fence, "\n".join(lines)


def run_problem(words, block, folder, programs):
    """What went wrong in running `block`, or None."""
    expected = next((int(w[len("exit="):]) for w in words if w.startswith("exit=")), 0)
    environment = {**os.environ, "PATH": f"{programs}{os.pathsep}{os.environ['PATH']}"}
    try:
        done = subprocess.run(["bash", "-euo", "pipefail", "-c", block], cwd=folder, env=environment,
                              stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, text=True, timeout=SECONDS_A_BLOCK)
    except subprocess.TimeoutExpired:
        return f"not done after {SECONDS_A_BLOCK} s: choose a smaller example"
    if done.returncode == expected:
        return None
    return f"exit status {done.returncode}, not {expected}:\n{block}\n--- output\n{done.stdout}"


def link_problem(document, target):
    """What is wrong with a relative link, or None."""
    if re.match(r"[a-z]+:", target) or target.startswith("#"):
        return None
    found = (document.parent / target.split("#")[0]).exists()
    return None if found else f"link to {target}, which is not there"


def problems(document, programs, folder):
    for number, fence, text in parts(document.read_text()):
        if fence is None:
            found = [link_problem(document, target) for target in LINK.findall(text)]
        elif fence.split()[:2] == ["sh", "run"]:
            found = [run_problem(fence.split()[2:], text, folder, programs)]
        elif fence.split() == ["toml", "scene"]:
            (Path(folder) / "block.toml").write_text(text + "\n")
            found = [run_problem([], "jam_app check block.toml", folder, programs)]
        elif CALLS_PROGRAM.search(text):
            found = ["calls a program but is not run: fence it as ```sh run"]
        else:
            found = []
        yield from (f"{document}:{number}: {problem}" for problem in found if problem)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("document", type=Path)
    parser.add_argument("--programs", type=Path, required=True)
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        for name in ("data", "docs"):
            (Path(folder) / name).symlink_to(ROOT / name)
        found = list(problems(arguments.document, arguments.programs.resolve(), folder))
    for problem in found:
        print(problem)
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()
