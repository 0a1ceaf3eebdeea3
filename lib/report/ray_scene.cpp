// SPDX-License-Identifier: BSD-3-Clause
#include "report/ray_scene.h"

#include "core/check.h"

#include <embree3/rtcore.h>

#include <algorithm>

namespace jam {

struct RayScene::Handles {
    RTCDevice device = nullptr;
    RTCScene scene = nullptr;

    Handles() = default;
    Handles(const Handles&) = delete;
    Handles& operator=(const Handles&) = delete;
    ~Handles() {
        if (scene != nullptr) rtcReleaseScene(scene);
        if (device != nullptr) rtcReleaseDevice(device);
    }
};

namespace {

void share_balls(RTCGeometry geometry, const std::vector<Ball>& balls) {
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4, balls.data(),
                               0, sizeof(Ball), balls.size());
}

void number_tubes(RTCGeometry geometry, std::size_t count) {
    auto* first_ends = static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT, sizeof(std::uint32_t), count));
    for (std::size_t k = 0; k < count; ++k) first_ends[k] = static_cast<std::uint32_t>(2 * k);
}

RTCRay embree_ray(const Ray& ray) {
    RTCRay result{};
    result.org_x = static_cast<float>(ray.origin.x());
    result.org_y = static_cast<float>(ray.origin.y());
    result.org_z = static_cast<float>(ray.origin.z());
    result.dir_x = static_cast<float>(ray.direction.x());
    result.dir_y = static_cast<float>(ray.direction.y());
    result.dir_z = static_cast<float>(ray.direction.z());
    result.tnear = static_cast<float>(ray.begin);
    result.tfar = static_cast<float>(ray.end);
    result.mask = ~0U;
    return result;
}

/// Only the balls around the ray's beginning count.
struct AroundOrigin {
    RTCIntersectContext context;  // first, so that Embree's pointer to it is a pointer to this
    const std::vector<Ball>* balls;
};

void refuse_balls_elsewhere(const RTCFilterFunctionNArguments* arguments) {
    const auto& query = *reinterpret_cast<const AroundOrigin*>(arguments->context);
    const auto& ray = *reinterpret_cast<const RTCRay*>(arguments->ray);
    const auto& hit = *reinterpret_cast<const RTCHit*>(arguments->hit);
    const Ball& ball = (*query.balls)[hit.primID];
    const Vec3 beginning(ray.org_x, ray.org_y, ray.org_z);
    if ((beginning - ball.center()).norm() > ball.radius) arguments->valid[0] = 0;
}

float largest_diameter(const std::vector<Ball>& balls) {
    float diameter = 0.0F;
    for (const Ball& ball : balls) diameter = std::max(diameter, 2.0F * ball.radius);
    return diameter;
}

}  // namespace

RayScene::RayScene(RayScene&&) noexcept = default;
RayScene::~RayScene() = default;

RayScene::RayScene(std::vector<Ball> balls, bool as_tubes)
    : balls_(std::move(balls)),
      largest_diameter_(largest_diameter(balls_)),
      handles_(std::make_unique<Handles>()) {
    handles_->device = rtcNewDevice(nullptr);
    if (handles_->device == nullptr)
        throw FileError(
            "the ray tracer (Embree) cannot start on this processor; pictures need one "
            "of the x86-64 or ARM family");
    handles_->scene = rtcNewScene(handles_->device);
    // Robust: a ray's answer must not depend on how the tree over the balls happened to be built.
    rtcSetSceneFlags(
        handles_->scene,
        static_cast<RTCSceneFlags>(RTC_SCENE_FLAG_ROBUST | RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION));
    RTCGeometry geometry =
        rtcNewGeometry(handles_->device, as_tubes ? RTC_GEOMETRY_TYPE_ROUND_LINEAR_CURVE
                                                  : RTC_GEOMETRY_TYPE_SPHERE_POINT);
    share_balls(geometry, balls_);
    if (as_tubes) number_tubes(geometry, balls_.size() / 2);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(handles_->scene, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(handles_->scene);
    if (rtcGetDeviceError(handles_->device) != RTC_ERROR_NONE)
        throw FileError(
            "the ray tracer (Embree) cannot take in the spheres; is there memory left?");
}

RayScene RayScene::of_balls(std::vector<Ball> balls) {
    return RayScene(std::move(balls), false);
}

RayScene RayScene::of_tubes(std::vector<Ball> ends) {
    return RayScene(std::move(ends), true);
}

std::optional<RayHit> RayScene::first_hit(const Ray& ray) const {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRayHit query{embree_ray(ray), {}};
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(handles_->scene, &context, &query);
    if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
    const Vec3 normal(query.hit.Ng_x, query.hit.Ng_y, query.hit.Ng_z);
    return RayHit{query.ray.tfar, query.hit.primID, normal.normalized()};
}

bool RayScene::is_blocked(const Ray& ray) const {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRay query = embree_ray(ray);
    rtcOccluded1(handles_->scene, &context, &query);
    return query.tfar < 0.0F;
}

std::optional<std::uint32_t> RayScene::ball_around(const Vec3& point, const Vec3& towards) const {
    AroundOrigin around;
    rtcInitIntersectContext(&around.context);
    around.context.filter = refuse_balls_elsewhere;
    around.balls = &balls_;
    RTCRayHit query{embree_ray({point, towards, 0.0, largest_diameter_}), {}};
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(handles_->scene, &around.context, &query);
    if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
    return query.hit.primID;
}

}  // namespace jam
