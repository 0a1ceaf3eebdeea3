# SPDX-License-Identifier: BSD-3-Clause
"""Runs the Python recipe of docs/file-format.md on packing.h5 and checks what it leaves behind.
DUMP FOLDER DOCUMENT"""

import os
import re
import sys

import numpy as np

from reference import Reference, check, need

need("h5py")


def main():
    reference = Reference(sys.argv[1])
    with open(sys.argv[3]) as document:
        recipe = re.search(r"```python\n(.*?)```", document.read(), re.DOTALL)[1]
    assert len(recipe.strip().splitlines()) <= 12, "the recipe is meant to be short"
    os.chdir(sys.argv[2])
    made = {}
    exec(recipe, made)
    check("positions", made["positions"], reference.positions)
    check("diameters", made["diameters"], reference.diameters)
    check("cell", made["cell"], reference.cell, 1e-15)
    places = np.sort(made["contacts"], axis=1)
    assert reference.ids[0] != 0  # otherwise ids could pass for places
    check("contacts", sorted(map(tuple, reference.ids[made["contacts"]].tolist())), reference.contacts())
    assert (places[:, 0] < places[:, 1]).all()
    solid = np.pi / 6 * (reference.diameters**3).sum() / np.linalg.det(reference.cell)
    check("phi", made["phi"], solid, 1e-14)


if __name__ == "__main__":
    main()
