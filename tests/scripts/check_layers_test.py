# SPDX-License-Identifier: BSD-3-Clause
"""Every rule of scripts/check_layers.py against a small tree that breaks it."""

import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SCRIPT = Path(__file__).resolve().parents[2] / "scripts" / "check_layers.py"
SOUND_TREE = {
    "lib/core/types.h": "#include <Eigen/Core>\n",
    "lib/core/parallel.h": '#include "core/types.h"\n#include <tbb/parallel_for.h>\n',
    "lib/core/version.h.in": "",
    "lib/cell/cell.h": '#include "core/types.h"\n#include <array>\n',
    "lib/packing/packing.h": '#include "cell/cell.h"\n',
    "lib/packing/packing_file.cpp": '#include "packing/packing.h"\n#include <hdf5.h>\n',
    "apps/jam_app/main.cpp": '#include "core/version.h"\n#include "shared/log.h"\n',
    "apps/analyze_app/main.cpp": "",
    "apps/shared/log.h": '#include "packing/packing.h"\n#include <spdlog/spdlog.h>\n',
}


def check(changes):
    """(exit status, output) for the sound tree with `changes` made to it."""
    with tempfile.TemporaryDirectory() as root:
        for name, text in {**SOUND_TREE, **changes}.items():
            path = Path(root) / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text)
        done = subprocess.run([sys.executable, SCRIPT, root], capture_output=True, text=True)
        return done.returncode, done.stdout


class CheckLayers(unittest.TestCase):
    def expect_violation(self, file, text, message):
        status, output = check({file: text})
        self.assertEqual(status, 1, output)
        self.assertIn(message, output)
        self.assertIn(file.split("/", 1)[1], output)

    def test_sound_tree_passes(self):
        status, output = check({})
        self.assertEqual(status, 0, output)

    def test_lower_layer_may_not_see_a_higher_one(self):
        self.expect_violation("lib/cell/cell.cpp", '#include "packing/packing.h"\n', "cell may not include packing")

    def test_analysis_never_sees_jamming(self):
        status, output = check({
            "lib/jamming/step.h": "",
            "lib/analysis/rattlers.cpp": '  #  include "jamming/step.h"\n',
        })
        self.assertEqual(status, 1)
        self.assertIn("lib/analysis/rattlers.cpp:1: analysis may not include jamming", output)

    def test_files_may_not_form_a_circle(self):
        status, output = check({
            "lib/cell/cell.h": '#include "cell/strain.h"\n',
            "lib/cell/strain.h": '#include "cell/cell.h"\n',
        })
        self.assertEqual(status, 1)
        self.assertIn("circle: cell/cell.h -> cell/strain.h -> cell/cell.h", output)

    def test_one_door_to_tbb(self):
        for spelling in ("tbb/tbb.h", "oneapi/tbb.h", "oneapi/tbb/parallel_for.h"):
            self.expect_violation("lib/cell/cell.cpp", f"#include <{spelling}>\n", "only core/parallel.*")
        self.expect_violation("apps/jam_app/main.cpp", "#include <tbb/parallel_for.h>\n", "only core/parallel.*")

    def test_headers_show_no_private_library(self):
        self.expect_violation("lib/packing/file.h", "#include <hdf5.h>\n", "keep it in a .cpp")
        self.expect_violation("lib/core/random.h", "#include <Random123/philox.h>\n", "keep it in a .cpp")

    def test_nothing_sees_apps_and_apps_do_not_see_each_other(self):
        self.expect_violation("lib/packing/packing.cpp", '#include "shared/log.h"\n', "no file of lib/")
        status, output = check({
            "apps/jam_app/options.h": "",
            "apps/analyze_app/main.cpp": '#include "jam_app/options.h"\n',
        })
        self.assertEqual(status, 1)
        self.assertIn("analyze_app may not include jam_app", output)

    def test_folder_without_a_row_and_include_without_a_folder(self):
        self.expect_violation("lib/utils/helpers.h", "", "no row")
        self.expect_violation("lib/cell/cell.cpp", '#include "cell.h"\n', "no file of lib/")


if __name__ == "__main__":
    unittest.main()
