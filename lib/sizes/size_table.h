// SPDX-License-Identifier: BSD-3-Clause
// Size distributions from numbers: a list of diameters or a cumulative curve, given or in a file.
#pragma once

#include "sizes/size_distribution.h"

#include <filesystem>
#include <vector>

namespace jam {

/// The distribution of these diameters, in any order. Throws InputError unless there is at least
/// one and all are finite and above zero.
DiameterList diameter_list(std::vector<double> diameters);

/// The distribution with these cumulative fractions (`given`: of number or of volume) at these
/// diameters. Throws InputError unless both have the same length, at least 2, diameters are above
/// zero and ascend, and fractions never fall, begin with 0 and end with 1 (neither repeated).
CumulativeCurve cumulative_curve(std::vector<double> diameters, std::vector<double> fractions,
                                 Weight given);

/// Reads a CSV file (numbers separated by commas, semicolons, spaces or tabs; `#` begins a comment;
/// one heading line is allowed): one column of diameters makes a DiameterList, two columns
/// (diameter, cumulative fraction of `given`) a CumulativeCurve. Throws FileError if the file
/// cannot be read, InputError with file and line if its content cannot be used.
SizeDistribution read_size_table(const std::filesystem::path& path, Weight given = Weight::volume);

}  // namespace jam
