// SPDX-License-Identifier: BSD-3-Clause
// The power law nearest to a grain-size distribution, by which the two literatures are compared.
#pragma once

namespace jam {

/// The alpha whose cumulative volume fraction is nearest to [(D - 1)/(size_ratio - 1)]^eta, in the
/// sense of least squares over D, evenly from where the reduced diameter (D - 1)/(size_ratio - 1)
/// is `reduced_from` up to size_ratio. At size_ratio 32, eta 0.8, 0.6, 0.4 give 0.75, 0.47, 0.11
/// over all D, and 0.76, 0.50, 0.19 over the upper half, where Monti et al. find the two families
/// to behave alike. It is searched for between -10 and 10, more widely than `check` admits for a
/// scene. Throws InputError if an argument cannot be used, or size_ratio is 1, where all alpha are
/// the same.
double closest_alpha(double eta, double size_ratio, double reduced_from = 0.0);

}  // namespace jam
