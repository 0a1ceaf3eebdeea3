// SPDX-License-Identifier: BSD-3-Clause
// A scene handed over to LAMMPS: everything that is needed to jam it there, on many machines.
#pragma once

#include "jamming/scene.h"

#include <filesystem>
#include <string>

namespace jam {

/// The start of the scene and its protocol, for LAMMPS (29 Sep 2021 or later, package GRANULAR),
/// into `folder`, which is made where it is missing:
///   start.data  the spheres as `jam_app run` would begin with them, at rest
///   system.in   spheres, contact law, neighbor lists, time step: to be included by input scripts
///   run.in      the protocol: barostat, records, restart files, criteria; ends with final.dump
///   job.slurm   a job script that begins, and goes on from the latest restart file
///   back.toml   the scene that takes final.dump back
/// Throws InputError if the folder holds one of them, or if the scene gives no start, and
/// FileError.
void write_handoff(const Scene& scene, const std::filesystem::path& folder);

}  // namespace jam
