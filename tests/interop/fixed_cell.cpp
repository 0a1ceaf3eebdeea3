// SPDX-License-Identifier: BSD-3-Clause
// Our side of the comparison with LAMMPS:
//     fixed_cell make DUMP FOLDER                         packings, with overlaps and tilted cells
//     fixed_cell run PACKING OUT LAW DAMPING TIME_STEP STEPS   steps from rest in the cell as it is
// OUT: a line "contacts pxx pyy pzz pxy pxz pyz" of the elastic forces, then a line
// "id x y z vx vy vz fx fy fz" a sphere.
#include "jamming/nph_step.h"
#include "packing/packing_file.h"
#include "packing/packing_io.h"
#include "support/packings.h"

#include <fmt/format.h>
#include <fmt/os.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <numeric>
#include <string>

namespace {

using namespace jam;
namespace fs = std::filesystem;

void make_random(const fs::path& folder, double size_ratio, double side) {
    constexpr int count = 1500;
    const Mat3 edges = test::random_edges(side, 7);
    save_packing(test::random_spheres(edges, count, size_ratio, 11),
                 folder / fmt::format("lambda{}.h5", size_ratio));
}

/// What was jammed, with every diameter changed by up to `spread`, so that all spheres swing.
void make_swinging(const fs::path& dump, const fs::path& folder, double spread) {
    Packing packing = read_packing(dump);
    packing.velocities.clear();
    for (std::size_t i = 0; i < packing.diameters.size(); ++i)
        packing.diameters[i] *= 1.0 + spread * std::sin(static_cast<double>(packing.ids[i]));
    save_packing(packing, folder / "swinging.h5");
}

JamState state_after(Scene& scene, double time_step, int steps, ContactSums& sums) {
    JamState state = start_state(scene);
    NphSettings settings = nph_settings(scene, state);
    settings.time_step = time_step;
    settings.cell_inertia = std::numeric_limits<double>::infinity();  // so that the cell stays
    NphScratch scratch(diameters_by_id(state.particles), ListSettings{});
    begin_nph(state, settings, scratch);
    for (int step = 0; step < steps; ++step) nph_step(state, settings, scratch);
    sums = scratch.sums;
    return state;
}

void run(const fs::path& packing, const std::string& out, const std::string& law, double damping,
         double time_step, int steps) {
    Scene scene;
    scene.start.packing = packing;
    scene.contact.law = law == "hertz" ? ContactLaw::hertz : ContactLaw::hooke;
    scene.contact.damping = damping;
    ContactSums sums;
    const JamState state = state_after(scene, time_step, steps, sums);
    const Mat3 p = sums.virial / state.cell.volume();
    fmt::ostream file = fmt::output_file(out);
    file.print("{} {} {} {} {} {} {}\n", sums.contacts, p(0, 0), p(1, 1), p(2, 2), p(0, 1), p(0, 2),
               p(1, 2));
    for (std::size_t i = 0; i < state.particles.ids.size(); ++i) {
        const Vec3 x = state.cell.cartesian(wrapped(state.particles.spheres[i].center));
        const Vec3& v = state.particles.motions[i].velocity;
        const Vec3& f = state.particles.loads[i].force;
        file.print("{} {} {} {} {} {} {} {} {} {}\n", state.original_ids[state.particles.ids[i]],
                   x[0], x[1], x[2], v[0], v[1], v[2], f[0], f[1], f[2]);
    }
}

}  // namespace

int main(int argc, char** argv) try {
    const std::vector<std::string> words(argv + 1, argv + argc);
    if (words.size() == 3 && words[0] == "make") {
        const fs::path folder = words[2];
        fs::create_directories(folder);
        make_random(folder, 1, 10.5);
        make_random(folder, 5, 26);
        make_random(folder, 20, 95);
        make_swinging(words[1], folder, 0.01);
    } else if (words.size() == 7 && words[0] == "run") {
        run(words[1], words[2], words[3], std::stod(words[4]), std::stod(words[5]),
            std::stoi(words[6]));
    } else {
        throw std::runtime_error(
            "usage: fixed_cell make DUMP FOLDER | run PACKING OUT LAW DAMPING TIME_STEP STEPS");
    }
} catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 1;
}
