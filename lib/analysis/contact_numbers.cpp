// SPDX-License-Identifier: BSD-3-Clause
#include "analysis/contact_numbers.h"

#include <algorithm>
#include <limits>

namespace jam {

namespace {

/// Sum of weight(c) n_c over low <= c <= high.
template <typename Weight>
double sum_over(const ContactNumbers& numbers, int low, int high, Weight&& weight) {
    double sum = 0.0;
    const int last = std::min(high, static_cast<int>(numbers.particle_counts.size()) - 1);
    for (int c = std::max(low, 0); c <= last; ++c)
        sum += weight(c) * static_cast<double>(numbers.particle_counts[c]);
    return sum;
}

template <typename Weight>
double share(const ContactNumbers& numbers, int low, int high, Weight&& weight) {
    const double all = sum_over(numbers, 0, std::numeric_limits<int>::max(), weight);
    return all > 0.0 ? sum_over(numbers, low, high, weight) / all : 0.0;
}

}  // namespace

double ContactNumbers::share_of_particles(int low, int high) const {
    return share(*this, low, high, [](int) { return 1.0; });
}

double ContactNumbers::share_of_contacts(int low, int high) const {
    return share(*this, low, high, [](int c) { return static_cast<double>(c); });
}

ContactNumbers contact_numbers(const Rattlers& rattlers) {
    ContactNumbers numbers;
    for (std::size_t i = 0; i < rattlers.is_rattler.size(); ++i) {
        if (rattlers.is_rattler[i] != 0) continue;
        const auto c = static_cast<std::size_t>(rattlers.contact_counts_nr[i]);
        if (c >= numbers.particle_counts.size()) numbers.particle_counts.resize(c + 1, 0);
        ++numbers.particle_counts[c];
    }
    return numbers;
}

Table table(const ContactNumbers& numbers) {
    Table result{{{"contacts", {}}, {"particles", {}}, {"fraction", {}}}};
    for (int c = 0; c < static_cast<int>(numbers.particle_counts.size()); ++c) {
        result.columns[0].values.push_back(c);
        result.columns[1].values.push_back(static_cast<double>(numbers.particle_counts[c]));
        result.columns[2].values.push_back(numbers.share_of_particles(c, c));
    }
    return result;
}

}  // namespace jam
