// SPDX-License-Identifier: BSD-3-Clause
// What there is to see of a packing: its spheres (whole, or cut at the cell's faces or at a slice)
// and the edges of its cell.
#pragma once

#include "packing/packing.h"
#include "report/appearance.h"
#include "report/camera.h"
#include "report/ray_scene.h"

#include <optional>
#include <vector>

namespace jam {

/// A plane through the cell parallel to two of its edges: fractional coordinate `axis` (0, 1, 2)
/// equals `position`. What lies between it and the viewer is taken away.
struct Slice {
    int axis = 2;
    double position = 0.5;
};

struct SceneSettings {
    View view;
    std::vector<Slice> slices;
    /// true: spheres are cut where they cross the cell's faces, and the pieces that reach in from
    /// the other side are there. false: every sphere is whole, its center inside the cell.
    bool cut_at_faces = false;
    bool cell_edges = true;
};

/// Points x with normal . x <= offset.
struct HalfSpace {
    Vec3 normal;  ///< unit length
    double offset;
};

/// The part of a ray inside all half-spaces. `entry_face`: the half-space through whose plane the
/// ray comes in, or -1 if it begins inside.
struct ClippedRay {
    Ray ray;
    int entry_face = -1;
};
std::optional<ClippedRay> clipped(const std::vector<HalfSpace>& region, const Ray& ray);

/// Lengths are those of the packing, the middle of the cell is the origin.
struct VisibleScene {
    std::vector<HalfSpace> region;  ///< spheres are seen inside it only
    RayScene balls;
    std::vector<Index> sphere_of_ball;
    RayScene edges;
    std::vector<Ball> outline;  ///< all of it lies within these
};
VisibleScene visible_scene(const Packing& packing, const std::vector<std::uint8_t>& hidden,
                           const SceneSettings& settings);

/// The point where a ray ends.
struct Surface {
    Vec3 point;
    Vec3 normal;
    std::int64_t sphere;  ///< -1: an edge of the cell
    double size;          ///< diameter of what was hit
};
std::optional<Surface> first_surface(const VisibleScene& scene, const Ray& ray);

/// The same with nothing but spheres there: the thin edges throw no light and no shadow.
std::optional<Surface> first_sphere(const VisibleScene& scene, const Ray& ray);
bool is_blocked(const VisibleScene& scene, const Ray& ray);

}  // namespace jam
