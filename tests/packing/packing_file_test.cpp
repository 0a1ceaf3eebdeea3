// SPDX-License-Identifier: BSD-3-Clause
#include "packing/packing_file.h"

#include "core/check.h"
#include "packing/hdf5_handles.h"
#include "support/example_packings.h"
#include "support/refusals.h"
#include "support/scratch_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace jam {
namespace {

namespace fs = std::filesystem;
using namespace jam::test;
using testing::HasSubstr;

TEST(PackingFile, GivesBackTheSameBits) {
    const ScratchFolder folder;
    for (const Index size : {1, 6, 3000}) {
        const Packing saved = example_packing(size);
        save_packing(saved, folder / "packing.h5");
        expect_same_bits(load_packing(folder / "packing.h5"), saved);
    }
}

TEST(PackingFile, KeepsAPackingAtRestWithEmptyTexts) {
    const ScratchFolder folder;
    Packing saved = example_packing(20);
    saved.velocities.clear();
    saved.provenance = {};
    saved.material.law = ContactLaw::hooke;
    save_packing(saved, folder / "packing.h5");
    expect_same_bits(load_packing(folder / "packing.h5"), saved);
}

TEST(PackingFile, SamePackingGivesTheSameBytes) {
    const ScratchFolder folder;
    const Packing packing = example_packing(500);
    save_packing(packing, folder / "first.h5");
    save_packing(packing, folder / "second.h5");
    EXPECT_EQ(content_of(folder / "first.h5"), content_of(folder / "second.h5"));
}

TEST(PackingFile, HoldsObservablesAndContactsById) {
    const ScratchFolder folder;
    const Packing packing = example_packing(50);
    const std::vector<std::array<Index, 2>> pairs = {{0, 4}, {3, 49}};
    PackingExtras extras;
    extras.numbers = {{"phi", 0.64}, {"Z", 5.9}};
    extras.tensors = {{"pressure", packing.applied_pressure}};
    extras.contacts = pairs;
    save_packing(packing, folder / "packing.h5", extras);

    const hdf5::Group root = hdf5::open_file(folder / "packing.h5");
    EXPECT_EQ(root.read_array<double>("observables/phi/value"), std::vector<double>{0.64});
    EXPECT_EQ(root.read_array<std::int64_t>("observables/Z/step"),
              std::vector<std::int64_t>{packing.step});
    std::array<double, 9> pressure{};
    root.read("observables/pressure/value", std::span<double>(pressure), {1, 3, 3});
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column)
            EXPECT_EQ(pressure[static_cast<std::size_t>(3 * row + column)],
                      packing.applied_pressure(row, column));
    std::array<std::int64_t, 4> contacts{};
    root.read("connectivity/contacts", std::span<std::int64_t>(contacts), {2, 2});
    EXPECT_THAT(contacts, testing::ElementsAre(packing.ids[0], packing.ids[4], packing.ids[3],
                                               packing.ids[49]));
}

TEST(PackingFile, RefusesToSaveWhatCouldNotBeReadBack) {
    const ScratchFolder folder;
    Packing packing = example_packing(10);
    packing.positions[3][1] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(save_packing(packing, folder / "packing.h5"), InputError);
    EXPECT_TRUE(fs::is_empty(folder.path()));
}

TEST(PackingFile, SaysWhatIsWrongWithAPath) {
    const ScratchFolder folder;
    const Packing packing = example_packing(3);
    EXPECT_THAT(refusal_of([&] { load_packing(folder / "absent.h5"); }),
                HasSubstr("there is no such file"));
    EXPECT_THAT(refusal_of([&] { load_packing(folder.path()); }), HasSubstr("is a folder"));
    EXPECT_THAT(refusal_of([&] { save_packing(packing, folder.path()); }),
                HasSubstr("is a folder"));
    EXPECT_THAT(refusal_of([&] { save_packing(packing, folder / "no/packing.h5"); }),
                HasSubstr("make the folder first"));
}

TEST(PackingFile, RefusesForeignFiles) {
    const ScratchFolder folder;
    std::ofstream(folder / "text.h5") << "not HDF5 at all\n";
    EXPECT_THAT(refusal_of([&] { load_packing(folder / "text.h5"); }),
                HasSubstr("cannot be opened as an HDF5 file"));
    hdf5::write_file(folder / "other.h5",
                     [](const hdf5::Group& root) { root.write("temperature", 3.0); });
    EXPECT_THAT(refusal_of([&] { load_packing(folder / "other.h5"); }),
                HasSubstr("holds no packing"));
}

/// What a reader may do with a damaged file: give the same packing or say that it cannot.
void expect_same_or_refused(const fs::path& path, const Packing& saved) {
    try {
        expect_same_bits(load_packing(path), saved);
    } catch (const FileError& error) {
        EXPECT_THAT(error.what(), HasSubstr(path.string()));
    }
}

TEST(PackingFile, AnyTruncationIsRefused) {
    const ScratchFolder folder;
    save_packing(example_packing(400), folder / "whole.h5");
    const std::string whole = content_of(folder / "whole.h5");
    for (std::size_t length = 0; length < whole.size(); length += 1 + whole.size() / 97) {
        std::ofstream(folder / "cut.h5", std::ios::binary) << whole.substr(0, length);
        EXPECT_NE(refusal_of([&] { load_packing(folder / "cut.h5"); }), "") << length;
    }
}

TEST(PackingFile, BitRotIsNoticedOrHarmless) {
    const ScratchFolder folder;
    const Packing saved = example_packing(200);
    save_packing(saved, folder / "whole.h5");
    const std::string whole = content_of(folder / "whole.h5");
    for (std::size_t place = 0; place < whole.size(); place += 31) {
        std::string rotten = whole;
        rotten[place] = static_cast<char>(rotten[place] ^ (1 << (place % 8)));
        std::ofstream(folder / "rotten.h5", std::ios::binary) << rotten;
        expect_same_or_refused(folder / "rotten.h5", saved);
    }
}

/// Runs `action` in a child process whose files may not grow beyond `bytes`; its exit status.
template <typename Action>
int with_file_size_limit(rlim_t bytes, Action&& action) {
    const pid_t child = ::fork();
    if (child == 0) {
        std::signal(SIGXFSZ, SIG_IGN);
        const rlimit limit{bytes, bytes};
        ::setrlimit(RLIMIT_FSIZE, &limit);
        std::_Exit(action());
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

TEST(PackingFile, AFullDiskLeavesTheEarlierFileAndNoOther) {
    const ScratchFolder folder;
    const Packing earlier = example_packing(30);
    save_packing(earlier, folder / "packing.h5");
    const Packing later = example_packing(20000);
    for (const rlim_t limit : {rlim_t{0}, rlim_t{1000}, rlim_t{100000}, rlim_t{1000000}}) {
        const int status = with_file_size_limit(limit, [&] {
            const std::string error =
                refusal_of([&] { save_packing(later, folder / "packing.h5"); });
            return error.find("cannot be written") != std::string::npos ? 42 : 1;
        });
        EXPECT_EQ(status, 42) << "limit " << limit;
        expect_same_bits(load_packing(folder / "packing.h5"), earlier);
    }
    EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()), 1);
}

TEST(PackingFile, AFolderWithoutPermissionIsNamed) {
    if (::geteuid() == 0) GTEST_SKIP() << "root may write anywhere";
    const ScratchFolder folder;
    fs::permissions(folder.path(), fs::perms::owner_read | fs::perms::owner_exec);
    EXPECT_THAT(refusal_of([&] { save_packing(example_packing(3), folder / "packing.h5"); }),
                HasSubstr("choose a folder that you may write to"));
    fs::permissions(folder.path(), fs::perms::owner_all);
}

}  // namespace
}  // namespace jam
