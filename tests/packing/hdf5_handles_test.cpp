// SPDX-License-Identifier: BSD-3-Clause
#include "packing/hdf5_handles.h"

#include "support/refusals.h"
#include "support/scratch_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <limits>
#include <numeric>

namespace jam {
namespace {

using namespace jam::test;
using hdf5::Group;
using testing::AllOf;
using testing::HasSubstr;

/// The root of a file with what `fill` wrote; `folder` must outlive it.
template <typename Fill>
Group written(const ScratchFolder& folder, Fill&& fill) {
    hdf5::write_file(folder / "file.h5", fill);
    return hdf5::open_file(folder / "file.h5");
}

template <typename T>
class Hdf5Numbers : public testing::Test {};
using NumberTypes =
    testing::Types<double, std::int64_t, std::uint64_t, std::int32_t, std::uint32_t, std::uint8_t>;
TYPED_TEST_SUITE(Hdf5Numbers, NumberTypes);

TYPED_TEST(Hdf5Numbers, ComeBackOfAnySize) {
    using T = TypeParam;
    const ScratchFolder folder;
    std::vector<T> large(20000);
    for (std::size_t i = 0; i < large.size(); ++i) large[i] = static_cast<T>(i * i + 3);
    const std::vector<T> small = {std::numeric_limits<T>::lowest(), std::numeric_limits<T>::max()};
    const Group root = written(folder, [&](const Group& group) {
        group.write("one", small[1]);
        group.write("small", small);
        group.write("large", std::span<const T>(large), {100, 4, 50});
        group.write("empty", std::span<const T>(), {0, 3});
        group.write_attribute("noted", std::span<const T>(small), {2});
    });
    EXPECT_EQ(root.read<T>("one"), small[1]);
    EXPECT_EQ(root.read_array<T>("small"), small);
    std::vector<T> read(large.size());
    root.read("large", std::span<T>(read), {100, 4, 50});
    EXPECT_EQ(read, large);
    EXPECT_EQ(root.shape("empty"), (hdf5::Shape{0, 3}));
    EXPECT_EQ(root.template read_attribute<T>("noted", 2), small);
}

TEST(Hdf5, TextsComeBackOfAnyLength) {
    const ScratchFolder folder;
    const std::string lengthy(200000, 'x');
    const Group root = written(folder, [&](const Group& group) {
        group.write_text("empty", "");
        group.write_text("short", "Größe\n");
        group.write_text("long", lengthy);
    });
    EXPECT_EQ(root.read_text("empty"), "");
    EXPECT_EQ(root.read_text("short"), "Größe\n");
    EXPECT_EQ(root.read_text("long"), lengthy);
}

TEST(Hdf5, GroupsLinksAndFrames) {
    const ScratchFolder folder;
    std::vector<double> frames(2 * 5 * 3);
    std::iota(frames.begin(), frames.end(), 0.0);
    const Group root = written(folder, [&](const Group& group) {
        const Group inner = group.create("outer").create("inner");
        inner.write("frames", std::span<const double>(frames), {2, 5, 3});
        group.link("again", "/outer/inner/frames");
        group.show_last_frame("last", "/outer/inner/frames");
    });
    EXPECT_TRUE(root.has("outer/inner/frames"));
    EXPECT_FALSE(root.has("outer/other/frames"));
    std::vector<double> again(frames.size());
    root.read("again", std::span(again), {2, 5, 3});
    EXPECT_EQ(again, frames);
    std::vector<double> last(15);
    root.open("outer").open("inner").read("frames", std::span(again), {2, 5, 3});
    root.read("last", std::span(last), {5, 3});
    EXPECT_EQ(last, std::vector<double>(frames.begin() + 15, frames.end()));
}

TEST(Hdf5, SaysFileObjectReasonAndRemedy) {
    const ScratchFolder folder;
    const Group root = written(folder, [](const Group& group) {
        const Group inner = group.create("inner");
        inner.write("values", std::vector<double>{1.0, 2.0});
        inner.write_text("text", "words");
    });
    const Group inner = root.open("inner");
    const std::string file = (folder / "file.h5").string();
    EXPECT_THAT(refusal_of([&] { inner.read<double>("absent"); }),
                HasSubstr(file + ": /inner/absent: there is no such dataset"));
    EXPECT_THAT(refusal_of([&] { inner.open("absent"); }), HasSubstr("no such group"));
    EXPECT_THAT(refusal_of([&] { inner.read<double>("values"); }),
                AllOf(HasSubstr("has the shape [2], a single value was expected"),
                      HasSubstr("use an earlier copy")));
    EXPECT_THAT(refusal_of([&] { inner.read<double>("text"); }), HasSubstr("cannot be read"));
    EXPECT_THAT(refusal_of([&] { inner.read_text("values"); }), HasSubstr("is not a text"));
    EXPECT_THAT(refusal_of([&] { inner.read_attribute<double>("absent", 1); }),
                HasSubstr("no such attribute"));
}

TEST(Hdf5, AChangedValueIsNoticed) {
    const ScratchFolder folder;
    const std::vector<double> values(10000, 1.5);
    hdf5::write_file(folder / "file.h5",
                     [&](const Group& group) { group.write("values", values); });
    std::string content = content_of(folder / "file.h5");
    const std::string written_value(reinterpret_cast<const char*>(values.data()), 64);
    content[content.find(written_value)] ^= 1;
    std::ofstream(folder / "file.h5", std::ios::binary) << content;
    const Group root = hdf5::open_file(folder / "file.h5");
    EXPECT_THAT(refusal_of([&] { root.read_array<double>("values"); }),
                HasSubstr("/values: its values are not those that were saved"));
}

TEST(Hdf5, AWriterThatFailsLeavesNoFile) {
    const ScratchFolder folder;
    const auto twice = [](const Group& group) {
        group.write("values", 1.0);
        group.write("values", 2.0);
    };
    EXPECT_THAT(refusal_of([&] { hdf5::write_file(folder / "file.h5", twice); }),
                HasSubstr("/values: this dataset cannot be made"));
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

}  // namespace
}  // namespace jam
