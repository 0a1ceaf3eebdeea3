// SPDX-License-Identifier: BSD-3-Clause
// Writes one packing in every format, for other programs to read: write_files DUMP FOLDER
#include "analysis/contact_network.h"
#include "packing/packing_file.h"
#include "packing/packing_io.h"

#include <fmt/format.h>

#include <filesystem>
#include <vector>

namespace {

/// Every contact once, as pairs of places.
std::vector<std::array<jam::Index, 2>> contact_pairs(const jam::Packing& packing) {
    std::vector<std::array<jam::Index, 2>> pairs;
    for (const jam::Contact& contact : jam::find_contacts(packing))
        pairs.push_back({contact.first, contact.second});
    return pairs;
}

void write_files(const std::filesystem::path& dump, const std::filesystem::path& folder) {
    jam::Packing packing = jam::read_packing(dump);
    packing.time = 0.25;
    packing.provenance.scene = "[sizes]\nkind = \"Größe\"\n";
    const auto contacts = contact_pairs(packing);
    jam::PackingExtras extras;
    extras.numbers = {{"Z", 2.0 * double(contacts.size()) / double(packing.size())}};
    extras.tensors = {{"cell", packing.cell.matrix()}};
    extras.contacts = contacts;
    std::filesystem::create_directories(folder);
    jam::save_packing(packing, folder / "packing.h5", extras);
    for (const char* name : {"packing.dump", "packing.data", "packing.xyz", "packing.csv"})
        jam::write_packing(packing, folder / name);
}

}  // namespace

int main(int argc, char** argv) try {
    if (argc != 3) throw std::runtime_error("usage: write_files DUMP FOLDER");
    write_files(argv[1], argv[2]);
} catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 1;
}
