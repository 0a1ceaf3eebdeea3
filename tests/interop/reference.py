# SPDX-License-Identifier: BSD-3-Clause
"""The packing that write_files wrote, read here from LAMMPS' own dump without any of our code, and
what every comparison with another program needs."""

import importlib
import sys

import numpy as np

SKIPPED = 77  # what CTest takes for "not run"


def need(module):
    """The module, or the end of this test where it is not installed."""
    try:
        return importlib.import_module(module)
    except ImportError as error:
        print(f"skipped: {error}; scripts/install_dependencies.sh --interop installs it")
        sys.exit(SKIPPED)


class Reference:
    """ids, diameters, positions, velocities, in the order of the file, and the cell's edges as rows."""

    def __init__(self, dump):
        with open(dump) as file:
            lines = file.read().splitlines()
        self.step = int(lines[1])
        low, high, tilt = np.array([line.split() for line in lines[5:8]], dtype=float).T
        xy, xz, yz = tilt
        low[0] -= min(0.0, xy, xz, xy + xz)
        high[0] -= max(0.0, xy, xz, xy + xz)
        low[1] -= min(0.0, yz)
        high[1] -= max(0.0, yz)
        lx, ly, lz = high - low
        self.cell = np.array([[lx, 0.0, 0.0], [xy, ly, 0.0], [xz, yz, lz]])
        names = lines[8].split()[2:]
        rows = np.array([line.split() for line in lines[9:]], dtype=float)
        column = {name: rows[:, k] for k, name in enumerate(names)}
        self.ids = column["id"].astype(int)
        self.diameters = column["diameter"]
        self.positions = np.stack([column[axis] for axis in "xyz"], axis=1) - low
        self.velocities = np.stack([column["v" + axis] for axis in "xyz"], axis=1)

    def contacts(self):
        """Overlapping pairs (through the nearest image of a cell that is hardly tilted), by brute
        force: their ids, the smaller place first."""
        found = []
        edges = np.diag(self.cell)
        for i in range(len(self.ids) - 1):
            apart = self.positions[i + 1:] - self.positions[i]
            for axis in (2, 1, 0):  # c holds parts of a and b, so it goes first
                apart -= np.round(apart[:, axis] / edges[axis])[:, None] * self.cell[axis]
            sums = 0.5 * (self.diameters[i] + self.diameters[i + 1:])
            touching = np.flatnonzero((apart**2).sum(axis=1) < sums**2) + i + 1
            found += [(self.ids[i], self.ids[j]) for j in touching]
        return sorted(found)


def check(what, found, expected, relative=0.0):
    """Ends the test unless the values agree: exactly, or to `relative` of the largest."""
    found, expected = np.asarray(found), np.asarray(expected)
    if found.shape != expected.shape:
        sys.exit(f"{what}: shape {found.shape}, not {expected.shape}")
    error = np.abs(found.astype(float) - expected).max() if expected.size else 0.0
    if not error <= relative * np.abs(expected).max():
        sys.exit(f"{what}: off by {error} (allowed: {relative} relative)")
    print(f"{what}: agree to {error}")
