# SPDX-License-Identifier: BSD-3-Clause
"""What the tests of `jam_app handoff` share: handing over, and running LAMMPS on it."""

import os
import shutil
import subprocess
import sys
from types import SimpleNamespace

import numpy as np

from reference import SKIPPED


def need_lammps():
    """Ends this test where LAMMPS is not installed."""
    if shutil.which("lmp") is None:
        print("skipped: no LAMMPS; scripts/install_dependencies.sh --interop installs it")
        sys.exit(SKIPPED)


def done(command, folder="."):
    """Standard output of a command; its failure ends this test."""
    ended = subprocess.run(command, cwd=folder, text=True, capture_output=True, env={
        **os.environ, "OMP_NUM_THREADS": "1"})
    if ended.returncode != 0:
        sys.exit(f"{' '.join(command)}: exit status {ended.returncode}\n{ended.stdout[-3000:]}{ended.stderr}")
    return ended.stdout


def hand_over(jam_app, packing, folder, *settings):
    shutil.rmtree(folder, ignore_errors=True)
    sets = [word for setting in settings for word in ("--set", setting)]
    done([jam_app, "handoff", packing, "-o", folder, *sets])


def lammps(folder, script, ranks=1, log="none"):
    """Runs LAMMPS in the folder of a handoff."""
    program = ["lmp", "-in", script, "-log", log, "-screen", "none"]
    if ranks > 1:
        program = ["mpirun", "--allow-run-as-root", "--oversubscribe", "-np", str(ranks), *program]
    done(program, folder)


FIXED_CELL = """
include system.in
{timestep}
compute contacts all contact/atom
compute sum all reduce sum c_contacts
compute p all pressure NULL virial
fix motion all nve/sphere
thermo_style custom step c_sum c_p[1] c_p[2] c_p[3] c_p[4] c_p[5] c_p[6]
thermo_modify norm no
run {steps}
print "$(0.5*c_sum:%.0f) $(c_p[1]:%.17g) $(c_p[2]:%.17g) $(c_p[3]:%.17g) $(c_p[4]:%.17g) $(c_p[5]:%.17g) $(c_p[6]:%.17g)" file sums
write_dump all custom spheres id x y z vx vy vz fx fy fz modify sort id format float %.17g
"""


def read(sums, rows):
    table = np.array([row.split() for row in rows], dtype=float)
    table = table[np.argsort(table[:, 0])]
    numbers = [float(word) for word in sums.split()]
    return SimpleNamespace(contacts=numbers[0], pressure=np.array(numbers[1:]), positions=table[:, 1:4],
                           velocities=table[:, 4:7], forces=table[:, 7:10])


def theirs(folder, time_step=None, steps=0, ranks=1):
    """What LAMMPS makes of a handed over packing in the cell as it is."""
    timestep = "" if time_step is None else f"timestep {time_step!r}"
    with open(os.path.join(folder, "fixed_cell.in"), "w") as script:
        script.write(FIXED_CELL.format(timestep=timestep, steps=steps))
    lammps(folder, "fixed_cell.in", ranks)
    with open(os.path.join(folder, "sums")) as sums, open(os.path.join(folder, "spheres")) as spheres:
        return read(sums.read(), spheres.read().splitlines()[9:])


def ours(program, packing, out, law, damping, time_step=0.01, steps=0):
    done([program, "run", packing, out, law, str(damping), repr(time_step), str(steps)])
    with open(out) as file:
        lines = file.read().splitlines()
    return read(lines[0], lines[1:])
