# SPDX-License-Identifier: BSD-3-Clause
"""MDAnalysis reads packing.h5, the LAMMPS dump and the LAMMPS data file. It keeps single precision,
so values agree to 1e-7 of the cell.  DUMP FOLDER"""

import os
import sys
import warnings

import numpy as np

from reference import Reference, check, need

warnings.filterwarnings("ignore")
MDAnalysis = need("MDAnalysis")
need("h5py")
SINGLE = 1.2e-7


def check_frame(what, universe, reference):
    atoms, frame = universe.atoms, universe.trajectory.ts
    check(f"{what}: positions", atoms.positions, reference.positions, SINGLE)
    check(f"{what}: cell", frame.triclinic_dimensions, reference.cell, 10 * SINGLE)


def check_h5(path, reference):
    universe = MDAnalysis.Universe.empty(len(reference.ids))
    universe.load_new(path, format="H5MD", convert_units=False)
    check_frame("packing.h5", universe, reference)
    check("packing.h5: velocities", universe.trajectory.ts.velocities, reference.velocities, SINGLE)
    check("packing.h5: time", universe.trajectory.ts.time, 0.25)
    assert universe.trajectory.ts.data["step"] == reference.step


def check_dump(path, reference):
    universe = MDAnalysis.Universe.empty(len(reference.ids))
    universe.load_new(path, format="LAMMPSDUMP")
    sorted_by_id = np.argsort(reference.ids)  # as MDAnalysis sorts them
    check("packing.dump: positions", universe.atoms.positions, reference.positions[sorted_by_id], SINGLE)


def check_xyz(path, reference):
    universe = MDAnalysis.Universe(path, format="XYZ")
    check("packing.xyz: positions", universe.atoms.positions, reference.positions, SINGLE)


def main():
    reference, folder = Reference(sys.argv[1]), sys.argv[2]
    check_h5(os.path.join(folder, "packing.h5"), reference)
    check_dump(os.path.join(folder, "packing.dump"), reference)
    check_xyz(os.path.join(folder, "packing.xyz"), reference)


if __name__ == "__main__":
    main()
