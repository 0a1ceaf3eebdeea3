// SPDX-License-Identifier: BSD-3-Clause
// Runs jam_app on a scene as a user does, and looks through everything that it leaves.
#pragma once

#include "packing/packing.h"
#include "support/scratch_folder.h"

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace jam::test {

/// One run of jam_app, and the statistics of its packing by analyze_app.
struct JammingRun {
    int status = -1;
    std::string said;          ///< standard output and standard error
    bool left_files = false;   ///< the run folder exists
    std::string not_a_number;  ///< first file with a nan or an infinity in it; "" as it has to be

    // Of the packing; NaN where none was saved.
    double volume_fraction;
    double mean_pressure;
    double cundall;
    double coordination_nr;
    double excess_contacts;  ///< of the backbone against isostatic
};

class JammingRuns {
  public:
    /// `text` is a scene; `sets` are passed as --set. Each run has a folder of its own.
    JammingRun operator()(const std::string& text, const std::vector<std::string>& sets = {});

    /// A CSV packing of one diameter a sphere, to be named in start.packing.
    std::filesystem::path write_packing(const Packing& packing);

  private:
    std::string fresh_name();

    ScratchFolder folder_;
    int count_ = 0;
};

/// 60 spheres in a narrow power law: what most of these tests jam.
inline const std::string few_spheres =
    "[sizes]\nkind = \"power-law\"\nalpha = 0.55\nsize_ratio = 2\ncount = 60\n";

/// The same number of equal spheres.
inline const std::string equal_spheres = "[sizes]\nkind = \"monodisperse\"\ncount = 60\n";

/// A scene that starts from a saved packing.
std::string scene_from(const std::filesystem::path& packing);

/// Expects a run that converged, with the applied pressure and in balance, and no NaN anywhere.
void expect_jammed(const JammingRun& run, double applied_pressure);

/// Expects exit status 2, no NaN in what was left, and every one of `words` in what was said.
void expect_refused(const JammingRun& run, const std::vector<std::string>& words);

}  // namespace jam::test
