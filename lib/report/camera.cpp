// SPDX-License-Identifier: BSD-3-Clause
#include "report/camera.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace jam {

namespace {

// A long lens: parallel edges stay nearly parallel, and the picture still has depth.
constexpr double half_height_at_distance_one = 0.11;

double radians(double degrees) {
    return degrees * std::numbers::pi / 180.0;
}

/// How far the balls reach across a line of sight at slope `tangent`, seen along `across`: the
/// largest of (across + tangent backward) . center plus the radius seen at that slope.
double reach(std::span<const Ball> balls, const Vec3& across, const Vec3& backward,
             double tangent) {
    const Vec3 plane = across + tangent * backward;
    const double slant = plane.norm();
    double furthest = -std::numeric_limits<double>::infinity();
    for (const Ball& ball : balls)
        furthest = std::max(furthest, plane.dot(ball.center()) + slant * ball.radius);
    return furthest;
}

}  // namespace

Ray Camera::ray_through(double x, double y) const {
    const Vec3 direction = 2.0 * half_height * (x * right + y * up) - backward;
    return {eye, direction.normalized()};
}

Vec3 direction_to_viewer(const View& view) {
    const double azimuth = radians(view.azimuth);
    const double elevation = radians(view.elevation);
    return {std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth),
            std::sin(elevation)};
}

Camera frame(std::span<const Ball> balls, const View& view, double aspect) {
    const double azimuth = radians(view.azimuth);
    Camera camera;
    camera.backward = direction_to_viewer(view);
    camera.right = Vec3(-std::sin(azimuth), std::cos(azimuth), 0.0);
    camera.up = camera.backward.cross(camera.right);
    camera.half_height = half_height_at_distance_one;
    // A ball stays inside the right edge of the picture if its reach there is at most the eye's
    // own, across + tangent * distance; the same on the left. The two added up give the distance.
    const double tan_y = camera.half_height;
    const double tan_x = aspect * camera.half_height;
    const double to_right = reach(balls, camera.right, camera.backward, tan_x);
    const double to_left = reach(balls, -camera.right, camera.backward, tan_x);
    const double to_top = reach(balls, camera.up, camera.backward, tan_y);
    const double to_bottom = reach(balls, -camera.up, camera.backward, tan_y);
    const double distance =
        std::max((to_right + to_left) / (2.0 * tan_x), (to_top + to_bottom) / (2.0 * tan_y));
    camera.eye = distance * camera.backward + 0.5 * (to_right - to_left) * camera.right +
                 0.5 * (to_top - to_bottom) * camera.up;
    return camera;
}

}  // namespace jam
