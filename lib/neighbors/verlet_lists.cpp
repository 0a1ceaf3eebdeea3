// SPDX-License-Identifier: BSD-3-Clause
#include "neighbors/verlet_lists.h"

#include "grids/collection_choice.h"

#include <algorithm>
#include <limits>

namespace jam {

namespace {

/// Tiles are kept that have at least half of their reach left when it is measured.
constexpr double worth_keeping = 2.0;

void take_reference(const PeriodicCell& cell, const InteractionReach& reach,
                    const Particles& particles, ListReference& reference) {
    reference.cell = cell;
    reference.reach = reach;
    reference.centers.resize(particles.spheres.size());
    for_each_block(particles.size(), 4096, [&](Count, Count begin, Count end) {
        for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
            reference.centers[i] = particles.spheres[i].center;
    });
}

/// Reach that outlasts the next `inner_steps` steps, and no wider than the candidates'.
InteractionReach inner_reach(const VerletLists& lists, const StepMotion& motion) {
    const double steps = lists.settings.inner_steps;
    constexpr double rounding = 1e-12;
    return {std::min(lists.outer.reach.strain_margin, steps * motion.strain + rounding),
            std::min(lists.outer.reach.skin,
                     steps * motion.displacement + rounding * lists.smallest_diameter)};
}

void make_tiles(VerletLists& lists, const PeriodicCell& cell, const StepMotion& motion,
                double outer_displacement, Particles& particles) {
    const InteractionReach reach = inner_reach(lists, motion);
    make_contact_tiles(lists.candidates, cell, reach, particles, lists.tile_scratch, lists.tiles);
    take_reference(cell, reach, particles, lists.inner);
    lists.outer_displacement = outer_displacement;
    lists.inner_displacement = 0.0;
    // Particles that are in no tile keep this; see contact_forces.
    for_each_block(particles.size(), 4096, [&](Count, Count begin, Count end) {
        std::fill(particles.loads.begin() + begin, particles.loads.begin() + end,
                  Load{Vec3::Zero(), 0.0});
    });
    ++lists.refilters;
}

/// While nothing moves.
InteractionReach outer_reach(double smallest_diameter, const ListSettings& settings) {
    return {settings.outer_strain_margin, settings.outer_skin * smallest_diameter};
}

/// Wider where a step moves things far.
InteractionReach outer_reach(const VerletLists& lists, const StepMotion& moved) {
    const ListSettings& settings = lists.settings;
    InteractionReach reach = outer_reach(lists.smallest_diameter, settings);
    reach.skin = std::clamp(settings.outer_steps * moved.displacement, reach.skin,
                            settings.widest_outer_skin * lists.smallest_diameter);
    return reach;
}

/// The same for candidates in this cell: no wider than the largest sphere has room for, which costs
/// more searches.
InteractionReach reach_with_room(const VerletLists& lists, const PeriodicCell& cell,
                                 const StepMotion& moved) {
    const InteractionReach full = outer_reach(lists, moved);
    const double largest = lists.hierarchy.collections().upper.back();
    const double room = cell.perpendicular_widths().minCoeff() - largest;
    const double wanted = full.of(largest, largest) - largest;
    if (room >= wanted) return full;
    const double share = 0.999 * std::max(0.0, room) / wanted;
    return {share * full.strain_margin, share * full.skin};
}

/// Adds a step to a bound on the displacement since an earlier place. What lies back is stretched
/// with the cell; and fractional coordinates round.
void add_step(const StepMotion& moved, const PeriodicCell& cell, double& displacement) {
    const double rounding = std::numeric_limits<double>::epsilon() * cell.matrix().norm();
    displacement = (displacement + moved.displacement) * (1.0 + moved.strain) + rounding;
}

double smallest(std::span<const double> diameters) {
    return *std::min_element(diameters.begin(), diameters.end());
}

}  // namespace

SizeCollections list_collections(std::span<const double> diameters, const ListSettings& settings) {
    if (settings.collection_ratio)
        return collections_for(
            settings.method,
            geometric_collections(diameters, {.ratio = *settings.collection_ratio}));
    const InteractionReach reach = outer_reach(smallest(diameters), settings);
    return collections_for(settings.method, cheapest_collections(diameters, reach));
}

VerletLists::VerletLists(std::span<const double> diameters, const ListSettings& list_settings)
    : hierarchy(list_collections(diameters, list_settings)),
      settings(list_settings),
      smallest_diameter(smallest(diameters)) {}

void renew_lists(VerletLists& lists, const PeriodicCell& cell, const StepMotion& moved,
                 const StepMotion& expected, Particles& particles) {
    const InteractionReach reach = reach_with_room(lists, cell, moved);
    find_candidates(lists.hierarchy, cell, reach, particles, lists.neighbor_scratch,
                    lists.candidates, lists.settings.method);
    take_reference(cell, reach, particles, lists.outer);
    ++lists.searches;
    make_tiles(lists, cell, expected, 0.0, particles);
}

void restore_lists(VerletLists& lists, const ListReference& outer, const PeriodicCell& cell,
                   const StepMotion& motion, Particles& particles) {
    Particles then = particles;
    for (std::size_t i = 0; i < then.spheres.size(); ++i) then.spheres[i].center = outer.centers[i];
    find_candidates(lists.hierarchy, outer.cell, outer.reach, then, lists.neighbor_scratch,
                    lists.candidates, lists.settings.method);
    lists.outer = outer;
    make_tiles(lists, cell, motion, largest_displacement(outer, cell, particles), particles);
}

ListRenewal keep_tiles_valid(VerletLists& lists, const PeriodicCell& cell, const StepMotion& moved,
                             const StepMotion& expected, Particles& particles) {
    add_step(moved, cell, lists.outer_displacement);
    add_step(moved, cell, lists.inner_displacement);
    if (list_is_valid(lists.inner, cell, lists.inner_displacement) &&
        list_is_valid(lists.outer, cell, lists.outer_displacement))
        return ListRenewal::none;
    lists.outer_displacement = largest_displacement(lists.outer, cell, particles);
    if (!list_is_valid(lists.outer, cell, lists.outer_displacement))
        return ListRenewal::search_needed;
    lists.inner_displacement = largest_displacement(lists.inner, cell, particles);
    if (list_is_valid(lists.inner, cell, worth_keeping * lists.inner_displacement))
        return ListRenewal::none;
    make_tiles(lists, cell, expected, lists.outer_displacement, particles);
    return ListRenewal::tiles;
}

}  // namespace jam
