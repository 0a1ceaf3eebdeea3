# SPDX-License-Identifier: BSD-3-Clause
"""A packing jammed by us and handed over stays as it is under the same pressure; its job script begins the
run on two ranks and goes on from a restart file; what comes back is the packing, and converged.
JAM_APP ANALYZE_APP FOLDER"""

import json
import os
import shutil
import sys

from handoff_lammps import done, hand_over, need_lammps
from reference import check, need

SCENE = """
[sizes]
kind = "power-law"
size_ratio = 5
alpha = 0.5
count = 400
[protocol]
kind = "nph"
pressure = 1e-2
masses = "diameter"
[stop]
cundall = 2e-6
kinetic_energy = 1e-9
window = 2000
[run]
record_interval = 500
"""
STEPS = 10000


def stats(analyze_app, packing):
    return json.loads(done([analyze_app, "stats", "--json", packing]))


def submit(folder):
    """Runs the job script as Slurm would, in the folder of its submission."""
    os.environ["LAUNCH"] = "mpirun --allow-run-as-root --oversubscribe -np 2"
    return done(["bash", "job.slurm"], folder)


def check_same(what, found, expected):
    apart = abs(found["volume_fraction"] - expected["volume_fraction"])
    print(f"{what}: phi moved by {apart:.1e}, Z_nr is {found['coordination_nr']:.6f}")
    assert apart < 1e-6
    assert found["coordination_nr"] == expected["coordination_nr"]
    assert found["rattler_count"] == expected["rattler_count"]


def main():
    need_lammps()
    jam_app, analyze_app, folder = sys.argv[1:4]
    os.chdir(folder)
    with open("jam.toml", "w") as scene:
        scene.write(SCENE)
    shutil.rmtree("jammed", ignore_errors=True)
    done([jam_app, "run", "jam.toml", "--out", "jammed"])
    expected = stats(analyze_app, "jammed/packing.h5")
    # A tolerance that nothing meets: all of the steps are done.
    hand_over(jam_app, "jammed/packing.h5", "handed_jammed", f"stop.max_steps={STEPS}",
              "stop.kinetic_energy=1e-300", "run.checkpoint_interval=4000")
    first = submit("handed_jammed")
    assert f"step {STEPS}: phi" in first and "step 2000: phi" in first
    check_same("after 10,000 steps", stats(analyze_app, "handed_jammed/final.dump"), expected)
    again = submit("handed_jammed")  # from step 8000, of which the latest restart file is
    assert f"step {STEPS}: phi" in again and "step 2000: phi" not in again
    check_same("gone on", stats(analyze_app, "handed_jammed/final.dump"), expected)
    done([analyze_app, "convert", "final.dump", "final.h5"], "handed_jammed")
    check_same("converted", stats(analyze_app, "handed_jammed/final.h5"), expected)
    with need("h5py").File("handed_jammed/final.h5") as file:
        check("contacts in the converted file", len(file["connectivity/contacts"]), expected["contact_count"])
        check("observable", file["observables/coordination_nr/value"][0], expected["coordination_nr"], 1e-15)
    shutil.rmtree("back", ignore_errors=True)
    done([jam_app, "run", "handed_jammed/back.toml", "--out", "back", "--set", "stop.kinetic_energy=1e-9"])
    check_same("taken back", stats(analyze_app, "back/packing.h5"), expected)


if __name__ == "__main__":
    main()
