// SPDX-License-Identifier: BSD-3-Clause
#include "analysis/unheld.h"

#include "core/parallel.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace jam {

namespace {

constexpr double plane_tolerance = 1e-8;

/// Two unit vectors that are normal to `axis` and to each other.
std::pair<Vec3, Vec3> plane_of(const Vec3& axis) {
    Eigen::Index least = 0;
    axis.cwiseAbs().minCoeff(&least);
    const Vec3 u = axis.cross(Vec3::Unit(least)).normalized();
    return {u, axis.cross(u)};
}

/// Whether a half-space whose boundary holds `axis` holds all directions: seen along the axis, they
/// leave a gap of half a turn.
bool half_space_along(const Vec3& axis, std::span<const Vec3> directions,
                      std::vector<double>& angles) {
    const auto [u, v] = plane_of(axis);
    angles.clear();
    for (const Vec3& direction : directions) {
        const double x = u.dot(direction);
        const double y = v.dot(direction);
        if (x * x + y * y > plane_tolerance * plane_tolerance) angles.push_back(std::atan2(y, x));
    }
    if (angles.empty()) return true;
    std::sort(angles.begin(), angles.end());
    double gap = angles.front() + 2.0 * std::numbers::pi - angles.back();
    for (std::size_t k = 1; k < angles.size(); ++k) gap = std::max(gap, angles[k] - angles[k - 1]);
    return gap >= std::numbers::pi - plane_tolerance;
}

/// A half-space that holds all can be turned until its boundary holds one of them: trying each is
/// enough.
bool within_half_space_exhaustive(std::span<const Vec3> directions) {
    std::vector<double> angles;
    return std::any_of(directions.begin(), directions.end(), [&](const Vec3& axis) {
        return half_space_along(axis, directions, angles);
    });
}

/// The directions that reach farthest towards the faces, edges and corners of a cube. If even these
/// few lie in no half-space, the whole set does not.
std::vector<Vec3> outermost(std::span<const Vec3> directions) {
    std::vector<Vec3> result;
    for (int code = 0; code < 27; ++code) {
        const Eigen::Vector3i corner(code % 3 - 1, code / 3 % 3 - 1, code / 9 - 1);
        const Vec3 towards = corner.cast<double>();
        result.push_back(*std::max_element(
            directions.begin(), directions.end(),
            [&](const Vec3& a, const Vec3& b) { return towards.dot(a) < towards.dot(b); }));
    }
    return result;
}

/// Whether particle i, its contacts with those removed left out, is not held.
bool unheld(std::span<const Contact> contacts, const ContactRows& rows,
            const std::vector<std::uint8_t>& removed, Index i) {
    if (rows.contact_count(i) < 4) return true;
    std::vector<Vec3> directions;
    for (const ContactEnd end : rows.row(i))
        if (removed[end.partner(contacts)] == 0)
            directions.push_back(end.sign() * contacts[end.contact()].normal);
    return within_half_space(directions);
}

std::vector<Index> unheld_among(const std::vector<Index>& doubtful,
                                std::span<const Contact> contacts, const ContactRows& rows,
                                const std::vector<std::uint8_t>& removed) {
    std::vector<std::uint8_t> falls(doubtful.size());
    for_each_block(static_cast<Count>(doubtful.size()), 256, [&](Count, Count begin, Count end) {
        for (Count k = begin; k < end; ++k)
            falls[k] = unheld(contacts, rows, removed, doubtful[k]) ? 1 : 0;
    });
    std::vector<Index> fallen;
    for (std::size_t k = 0; k < doubtful.size(); ++k)
        if (falls[k] != 0) fallen.push_back(doubtful[k]);
    return fallen;
}

/// Who stood against one of the fallen and still stands, each once: a large particle loses many
/// partners in one round and is tested once.
std::vector<Index> partners_left(const std::vector<Index>& fallen,
                                 std::span<const Contact> contacts, const ContactRows& rows,
                                 const std::vector<std::uint8_t>& removed) {
    std::vector<Index> partners;
    for (const Index i : fallen)
        for (const ContactEnd end : rows.row(i))
            if (removed[end.partner(contacts)] == 0) partners.push_back(end.partner(contacts));
    std::sort(partners.begin(), partners.end());
    partners.erase(std::unique(partners.begin(), partners.end()), partners.end());
    return partners;
}

}  // namespace

bool within_half_space(std::span<const Vec3> directions) {
    constexpr std::size_t many = 32;
    if (directions.size() < 4) return true;
    if (directions.size() > many && !within_half_space_exhaustive(outermost(directions)))
        return false;
    return within_half_space_exhaustive(directions);
}

Rattlers find_unheld(std::span<const Contact> contacts, const ContactRows& rows) {
    Rattlers result;
    result.is_rattler.assign(rows.particle_count(), 0);
    std::vector<Index> doubtful(rows.particle_count());
    std::iota(doubtful.begin(), doubtful.end(), 0);
    while (!doubtful.empty()) {
        const std::vector<Index> fallen = unheld_among(doubtful, contacts, rows, result.is_rattler);
        for (const Index i : fallen) result.is_rattler[i] = 1;
        doubtful = partners_left(fallen, contacts, rows, result.is_rattler);
    }
    count_backbone(contacts, rows, result);
    return result;
}

}  // namespace jam
