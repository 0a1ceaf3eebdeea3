# SPDX-License-Identifier: BSD-3-Clause
"""One evaluation of a handed over packing: forces, contacts and all six pressures are ours, for both
contact laws, tilted cells, size ratios 1, 5 and 20, on one rank and on two.
JAM_APP FIXED_CELL FOLDER"""

import os
import sys

from handoff_lammps import hand_over, need_lammps, ours, theirs
from reference import check

ROUNDING = 1e-12


def compare(what, found, expected):
    assert expected.contacts > 1000
    check(f"{what}: contacts", found.contacts, expected.contacts)
    check(f"{what}: forces", found.forces, expected.forces, ROUNDING)
    check(f"{what}: pressures", found.pressure, expected.pressure, ROUNDING)


def main():
    need_lammps()
    jam_app, fixed_cell, folder = sys.argv[1:4]
    os.chdir(folder)
    for size_ratio in (1, 5, 20):
        for law in ("hooke", "hertz"):
            packing, handed = f"lambda{size_ratio}.h5", f"handed_{size_ratio}_{law}"
            hand_over(jam_app, packing, handed, f"contact.law={law}")
            expected = ours(fixed_cell, packing, "ours_forces", law, 0.5)
            for ranks in (1, 2):
                compare(f"lambda {size_ratio}, {law}, {ranks} rank(s)", theirs(handed, ranks=ranks), expected)


if __name__ == "__main__":
    main()
