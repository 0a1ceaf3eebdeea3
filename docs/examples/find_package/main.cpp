// SPDX-License-Identifier: BSD-3-Clause
// Two spheres pressed together across the face of a periodic cell: their contact, found by the
// library, is through an image and carries the force k overlap.
#include "analysis/contact_network.h"
#include "core/version.h"
#include "packing/packing.h"

#include <cstdio>

int main() {
    jam::Packing packing;
    packing.cell = jam::PeriodicCell::cubic(4.0);
    packing.positions = {{0.25, 2.0, 2.0}, {3.5, 2.0, 2.0}};
    packing.diameters = {1.0, 1.0};
    packing.ids = {0, 1};

    const auto contacts = jam::find_contacts(packing);
    std::printf("Widejam %s: %zu contact(s)\n", jam::version, contacts.size());
    for (const jam::Contact& contact : contacts)
        std::printf("overlap %.3f, force %.3f, image along x %+d\n", contact.overlap, contact.force,
                    contact.image.x());
    return contacts.size() == 1 ? 0 : 1;
}
