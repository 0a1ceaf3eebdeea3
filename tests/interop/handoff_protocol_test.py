# SPDX-License-Identifier: BSD-3-Clause
"""LAMMPS jams a scene from its loose start by what we hand over, under an isotropic and under a sheared
pressure, and stops by the scene's criteria; ours then find it converged.  JAM_APP FOLDER"""

import json
import os
import re
import shutil
import sys

from handoff_lammps import done, hand_over, lammps, need_lammps

SCENE = """
[sizes]
kind = "power-law"
size_ratio = 2
alpha = 0.5
count = 300
[protocol]
pressure = {pressure}
masses = "diameter"
[stop]
cundall = 1e-4
kinetic_energy = 1e-8
coordination_change = 0.02
volume_fraction_change = 1e-5
window = 2000
max_steps = 100000
[run]
record_interval = 500
"""


def check_jams(jam_app, name, pressure):
    with open(f"{name}.toml", "w") as scene:
        scene.write(SCENE.format(pressure=pressure))
    handed = f"handed_{name}"
    hand_over(jam_app, f"{name}.toml", handed)
    lammps(handed, "run.in", log="log")
    with open(f"{handed}/log") as log:
        windows = re.findall(r"^step (\d+): phi .* converged: ([01])$", log.read(), re.MULTILINE)
    assert windows[-1][1] == "1" and all(converged == "0" for _, converged in windows[:-1]), windows
    back = f"back_{name}"
    shutil.rmtree(back, ignore_errors=True)
    done([jam_app, "run", f"{handed}/back.toml", "--out", back])  # fails unless it converges
    with open(f"{back}/record.jsonl") as records:
        first = json.loads(records.readline())
    print(f"{name}: {windows[-1][0]} steps there, phi {first['volume_fraction']:.5f}, first record here: "
          f"C {first['cundall']:.1e}")
    assert first["cundall"] < 1e-4


def main():
    need_lammps()
    jam_app, folder = sys.argv[1:3]
    os.chdir(folder)
    check_jams(jam_app, "isotropic", "1e-2")
    check_jams(jam_app, "sheared", "[1e-2, 1e-2, 1.2e-2, 0, 0, 1e-3]")


if __name__ == "__main__":
    main()
