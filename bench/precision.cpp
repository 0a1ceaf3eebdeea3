// SPDX-License-Identifier: BSD-3-Clause
#include "precision.h"

#include <array>
#include <cmath>
#include <cstdint>

namespace jam::bench {

namespace {

__extension__ using Wide = __int128;

/// A pair as every representation gets it: fractional centers, the image, diameters.
struct Pair {
    const Mat3& h;
    const Sphere& first;
    const Sphere& second;
    const ImageShift& shift;
};

/// Overlap in arithmetic of one type from Cartesian differences.
template <typename Real>
Real overlap_of(Real x, Real y, Real z, const Pair& pair) {
    const Real reach = Real(0.5) * (static_cast<Real>(pair.first.diameter) +
                                    static_cast<Real>(pair.second.diameter));
    return reach - std::sqrt(x * x + y * y + z * z);
}

template <typename Real>
Real overlap_of_fractions(Real sx, Real sy, Real sz, const Pair& pair) {
    const auto h = [&](int i, int j) { return static_cast<Real>(pair.h(i, j)); };
    return overlap_of<Real>(h(0, 0) * sx + h(0, 1) * sy + h(0, 2) * sz, h(1, 1) * sy + h(1, 2) * sz,
                            h(2, 2) * sz, pair);
}

template <typename Real>
double in_one_type(const Pair& pair) {
    const auto apart = [&](int k, double shift) {
        return static_cast<Real>(pair.first.center[k]) - static_cast<Real>(pair.second.center[k]) -
               static_cast<Real>(shift);
    };
    return static_cast<double>(overlap_of_fractions<Real>(
        apart(0, pair.shift.x), apart(1, pair.shift.y), apart(2, pair.shift.z), pair));
}

long double truth(const Pair& pair) {
    const auto apart = [&](int k, double shift) {
        return static_cast<long double>(pair.first.center[k]) - pair.second.center[k] - shift;
    };
    return overlap_of_fractions<long double>(apart(0, pair.shift.x), apart(1, pair.shift.y),
                                             apart(2, pair.shift.z), pair);
}

/// Cartesian positions rounded to float, differences and distance in float.
double float_positions(const Pair& pair) {
    const Vec3 shift(pair.shift.x, pair.shift.y, pair.shift.z);
    const Eigen::Vector3f first = (pair.h * pair.first.center).cast<float>();
    const Eigen::Vector3f second = (pair.h * pair.second.center).cast<float>();
    const Eigen::Vector3f apart = first - second - (pair.h * shift).cast<float>();
    return overlap_of<float>(apart[0], apart[1], apart[2], pair);
}

/// Positions relative to the corner of a bin, two smallest diameters wide, in float; the bins'
/// distance is exact to float.
double bin_relative_float(const Pair& pair) {
    const double bin = 2.0;
    const auto split = [&](const Vec3& place, Vec3& corner) {
        corner = bin * (place / bin).array().floor().matrix();
        return Eigen::Vector3f((place - corner).cast<float>());
    };
    Vec3 corner_first, corner_second;
    const Vec3 shift(pair.shift.x, pair.shift.y, pair.shift.z);
    const Eigen::Vector3f first = split(pair.h * pair.first.center, corner_first);
    const Eigen::Vector3f second = split(pair.h * (pair.second.center + shift), corner_second);
    const Eigen::Vector3f apart =
        first - second + Eigen::Vector3f((corner_first - corner_second).cast<float>());
    return overlap_of<float>(apart[0], apart[1], apart[2], pair);
}

/// Differences in double, rounded; the distance in float.
double difference_to_float(const Pair& pair) {
    const Vec3 shift(pair.shift.x, pair.shift.y, pair.shift.z);
    const Vec3 apart = pair.h * (pair.first.center - pair.second.center - shift);
    return overlap_of<float>(static_cast<float>(apart[0]), static_cast<float>(apart[1]),
                             static_cast<float>(apart[2]), pair);
}

/// Fractions of the cell as whole numbers of so many bits, whose wrap-around is the periodic image;
/// distance in double.
template <typename Signed, int bits>
double fixed_point(const Pair& pair) {
    using Unsigned = std::make_unsigned_t<Signed>;
    const std::array<double, 3> shift{pair.shift.x, pair.shift.y, pair.shift.z};
    std::array<double, 3> apart{};
    for (int k = 0; k < 3; ++k) {
        const auto fixed = [&](double fraction) {
            return static_cast<Unsigned>(
                static_cast<Wide>(std::ldexp(static_cast<long double>(fraction), bits)));
        };
        const double nearest = std::ldexp(
            static_cast<double>(static_cast<Signed>(
                static_cast<Unsigned>(fixed(pair.first.center[k]) - fixed(pair.second.center[k])))),
            -bits);
        // Not always the nearest image in a small cell: whole cells are added back.
        const double exact =
            pair.first.center[k] - pair.second.center[k] - shift[static_cast<std::size_t>(k)];
        apart[static_cast<std::size_t>(k)] = nearest + std::round(exact - nearest);
    }
    return overlap_of_fractions<double>(apart[0], apart[1], apart[2], pair);
}

struct Representation {
    const char* name;
    double (*overlap)(const Pair&);
};
constexpr std::array<Representation, 6> representations{{
    {"float32 positions", float_positions},
    {"float32 relative to a bin", bin_relative_float},
    {"double difference, float32 distance", difference_to_float},
    {"int32 of the cell, double distance", fixed_point<std::int32_t, 32>},
    {"int64 of the cell, double distance", fixed_point<std::int64_t, 64>},
    {"double", in_one_type<double>},
}};

}  // namespace

std::vector<PrecisionError> precision_errors(const PeriodicCell& cell, const Particles& particles,
                                             const NeighborList& pairs, double scale) {
    std::vector<PrecisionError> errors;
    for (const Representation& one : representations) {
        PrecisionError error;
        error.representation = one.name;
        long double squared_error = 0.0L;
        long double squared_force = 0.0L;
        for (Index i = 0; i < pairs.particle_count(); ++i) {
            for (const Neighbor neighbor : pairs.row(i)) {
                const Sphere& first = particles.spheres[static_cast<std::size_t>(i)];
                Sphere second = particles.spheres[static_cast<std::size_t>(neighbor.particle())];
                const Pair pair{cell.matrix(), first, second, image_shifts[neighbor.image()]};
                second.diameter -= 2.0 * (1.0 - scale) * static_cast<double>(truth(pair));
                const long double exact = truth(pair);
                const long double given = one.overlap(pair);
                const long double difference = std::max(given, 0.0L) - std::max(exact, 0.0L);
                squared_error += difference * difference;
                squared_force += exact > 0.0L ? exact * exact : 0.0L;
                error.contacts += exact > 0.0L ? 1 : 0;
                error.wrong_contacts += (exact > 0.0L) != (given > 0.0L) ? 1 : 0;
            }
        }
        error.force_error = std::sqrt(static_cast<double>(squared_error / squared_force));
        errors.push_back(error);
    }
    return errors;
}

}  // namespace jam::bench
