// SPDX-License-Identifier: BSD-3-Clause
// A report as a folder: report.html, which needs nothing else, and beside it every figure as SVG
// and PNG, every table as CSV and every script.
#pragma once

#include "report/html_report.h"

#include <filesystem>
#include <functional>
#include <optional>
#include <string_view>

namespace jam {

struct ReportSettings {
    std::function<void(std::string_view)> on_stage = {};  ///< told what comes next, or empty
    int rattler_threshold = default_rattler_threshold;
    /// Of one packing with at most so many particles in the backbone stability and moduli are
    /// found; time grows with the square of the number, to some five seconds.
    Count most_for_elasticity = 4000;
    int picture_width = 1280;  ///< of the one picture; its height is three quarters of it
    int gallery_width = 420;   ///< of each of many
    int samples = 32;          ///< rays a pixel
};

struct WrittenReport {
    std::filesystem::path page;
    Drawing drawing;
};

/// The report of one packing. `sizes`: what it was made from, where that is known; `history`: from
/// read_run_history, or empty. Throws InputError for a packing that cannot be measured, FileError
/// for a folder that cannot be written.
WrittenReport write_packing_report(const Packing& packing, const std::string& name,
                                   const std::optional<SizeDistribution>& sizes,
                                   const Table& history, const std::filesystem::path& folder,
                                   const ReportSettings& settings = {});

/// The report of many packings, taken in one at a time.
class PackingCollection {
  public:
    explicit PackingCollection(const ReportSettings& settings) : settings_(settings) {}

    /// Measures the packing; draws a picture of it if it is the first with its sizes.
    void add(const Packing& packing, const std::string& name,
             const std::optional<SizeDistribution>& sizes);

    WrittenReport write(const std::filesystem::path& folder) const;

  private:
    ReportSettings settings_;
    std::vector<NamedMeasurements> packings_;
    std::vector<PageImage> pictures_;
};

}  // namespace jam
