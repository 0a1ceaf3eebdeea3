// SPDX-License-Identifier: BSD-3-Clause
#include "core/whole_file.h"

#include "support/refusals.h"
#include "support/scratch_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

namespace jam {
namespace {

namespace fs = std::filesystem;
using namespace jam::test;
using testing::HasSubstr;

std::size_t file_count(const ScratchFolder& folder) {
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()));
}

TEST(WholeFile, HoldsWhatWasWrittenInSmallAndLargePieces) {
    const ScratchFolder folder;
    std::string expected;
    write_whole_file(folder / "file", [&](FileSink& sink) {
        for (std::size_t length = 1; length < (3u << 20); length = length * 3 + 1) {
            const std::string piece(length, static_cast<char>('a' + length % 26));
            sink.write(piece);
            expected += piece;
        }
    });
    EXPECT_EQ(content_of(folder / "file"), expected);
    write_whole_file(folder / "file", "short");
    EXPECT_EQ(content_of(folder / "file"), "short");
    EXPECT_EQ(file_count(folder), 1u);
}

TEST(WholeFile, AWriterThatFailsLeavesTheEarlierFile) {
    const ScratchFolder folder;
    write_whole_file(folder / "file", "earlier");
    const auto fails_halfway = [](FileSink& sink) {
        sink.write(std::string(5 << 20, 'x'));
        throw std::runtime_error("halfway");
    };
    EXPECT_THROW(write_whole_file(folder / "file", fails_halfway), std::runtime_error);
    EXPECT_EQ(content_of(folder / "file"), "earlier");
    EXPECT_EQ(file_count(folder), 1u);
}

TEST(WholeFile, WhatAKilledWriterLeftIsWrittenOver) {
    const ScratchFolder folder;
    std::ofstream(folder / "file.partial") << "left by a killed program, and longer";
    write_whole_file(folder / "file", "whole");
    EXPECT_EQ(content_of(folder / "file"), "whole");
    EXPECT_EQ(file_count(folder), 1u);
}

TEST(WholeFile, ALinkStaysALink) {
    const ScratchFolder folder;
    fs::create_directory(folder / "elsewhere");
    fs::create_symlink(folder / "elsewhere/file", folder / "link");
    write_whole_file(folder / "elsewhere/file", "earlier");
    write_whole_file(folder / "link", "later");
    EXPECT_TRUE(fs::is_symlink(folder / "link"));
    EXPECT_EQ(content_of(folder / "elsewhere/file"), "later");
}

TEST(WholeFile, AFullDiskIsAnError) {
    FileSink sink("/dev/full");
    EXPECT_THAT(refusal_of([&] { sink.write(std::string(5 << 20, 'x')); }),
                HasSubstr("/dev/full: cannot be written (No space left on device); free some"));
    sink.write("little");
    EXPECT_THAT(refusal_of([&] { sink.sync(); }), HasSubstr("No space left on device"));
}

TEST(WholeFile, SaysWhatIsWrongWithAPath) {
    const ScratchFolder folder;
    const auto refusal = [](const fs::path& path) {
        return refusal_of([&] { write_whole_file(path, "text"); });
    };
    EXPECT_THAT(refusal(folder.path()), HasSubstr("is a folder"));
    EXPECT_THAT(refusal("/dev/full"), HasSubstr("is a device or a pipe"));
    EXPECT_THAT(refusal(folder / "no/file"), HasSubstr("make the folder first"));
    std::ofstream(folder / "file") << "x";
    EXPECT_THAT(refusal(folder / "file/file"), HasSubstr("correct the path"));
}

}  // namespace
}  // namespace jam
