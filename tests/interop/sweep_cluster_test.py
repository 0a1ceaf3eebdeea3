# SPDX-License-Identifier: BSD-3-Clause
"""The sweep of docs/examples/sweep by its two ways onto a cluster: the first tasks of the job array, as Slurm
would run them, then Snakemake for the rest, which leaves alone what has converged.  PROGRAMS EXAMPLE FOLDER"""

import os
import shutil
import subprocess
import sys

from reference import SKIPPED


def done(command, **environment):
    ended = subprocess.run(command, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                           env={**os.environ, **environment})
    if ended.returncode != 0:
        sys.exit(f"{' '.join(command)}: exit status {ended.returncode}\n{ended.stdout[-3000:]}")
    return ended.stdout


def written(name):
    return os.stat(f"runs/many/{name}/packing.h5").st_mtime_ns


def main():
    programs, example, folder = sys.argv[1:4]
    shutil.rmtree(folder, ignore_errors=True)
    shutil.copytree(example, folder)
    os.chdir(folder)
    os.environ["PATH"] = programs + os.pathsep + os.environ["PATH"]
    for task in ("1", "2", "2"):  # the second one twice: nothing is left of it
        said = done(["bash", "array.slurm", "many.toml"], SLURM_ARRAY_TASK_ID=task, LAUNCH="")
    assert "has converged already" in said, said
    names = sorted(os.listdir("runs/many"))
    assert names == ["size_ratio=1.5_alpha=0.3_seed=1", "size_ratio=1.5_alpha=0.3_seed=2"], names
    before = [written(name) for name in names]
    if shutil.which("snakemake") is None:
        print("skipped: no Snakemake; scripts/install_dependencies.sh --interop installs it")
        sys.exit(SKIPPED)
    done(["snakemake", "--cores", "2", "--config", "sweep=many.toml"])
    assert len([name for name in os.listdir("runs/many") if os.path.exists(f"runs/many/{name}/converged")]) == 8
    assert [written(name) for name in names] == before
    assert "Nothing to be done" in done(["snakemake", "--cores", "2", "--config", "sweep=many.toml"])


if __name__ == "__main__":
    main()
