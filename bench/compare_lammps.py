#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Widejam and LAMMPS side by side on one dense packing: CPU time a particle-step and memory, on one core.

    bench/compare_lammps.py --size-ratio 10 --count 100000

Spheres are pressed together by Widejam first (3,000 steps at a pressure of 1e-2); then both go on from that
packing under the same protocol, handed over by jam_app handoff. Start and end of the programs are taken off
by a run of one step. CPU times are of the processes, so that other work on the machine disturbs them little.
"""

import argparse
import os
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
SCENE = """
[sizes]
{sizes}
count = {count}
[protocol]
pressure = 1e-2
masses = "diameter"
[stop]
cundall = 1e-300
window = 1000
max_steps = 3000
[run]
threads = 1
record_interval = 1000
"""


def used(command, folder):
    """CPU seconds and peak memory in bytes of a command."""
    process = os.fork()
    if process == 0:
        os.chdir(folder)
        silence = os.open(os.devnull, os.O_WRONLY)
        os.dup2(silence, 1)
        os.environ["OMP_NUM_THREADS"] = "1"
        os.execvp(command[0], command)
    _, _, usage = os.wait4(process, 0)
    return usage.ru_utime + usage.ru_stime, 1024 * usage.ru_maxrss


def settings(steps):
    pairs = (f"stop.max_steps={steps}", f"stop.window={steps}", f"run.record_interval={steps}",
             "run.checkpoint_interval=1000000000")
    return [word for pair in pairs for word in ("--set", pair)]


def ours(jam_app, steps, folder):
    out = f"ours{steps}"
    return used([jam_app, "run", "further.toml", "--out", out, *settings(steps)], folder)


def theirs(jam_app, steps, folder):
    out = f"theirs{steps}"
    used([jam_app, "handoff", "dense/packing.h5", "-o", out, *settings(steps)], folder)
    return used(["lmp", "-in", "run.in", "-log", "none", "-screen", "none"], Path(folder) / out)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--programs", type=Path, default=ROOT / "build/release/bin")
    parser.add_argument("--size-ratio", type=float, default=10)
    parser.add_argument("--alpha", type=float, default=0.55)
    parser.add_argument("--count", type=int, default=100000)
    parser.add_argument("--steps", type=int, default=1000)
    given = parser.parse_args()
    sizes = ('kind = "monodisperse"' if given.size_ratio == 1 else
             f'kind = "power-law"\nsize_ratio = {given.size_ratio}\nalpha = {given.alpha}')
    jam_app = str(given.programs.resolve() / "jam_app")
    with tempfile.TemporaryDirectory() as folder:
        scene = SCENE.format(sizes=sizes, count=given.count)
        (Path(folder) / "dense.toml").write_text(scene)
        further = scene.replace(f"[sizes]\n{sizes}\ncount = {given.count}", '[start]\npacking = "dense/packing.h5"')
        (Path(folder) / "further.toml").write_text(further)
        used([jam_app, "run", "dense.toml", "--out", "dense"], folder)
        for name, program in (("Widejam", ours), ("LAMMPS", theirs)):
            whole, memory = program(jam_app, given.steps, folder)
            ends, _ = program(jam_app, 1, folder)
            each = (whole - ends) / (given.steps - 1) / given.count
            print(f"{name:<8} {1e6 * each:.3f} us of CPU a particle-step, {memory / given.count:.0f} bytes a particle")


if __name__ == "__main__":
    main()
