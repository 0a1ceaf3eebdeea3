// SPDX-License-Identifier: BSD-3-Clause
// Whether a packing is jammed, and by which criteria.
#pragma once

#include <string>
#include <vector>

namespace jam {

/// One criterion by the name of its tolerance in the scene's table [stop].
struct Criterion {
    std::string name;
    double value = 0.0;  ///< NaN while it is not known (a window that is not yet full)
    double tolerance = 0.0;
    bool holds = false;
};

struct Verdict {
    std::vector<Criterion> criteria;

    /// All criteria hold, and there is at least one.
    bool converged() const;
};

/// {"converged": bool, "criteria": [{"name", "value", "tolerance", "holds"}, ...]}; an unknown
/// value is null.
std::string to_json(const Verdict& verdict);

/// The reverse of to_json. Throws InputError if the text is not a verdict.
Verdict verdict_from_json(const std::string& text);

/// A line for each criterion, to be read by people, indented by two spaces and ended by '\n'.
std::string to_text(const Verdict& verdict);

}  // namespace jam
