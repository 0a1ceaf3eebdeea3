# SPDX-License-Identifier: BSD-3-Clause
"""LAMMPS reads packing.data and packing.dump and writes them again: the spheres and the cell are the
same to rounding (LAMMPS wraps positions through the cell's own coordinates).  DUMP FOLDER"""

import os
import shutil
import subprocess
import sys
from types import SimpleNamespace

import numpy as np

from reference import SKIPPED, Reference, check

INPUT = """
units lj
atom_style sphere
boundary p p p
read_data packing.data
{more}
write_dump all custom {out} id type diameter x y z vx vy vz modify sort id format float %20.17g
"""
ROUNDING = 1e-15


def by_id(reference):
    order = np.argsort(reference.ids)
    arrays = {name: getattr(reference, name)[order] for name in ("ids", "diameters", "positions", "velocities")}
    return SimpleNamespace(**arrays, cell=reference.cell)


def through_lammps(program, out, more=""):
    done = subprocess.run([program, "-log", "none", "-screen", "none"], text=True,
                          input=INPUT.format(more=more, out=out), capture_output=True)
    if done.returncode != 0:
        sys.exit(f"LAMMPS refused the file:\n{done.stdout}{done.stderr}")
    return by_id(Reference(out))


def compare(what, found, expected):
    check(f"{what}: ids", found.ids, expected.ids)
    check(f"{what}: diameters", found.diameters, expected.diameters)
    check(f"{what}: velocities", found.velocities, expected.velocities)
    check(f"{what}: cell", found.cell, expected.cell, 2 * ROUNDING)
    apart = (found.positions - expected.positions) @ np.linalg.inv(expected.cell)
    apart = (apart - np.round(apart)) @ expected.cell
    check(f"{what}: positions", expected.positions + apart, expected.positions, 20 * ROUNDING)


def main():
    program = shutil.which("lmp")
    if program is None:
        print("skipped: no LAMMPS; scripts/install_dependencies.sh --interop installs it")
        sys.exit(SKIPPED)
    reference = Reference(sys.argv[1])
    os.chdir(sys.argv[2])
    expected = by_id(reference)
    compare("packing.data", through_lammps(program, "back.data.dump"), expected)
    replace = (f"set group all x 0 vx 0\nread_dump packing.dump {reference.step} "
               "x y z vx vy vz box yes replace yes")
    compare("packing.dump", through_lammps(program, "back.dump.dump", replace), expected)


if __name__ == "__main__":
    main()
