// SPDX-License-Identifier: BSD-3-Clause
#include "contacts/contact_forces.h"

#include "cell/upper_map.h"
#include "contacts/elastic_laws.h"
#include "core/lanes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <type_traits>

namespace jam {

namespace {

/// The upper triangle of a symmetric 3x3 matrix.
Mat3 symmetric(double xx, double xy, double xz, double yy, double yz, double zz) {
    Mat3 matrix;
    matrix << xx, xy, xz, xy, yy, yz, xz, yz, zz;
    return matrix;
}

/// Sums over contacts run in eight lanes that are added in order at the end: a fixed order of
/// additions, whatever the width of the machine's vectors.
constexpr std::size_t lanes = 8;
struct LaneSums {
    std::array<double, lanes> of_lane{};
    double& operator[](std::size_t lane) { return of_lane[lane]; }
};

double sum_of(const LaneSums& sums) {
    return std::accumulate(sums.of_lane.begin(), sums.of_lane.end(), 0.0);
}

/// Forces within one tile, stage by stage over arrays that stay in the cache. Each stage is a plain
/// loop without unpredictable branches, and all but the first and last run many contacts at a time.
template <typename Law, bool damped>
class TileForces {
  public:
    TileForces(const PeriodicCell& cell, const Law& law, double damping,
               const Mat3& velocity_gradient, ForceScratch::Thread& scratch)
        : to_cartesian_(cell.matrix()),
          law_(law),
          damping_(damping),
          gradient_(velocity_gradient),
          s_(scratch) {}

    /// Of a tile or of what is live of one.
    template <typename Tile>
    ContactSums evaluate(const Tile& tile, const Particles& particles, Load* loads, Load* slots) {
        gather_participants(tile.participants, particles);
        const std::size_t contacts = find_contacts(tile.pairs);
        if constexpr (damped) find_closing_speeds(contacts);
        ContactSums sums = find_forces(contacts);
        add_forces(contacts);
        write_own_loads(tile, loads);
        write_slots(tile, slots);
        return sums;
    }

    /// After evaluate: those of the tile that touch another and are not stirred.
    void find_woken(const LiveTile& tile, const ContactSums& sums,
                    std::vector<Index>& woken) const {
        woken.clear();
        const auto look_at = [&](std::uint16_t p) {
            if (!tile.is_stirred[p]) woken.push_back(tile.participants[p].particle());
        };
        for (std::size_t c = 0; c < static_cast<std::size_t>(sums.contacts); ++c) {
            look_at(s_.contacts[c].first);
            look_at(s_.contacts[c].second);
        }
    }

  private:
    static std::size_t particle_of(Neighbor participant) {
        return static_cast<std::size_t>(participant.particle());
    }

    void gather_participants(std::span<const Neighbor> participants, const Particles& particles) {
        const std::size_t count = participants.size();
        grow(s_.spheres, count);
        s_.loads.assign(count, Load{Vec3::Zero(), 0.0});
        if constexpr (damped) grow(s_.motions, count);
        const auto expect = [&](std::size_t p) {
            expect_read(particles.spheres[particle_of(participants[p])]);
        };
        for_each_expected(0, count, expect, [&](std::size_t p) {
            const std::size_t particle = particle_of(participants[p]);
            const Double4 sphere =
                load4(particles.spheres[particle]) + load4(image_shifts[participants[p].image()]);
            store4(with_fourth_of(to_cartesian_(sphere), sphere), s_.spheres[p]);
            if constexpr (damped) s_.motions[p] = particles.motions[particle];
        });
    }

    /// From the second center to the first, and the sum of the diameters, of four pairs.
    static Columns4 separations(const Sphere* spheres, const TilePair* pairs) {
        constexpr Double4 add_diameters = {1.0, 1.0, 1.0, -1.0};
        const auto separation = [&](const TilePair& pair) {
            return load4(spheres[pair.first]) - add_diameters * load4(spheres[pair.second]);
        };
        return transposed({separation(pairs[0]), separation(pairs[1]), separation(pairs[2]),
                           separation(pairs[3])});
    }

    /// Packs the pairs that overlap, then measures them: most do not, and cost no more than that.
    std::size_t find_contacts(std::span<const TilePair> pairs) {
        reserve(pairs.size() + lanes);
        const std::size_t contacts = pack_touching(pairs);
        measure(std::span<const TilePair>(s_.contacts).first(contacts));
        return contacts;
    }

    std::size_t pack_touching(std::span<const TilePair> pairs) {
        // Pointers of its own, which nothing that is written can change.
        const Sphere* const spheres = s_.spheres.data();
        TilePair* const packed = s_.contacts.data();
        std::size_t end = 0;
        for_each_four(pairs, [spheres, packed, &end](const TilePair* four, int count) {
            const Columns4 r = separations(spheres, four);
            const Double4 sum_of_radii = 0.5 * r.w;
            const Mask4 overlap = squared_length(r) < sum_of_radii * sum_of_radii;
            const unsigned touching = bits_of(overlap) & bits_of_first(count);
            end += store_packed(four, touching, packed + end);
        });
        return end;
    }

    void measure(std::span<const TilePair> contacts) {
        const Sphere* const spheres = s_.spheres.data();
        std::size_t c = 0;
        for_each_four(contacts, [&](const TilePair* four, int) {
            const Columns4 r = separations(spheres, four);
            store_lanes(r.x, &s_.x[c]);
            store_lanes(r.y, &s_.y[c]);
            store_lanes(r.z, &s_.z[c]);
            store_lanes(squared_length(r), &s_.squared[c]);
            store_lanes(0.5 * r.w, &s_.reach[c]);
            if constexpr (needs_diameters)
                for (std::size_t k = 0; k < 4; ++k)
                    s_.diameter_first[c + k] = spheres[four[k].first].diameter;
            c += 4;
        });
    }

    /// What is in front stays; to shrink and grow again would fill it with zeros each time.
    template <typename Value>
    static void grow(std::vector<Value>& column, std::size_t size) {
        if (column.size() < size) column.resize(size + size / 4);
    }

    void reserve(std::size_t size) {
        for (auto* column :
             {&s_.x, &s_.y, &s_.z, &s_.squared, &s_.reach, &s_.diameter_first, &s_.closing,
              &s_.mass, &s_.inverse, &s_.energy, &s_.elastic, &s_.force})
            grow(*column, size);
        grow(s_.contacts, size);
    }

    /// r . (v_i - v_j + L r) and the effective mass of every contact.
    void find_closing_speeds(std::size_t contacts) {
        for (std::size_t c = 0; c < contacts; ++c) {
            const Motion& first = s_.motions[s_.contacts[c].first];
            const Motion& second = s_.motions[s_.contacts[c].second];
            const double x = s_.x[c];
            const double y = s_.y[c];
            const double z = s_.z[c];
            const double vx = first.velocity[0] - second.velocity[0] + gradient_(0, 0) * x +
                              gradient_(0, 1) * y + gradient_(0, 2) * z;
            const double vy =
                first.velocity[1] - second.velocity[1] + gradient_(1, 1) * y + gradient_(1, 2) * z;
            const double vz = first.velocity[2] - second.velocity[2] + gradient_(2, 2) * z;
            s_.closing[c] = x * vx + y * vy + z * vz;
            s_.mass[c] = first.mass * second.mass / (first.mass + second.mass);
        }
    }

    /// s_.force and s_.elastic become the forces over the distance, ready to be multiplied with r.
    ContactSums find_forces(std::size_t contacts) {
        const std::size_t end = pad(contacts);
        find_magnitudes(end);
        LaneSums energy, magnitudes;
        for (std::size_t begin = 0; begin < end; begin += lanes) {
            for (std::size_t lane = 0; lane < lanes; ++lane) {
                const std::size_t c = begin + lane;
                energy[lane] += s_.energy[c];
                magnitudes[lane] += s_.force[c];
                s_.force[c] *= s_.inverse[c];
            }
        }
        ContactSums sums;
        sums.virial = virial(s_.force, contacts);
        sums.elastic_virial = damped ? virial(s_.elastic, contacts) : sums.virial;
        sums.energy = sum_of(energy);
        sums.force_magnitudes = sum_of(magnitudes);
        sums.contacts = static_cast<Count>(contacts);
        return sums;
    }

    /// Forces, energies and inverse distances, and the elastic forces over the distance. From
    /// columns to columns, so that a compiler can run many contacts at a time.
    void find_magnitudes(std::size_t end) {
        const auto larger = [](double a, double b) { return a > b ? a : b; };
#pragma GCC ivdep
        for (std::size_t c = 0; c < end; ++c) {
            // Coincident centers have no direction: they get a force of zero, not of NaN.
            const double distance = std::sqrt(larger(s_.squared[c], 1e-300));
            const double overlap = s_.reach[c] - distance;
            const double inverse = 1.0 / distance;
            const double diameter = needs_diameters ? s_.diameter_first[c] : 1.0;
            const double other = 2.0 * s_.reach[c] - diameter;
            const double elastic = law_.force(overlap, diameter, other);
            s_.inverse[c] = inverse;
            s_.energy[c] = law_.energy(overlap, diameter, other);
            if constexpr (damped) {
                const double damping = damping_ * s_.mass[c] * s_.closing[c] * inverse;
                s_.force[c] = larger(0.0, elastic - damping);
                s_.elastic[c] = elastic * inverse;
            } else {
                s_.force[c] = elastic;
            }
        }
    }

    /// Sum over contacts of (f/|r|) r r^T.
    Mat3 virial(const std::vector<double>& force_over_distance, std::size_t contacts) const {
        LaneSums xx, xy, xz, yy, yz, zz;
        for (std::size_t begin = 0; begin < contacts; begin += lanes) {
            for (std::size_t lane = 0; lane < lanes; ++lane) {
                const std::size_t c = begin + lane;
                const double fx = force_over_distance[c] * s_.x[c];
                const double fy = force_over_distance[c] * s_.y[c];
                const double fz = force_over_distance[c] * s_.z[c];
                xx[lane] += fx * s_.x[c];
                xy[lane] += fx * s_.y[c];
                xz[lane] += fx * s_.z[c];
                yy[lane] += fy * s_.y[c];
                yz[lane] += fy * s_.z[c];
                zz[lane] += fz * s_.z[c];
            }
        }
        return symmetric(sum_of(xx), sum_of(xy), sum_of(xz), sum_of(yy), sum_of(yz), sum_of(zz));
    }

    /// Fills the last eight up with contacts that carry no force; returns where they end.
    std::size_t pad(std::size_t contacts) {
        for (std::size_t c = contacts; c < contacts + lanes; ++c) {
            s_.x[c] = s_.y[c] = s_.z[c] = s_.closing[c] = s_.mass[c] = 0.0;
            s_.squared[c] = s_.reach[c] = s_.diameter_first[c] = 1.0;
        }
        return (contacts + lanes - 1) / lanes * lanes;
    }

    void add_forces(std::size_t contacts) {
        for (std::size_t c = 0; c < contacts; ++c) {
            Load& first = s_.loads[s_.contacts[c].first];
            Load& second = s_.loads[s_.contacts[c].second];
            const double f = s_.force[c];
            const Double4 load = {f * s_.x[c], f * s_.y[c], f * s_.z[c], 1.0};
            const Double4 reaction = {-load[0], -load[1], -load[2], 1.0};
            store4(load4(first) + load, first);
            store4(load4(second) + reaction, second);
        }
    }

    template <typename Tile>
    void write_own_loads(const Tile& tile, Load* loads) const {
        const auto load_of = [&](std::size_t p) -> Load& {
            return loads[particle_of(tile.participants[p])];
        };
        for_each_expected(
            0, static_cast<std::size_t>(tile.own_count),
            [&](std::size_t p) { expect_write(load_of(p)); },
            [&](std::size_t p) { store4(load4(s_.loads[p]), load_of(p)); });
    }

    void write_slots(const ContactTile& tile, Load* slots) const {
        std::copy(s_.loads.begin() + tile.own_count, s_.loads.end(), slots + tile.first_slot);
    }

    void write_slots(const LiveTile& tile, Load* slots) const {
        for (std::size_t k = 0; k < tile.slots.size(); ++k)
            slots[tile.slots[k]] = s_.loads[static_cast<std::size_t>(tile.own_count) + k];
    }

    static constexpr bool needs_diameters = std::is_same_v<Law, Hertz>;

    const UpperMap to_cartesian_;
    const Law law_;
    const double damping_;
    const Mat3& gradient_;
    ForceScratch::Thread& s_;
};

/// Sum over tiles of sum_of(t, forces, memory of the thread).
template <typename Law, bool damped, typename SumOfTile>
ContactSums sum_tiles(const PeriodicCell& cell, const Law& law, double damping,
                      const Mat3& velocity_gradient, std::size_t tile_count, ForceScratch& scratch,
                      SumOfTile&& sum_of) {
    scratch.sums_of_tile.resize(tile_count);
    for_each_block(static_cast<Count>(tile_count), 1, [&](Count at, Count, Count) {
        const auto t = static_cast<std::size_t>(at);
        ForceScratch::Thread& of_thread = scratch.threads.local();
        TileForces<Law, damped> forces(cell, law, damping, velocity_gradient, of_thread);
        scratch.sums_of_tile[t] = sum_of(t, forces, of_thread);
    });
    ContactSums sums;
    for (const ContactSums& of_tile : scratch.sums_of_tile) sums += of_tile;
    return sums;
}

template <typename Law, bool damped>
ContactSums forces_over_tiles(const PeriodicCell& cell, const Law& law, double damping,
                              const Mat3& velocity_gradient, const ContactTiles& tiles,
                              const Particles& particles, std::vector<Load>& loads,
                              ForceScratch& scratch) {
    scratch.slots.resize(static_cast<std::size_t>(tiles.slot_count));
    const auto sum_of = [&](std::size_t t, auto& forces, ForceScratch::Thread&) {
        return forces.evaluate(tiles.tiles[t], particles, loads.data(), scratch.slots.data());
    };
    return sum_tiles<Law, damped>(cell, law, damping, velocity_gradient, tiles.tiles.size(),
                                  scratch, sum_of);
}

}  // namespace

ContactSums& ContactSums::operator+=(const ContactSums& other) {
    virial += other.virial;
    elastic_virial += other.elastic_virial;
    energy += other.energy;
    force_magnitudes += other.force_magnitudes;
    contacts += other.contacts;
    return *this;
}

ContactSums contact_forces(const PeriodicCell& cell, const Material& material,
                           const ContactFlow& flow, const ContactTiles& tiles,
                           const Particles& particles, std::vector<Load>& loads,
                           ForceScratch& scratch) {
    return with_elastic_law(material, [&](const auto& law) {
        using Law = std::decay_t<decltype(law)>;
        const auto run = flow.damped ? forces_over_tiles<Law, true> : forces_over_tiles<Law, false>;
        return run(cell, law, material.damping, flow.velocity_gradient, tiles, particles, loads,
                   scratch);
    });
}

ContactSums live_contact_forces(const PeriodicCell& cell, const Material& material,
                                const ContactTiles& tiles, std::span<const char> stirred,
                                const Particles& particles, std::vector<Load>& loads,
                                ForceScratch& scratch) {
    const auto sum_of = [&](std::size_t t, auto& forces, ForceScratch::Thread& of_thread) {
        LiveTile& live = scratch.live_tiles[t];
        if (live.stale) renew_live_tile(tiles.tiles[t], stirred, of_thread.live, live);
        ContactSums sums = forces.evaluate(live, particles, loads.data(), scratch.slots.data());
        forces.find_woken(live, sums, scratch.woken_of_tile[t]);
        return sums;
    };
    return with_elastic_law(material, [&](const auto& law) {
        return sum_tiles<std::decay_t<decltype(law)>, false>(cell, law, 0.0, Mat3::Zero(),
                                                             tiles.tiles.size(), scratch, sum_of);
    });
}

/// Slots of who is not looked at stay zero.
void begin_live_tiles(const ContactTiles& tiles, ForceScratch& scratch) {
    scratch.slots.assign(static_cast<std::size_t>(tiles.slot_count), Load{Vec3::Zero(), 0.0});
    scratch.live_tiles.resize(tiles.tiles.size());
    scratch.woken_of_tile.resize(tiles.tiles.size());
    for (LiveTile& live : scratch.live_tiles) {
        live.stale = true;
        live.whole = false;
    }
}

void stir_live_tiles(const ContactTiles& tiles, std::span<const Index> newly_stirred,
                     ForceScratch& scratch) {
    // To look for that many takes longer than to make all anew.
    if (newly_stirred.size() > tiles.tiles.size())
        for (LiveTile& live : scratch.live_tiles) live.stale = true;
    else
        for (const Index i : newly_stirred)
            tiles.for_each_tile_of(i, [&](std::size_t t) { scratch.live_tiles[t].stale = true; });
}

void add_halo_loads(const ContactTiles& tiles, Count block, const std::vector<Load>& slots,
                    std::vector<Load>& loads) {
    const auto at = static_cast<std::size_t>(block);
    for (const Index particle : tiles.only_in_halo[at])
        loads[static_cast<std::size_t>(particle)] = {Vec3::Zero(), 0.0};
    const auto expect = [&](std::size_t k) { expect_read(slots[tiles.halo_loads[k].slot]); };
    for_each_expected(static_cast<std::size_t>(tiles.halo_begin[at]),
                      static_cast<std::size_t>(tiles.halo_begin[at + 1]), expect,
                      [&](std::size_t k) {
                          const HaloLoad& halo = tiles.halo_loads[k];
                          Load& load = loads[static_cast<std::size_t>(halo.particle)];
                          store4(load4(load) + load4(slots[halo.slot]), load);
                      });
}

void add_halo_loads(const ContactTiles& tiles, const std::vector<Load>& slots,
                    std::vector<Load>& loads) {
    for_each_block(static_cast<Count>(loads.size()), ContactTiles::particles_per_block,
                   [&](Count block, Count, Count) { add_halo_loads(tiles, block, slots, loads); });
}

}  // namespace jam
