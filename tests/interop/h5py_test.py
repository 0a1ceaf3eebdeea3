# SPDX-License-Identifier: BSD-3-Clause
"""h5py reads packing.h5: every value, and no array in the file twice.  DUMP FOLDER"""

import os
import sys

from reference import Reference, check, need

h5py = need("h5py")


def check_particles(file, reference):
    everything = file["particles/all"]
    check("positions", everything["position/value"][0], reference.positions)
    check("velocities", everything["velocity/value"][0], reference.velocities)
    check("diameters", everything["diameter"], reference.diameters)
    check("ids", everything["id"], reference.ids)
    check("masses", everything["mass"], 3.141592653589793 / 6 * reference.diameters**3, 1e-14)
    check("cell", everything["box/edges/value"][0], reference.cell, 1e-15)
    check("step", everything["box/edges/step"], [reference.step])
    check("time", everything["position/time"], [0.25])
    assert list(everything["box"].attrs["boundary"]) == [b"periodic"] * 3
    assert everything["box"].attrs["dimension"] == 3


def check_the_rest(file, reference):
    pairs = file["connectivity/contacts"]
    expected = reference.contacts()
    assert len(expected) > 10000
    check("contacts", sorted(map(tuple, pairs[:].tolist())), expected)
    assert file[pairs.attrs["particles_group"]] == file["particles/all"]
    coordination = file["observables/Z/value"][0]
    check("observable Z", coordination, 2 * len(expected) / len(reference.ids), 1e-15)
    # The test wrote the matrix whose columns are the edges, so this is row by row.
    check("observable cell", file["observables/cell/value"][0], reference.cell.T, 1e-15)
    assert file["parameters/scene"][()].decode() == "[sizes]\nkind = \"Größe\"\n"
    assert file["parameters/material/law"][()] == b"hooke"
    assert tuple(file["h5md"].attrs["version"]) == (1, 1)


def check_nothing_twice(file, path, size):
    check("shown positions", file["VTKHDF/Points"], file["particles/all/position/value"][0])
    assert file["VTKHDF/Points"].is_virtual
    assert file["VTKHDF/PointData/diameter"] == file["particles/all/diameter"]
    pairs = file["connectivity/contacts"].size
    bytes_once = 8 * (size * (3 + 3 + 1 + 1 + 1 + 1) + pairs)  # the last 1: VTK's connectivity
    assert os.path.getsize(path) < bytes_once + 30000, "something is in the file twice"


def main():
    reference, path = Reference(sys.argv[1]), os.path.join(sys.argv[2], "packing.h5")
    with h5py.File(path, "r") as file:
        check_particles(file, reference)
        check_the_rest(file, reference)
        check_nothing_twice(file, path, len(reference.ids))


if __name__ == "__main__":
    main()
