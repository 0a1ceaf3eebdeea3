// SPDX-License-Identifier: BSD-3-Clause
#include "report/visible_scene.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace jam {

namespace {

/// The thickness of an edge over the cube root of the cell's volume.
constexpr double edge_thickness = 0.0032;

/// Fractional coordinates kept: low <= s <= high along each edge.
struct FractionalBox {
    Vec3 low = Vec3::Zero();
    Vec3 high = Vec3::Ones();
};

FractionalBox kept_box(const PeriodicCell& cell, const SceneSettings& settings) {
    FractionalBox box;
    const Vec3 to_viewer = direction_to_viewer(settings.view);
    for (const Slice& slice : settings.slices) {
        const bool upper_side_seen = cell.inverse().row(slice.axis) * to_viewer > 0.0;
        double& bound = upper_side_seen ? box.high[slice.axis] : box.low[slice.axis];
        bound = slice.position;
    }
    return box;
}

/// The six faces of a box of fractional coordinates, or only those moved by a slice.
std::vector<HalfSpace> half_spaces(const PeriodicCell& cell, const FractionalBox& box,
                                   bool all_faces) {
    const Vec3 middle = Vec3::Constant(0.5);
    std::vector<HalfSpace> region;
    for (int axis = 0; axis < 3; ++axis) {
        const double width = cell.perpendicular_widths()[axis];
        const Vec3 normal = width * cell.inverse().row(axis).transpose();
        if (all_faces || box.high[axis] < 1.0)
            region.push_back({normal, width * (box.high[axis] - middle[axis])});
        if (all_faces || box.low[axis] > 0.0)
            region.push_back({-normal, -width * (box.low[axis] - middle[axis])});
    }
    return region;
}

Ball ball_at(const PeriodicCell& cell, const Vec3& fractional, double diameter) {
    const Vec3 x = cell.cartesian(fractional - Vec3::Constant(0.5));
    return {static_cast<float>(x.x()), static_cast<float>(x.y()), static_cast<float>(x.z()),
            static_cast<float>(0.5 * diameter)};
}

/// Calls visit(s + image) for every image of a sphere that reaches into the box.
template <typename Visit>
void for_each_image_inside(const Vec3& s, const Vec3& reach, const FractionalBox& box,
                           Visit&& visit) {
    const Vec3 first = (box.low - s - reach).array().ceil();
    const Vec3 last = (box.high - s + reach).array().floor();
    for (double a = first.x(); a <= last.x(); a += 1.0)
        for (double b = first.y(); b <= last.y(); b += 1.0)
            for (double c = first.z(); c <= last.z(); c += 1.0) visit(s + Vec3(a, b, c));
}

std::vector<Ball> edge_tubes(const PeriodicCell& cell, const FractionalBox& box) {
    const double diameter = edge_thickness * std::cbrt(cell.volume());
    const auto corner = [&](int which) {
        Vec3 s;
        for (int k = 0; k < 3; ++k) s[k] = ((which >> k) & 1) != 0 ? box.high[k] : box.low[k];
        return ball_at(cell, s, diameter);
    };
    std::vector<Ball> ends;
    for (int which = 0; which < 8; ++which)
        for (int k = 0; k < 3; ++k)
            if (((which >> k) & 1) == 0) {
                ends.push_back(corner(which));
                ends.push_back(corner(which | (1 << k)));
            }
    return ends;
}

}  // namespace

std::optional<ClippedRay> clipped(const std::vector<HalfSpace>& region, const Ray& ray) {
    ClippedRay result{ray, -1};
    for (std::size_t face = 0; face < region.size(); ++face) {
        const double above = region[face].normal.dot(ray.origin) - region[face].offset;
        const double slope = region[face].normal.dot(ray.direction);
        if (slope == 0.0 && above > 0.0) return std::nullopt;
        const double crossing = -above / slope;
        if (slope < 0.0 && crossing > result.ray.begin) {
            result.ray.begin = crossing;
            result.entry_face = static_cast<int>(face);
        }
        if (slope > 0.0) result.ray.end = std::min(result.ray.end, crossing);
    }
    if (result.ray.begin >= result.ray.end) return std::nullopt;
    return result;
}

VisibleScene visible_scene(const Packing& packing, const std::vector<std::uint8_t>& hidden,
                           const SceneSettings& settings) {
    const PeriodicCell& cell = packing.cell;
    const FractionalBox box = kept_box(cell, settings);
    std::vector<Ball> balls;
    std::vector<Index> sphere_of_ball;
    for (std::size_t i = 0; i < packing.positions.size(); ++i) {
        if (!hidden.empty() && hidden[i] != 0) continue;
        const double diameter = packing.diameters[i];
        const Vec3 s = wrapped(cell.fractional(packing.positions[i]));
        const auto add = [&](const Vec3& image) {
            balls.push_back(ball_at(cell, image, diameter));
            sphere_of_ball.push_back(static_cast<Index>(i));
        };
        const Vec3 reach = 0.5 * diameter * cell.perpendicular_widths().cwiseInverse();
        if (settings.cut_at_faces)
            for_each_image_inside(s, reach, box, add);
        else if (((s + reach).array() > box.low.array()).all() &&
                 ((s - reach).array() < box.high.array()).all())
            add(s);
    }
    const std::vector<Ball> edges = edge_tubes(cell, box);
    std::vector<Ball> outline;
    if (settings.cell_edges || settings.cut_at_faces) outline = edges;
    if (!settings.cut_at_faces) outline.insert(outline.end(), balls.begin(), balls.end());
    return {half_spaces(cell, box, settings.cut_at_faces), RayScene::of_balls(std::move(balls)),
            std::move(sphere_of_ball),
            RayScene::of_tubes(settings.cell_edges ? edges : std::vector<Ball>{}),
            std::move(outline)};
}

std::optional<Surface> first_sphere(const VisibleScene& scene, const Ray& ray) {
    const auto inside = clipped(scene.region, ray);
    if (!inside) return std::nullopt;
    const auto surface_of = [&](std::uint32_t ball, const Vec3& point, const Vec3& normal) {
        return Surface{point, normal, scene.sphere_of_ball[ball],
                       2.0 * scene.balls.balls()[ball].radius};
    };
    if (inside->entry_face >= 0) {
        const Vec3 entry = ray.at(inside->ray.begin);
        if (const auto cut = scene.balls.ball_around(entry, ray.direction))
            return surface_of(*cut, entry, scene.region[inside->entry_face].normal);
    }
    const auto hit = scene.balls.first_hit(inside->ray);
    if (!hit) return std::nullopt;
    return surface_of(hit->object, ray.at(hit->distance), hit->normal);
}

std::optional<Surface> first_surface(const VisibleScene& scene, const Ray& ray) {
    std::optional<Surface> sphere = first_sphere(scene, ray);
    Ray to_edges = ray;
    if (sphere) to_edges.end = (sphere->point - ray.origin).norm();
    const auto edge = scene.edges.first_hit(to_edges);
    if (!edge) return sphere;
    return Surface{ray.at(edge->distance), edge->normal, -1,
                   2.0 * scene.edges.balls().front().radius};
}

bool is_blocked(const VisibleScene& scene, const Ray& ray) {
    const auto inside = clipped(scene.region, ray);
    return inside && scene.balls.is_blocked(inside->ray);
}

}  // namespace jam
