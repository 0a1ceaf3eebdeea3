// SPDX-License-Identifier: BSD-3-Clause
// Going on from a saved packing: with its own scene, or without its rattlers.
#pragma once

#include "jamming/scene.h"
#include "packing/packing.h"

#include <filesystem>
#include <span>
#include <string>

namespace jam {

/// The scene that goes on from a packing, saved as `path`: with contact, pressure, protocol and
/// criteria of the scene that is in its file. Where there is none, contact and pressure are the
/// packing's and the rest is by default. Overrides as for read_scene. Throws InputError and
/// FileError.
Scene scene_from_packing(const Packing& packing, const std::filesystem::path& path,
                         std::span<const std::string> overrides = {});

/// The same for one that is yet to be read.
Scene scene_from_packing(const std::filesystem::path& path,
                         std::span<const std::string> overrides = {});

/// The same packing without its rattlers (fewer than three contacts, found again until none is
/// left); everything else stands, ids included. Throws InputError if all are rattlers.
Packing without_rattlers(const Packing& packing);

/// Lets the quasi-static descent begin at its foot: what is jammed at the scene's pressure
/// converges again where it stands.
void begin_at_applied_pressure(Scene& scene);

}  // namespace jam
