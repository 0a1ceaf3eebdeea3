# SPDX-License-Identifier: BSD-3-Clause
"""1,000 steps of LAMMPS in a fixed cell are ours, damped and undamped, both laws. The distance to a run
with steps half as long shrinks with the step as it should: fourfold, velocity Verlet's second order,
or twofold where forces depend on velocities, which stand half a step back in both programs.
JAM_APP FIXED_CELL FOLDER"""

import os
import sys

import numpy as np

from handoff_lammps import hand_over, need_lammps, ours, theirs
from reference import check

STEPS, TIME_STEP = 1000, 0.02
SAME_STEP = 1e-9  # of the largest velocity: what a thousand steps make of rounding


def apart(one, other):
    return np.abs(one.velocities - other.velocities).max()


def main():
    need_lammps()
    jam_app, fixed_cell, folder = sys.argv[1:4]
    os.chdir(folder)
    for law, damping in (("hooke", 0), ("hooke", 0.5), ("hertz", 0), ("hertz", 0.5)):
        handed, what = f"handed_steps_{law}_{damping}", f"{law}, damping {damping}"
        hand_over(jam_app, "swinging.h5", handed, f"contact.law={law}", f"contact.damping={damping}")

        def we(part):
            return ours(fixed_cell, "swinging.h5", "ours_steps", law, damping, TIME_STEP / part, STEPS * part)

        def they(part):
            return theirs(handed, TIME_STEP / part, STEPS * part)

        we_1, we_2, we_4, they_1, they_2 = we(1), we(2), we(4), they(1), they(2)
        assert np.abs(we_1.velocities).max() > 1e-4  # they do swing
        check(f"{what}: velocities", they_1.velocities, we_1.velocities, SAME_STEP)
        check(f"{what}: contacts", they_1.contacts, we_1.contacts)
        check(f"{what}: pressures", they_1.pressure, we_1.pressure, SAME_STEP)
        shrinking = apart(they_1, we_2) / apart(they_2, we_4)
        print(f"{what}: error shrinks {shrinking:.2f}-fold with half the step")
        order = 1 if damping > 0 else 2
        assert 0.75 * 2**order < shrinking < 1.4 * 2**order


if __name__ == "__main__":
    main()
