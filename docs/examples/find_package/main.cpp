// SPDX-License-Identifier: BSD-3-Clause
// A sheared cell and the same lattice in less tilted edges.
#include <cell/periodic_cell.h>
#include <core/version.h>
#include <cstdio>

int main() {
    jam::Mat3 edges = 4.0 * jam::Mat3::Identity();
    edges(0, 1) = 3.0;  // the tilt xy
    const auto reduction = jam::PeriodicCell(edges).reduced();
    std::printf("Widejam %s: tilt %.1f reduced to %.1f, volume %.0f\n", jam::version, edges(0, 1),
                reduction.cell.matrix()(0, 1), reduction.cell.volume());
    return 0;
}
