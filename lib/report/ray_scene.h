// SPDX-License-Identifier: BSD-3-Clause
// Balls and tubes that rays can be shot at, through Embree.
#pragma once

#include "core/types.h"

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

namespace jam {

/// A ball in the single precision of the ray tracer; also the end of a tube.
struct Ball {
    float x, y, z, radius;

    Vec3 center() const { return {x, y, z}; }
};

struct Ray {
    Vec3 origin;
    Vec3 direction;  ///< unit length
    double begin = 0.0;
    double end = std::numeric_limits<double>::infinity();

    Vec3 at(double distance) const { return origin + distance * direction; }
};

struct RayHit {
    double distance;
    std::uint32_t object;  ///< place of the ball or tube
    Vec3 normal;           ///< unit length, outwards
};

/// What a ray hits does not depend on how many threads built the scene.
class RayScene {
  public:
    RayScene(RayScene&&) noexcept;
    ~RayScene();
    static RayScene of_balls(std::vector<Ball> balls);
    /// Round tubes; tube k runs from ends[2k] to ends[2k + 1].
    static RayScene of_tubes(std::vector<Ball> ends);

    /// The first surface on [begin, end] of the ray, seen from outside or inside.
    std::optional<RayHit> first_hit(const Ray& ray) const;
    bool is_blocked(const Ray& ray) const;
    /// The ball that `point` lies in; of several the one left first on the way `towards`.
    std::optional<std::uint32_t> ball_around(const Vec3& point, const Vec3& towards) const;

    const std::vector<Ball>& balls() const { return balls_; }

  private:
    struct Handles;
    RayScene(std::vector<Ball> balls, bool as_tubes);

    std::vector<Ball> balls_;
    float largest_diameter_;
    std::unique_ptr<Handles> handles_;
};

}  // namespace jam
