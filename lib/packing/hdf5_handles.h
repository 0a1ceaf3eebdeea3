// SPDX-License-Identifier: BSD-3-Clause
// HDF5 as far as our files need it: groups that own their identifiers, and whole arrays, texts and
// attributes written and read by type. One thread at a time: Debian's HDF5 is not thread-safe.
// Opening or writing a file turns off HDF5's own printing of errors in the whole process.
//
// Numbers of more than a few kilobytes carry their own checksum in an attribute, which is compared
// whenever they are read; the smaller ones lie inside HDF5's own checksummed metadata.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace jam::hdf5 {

/// An HDF5 identifier and the call that closes it.
class Handle {
  public:
    using Id = std::int64_t;  ///< HDF5's hid_t
    using Close = int (*)(Id);

    Handle(Id id, Close close) : id_(id), close_(close) {}
    ~Handle();
    Handle(Handle&& other) noexcept;
    Handle& operator=(Handle&& other) noexcept;
    Id id() const { return id_; }

  private:
    Id id_;
    Close close_;
};

/// Extents of an array, slowest first; empty for a single value.
using Shape = std::vector<std::uint64_t>;

/// The number types our files hold; little-endian in the file.
enum class NumberType { float64, int64, uint64, int32, uint32, uint8 };

template <typename T>
constexpr NumberType number_type() {
    if constexpr (std::is_same_v<T, double>)
        return NumberType::float64;
    else if constexpr (std::is_same_v<T, std::int64_t>)
        return NumberType::int64;
    else if constexpr (std::is_same_v<T, std::uint64_t>)
        return NumberType::uint64;
    else if constexpr (std::is_same_v<T, std::int32_t>)
        return NumberType::int32;
    else if constexpr (std::is_same_v<T, std::uint32_t>)
        return NumberType::uint32;
    else {
        static_assert(std::is_same_v<T, std::uint8_t>, "not a number type of our files");
        return NumberType::uint8;
    }
}

/// A group of an open file; the file stays open as long as any of its groups. Names may be paths
/// ("box/edges"). Every function throws FileError, with the file, the object, HDF5's reason and a
/// remedy.
class Group {
  public:
    /// The group `name` below this one.
    Group open(std::string_view name) const;
    Group create(std::string_view name) const;
    bool has(std::string_view name) const;

    /// Writes `values`, of the given shape, as a new dataset.
    template <typename T>
    void write(std::string_view name, std::span<const T> values, const Shape& shape) const {
        write_numbers(name, number_type<T>(), values.data(), values.size(), shape);
    }
    template <typename T>
    void write(std::string_view name, const std::vector<T>& values) const {
        write(name, std::span<const T>(values), {values.size()});
    }
    template <typename T>
    requires std::is_arithmetic_v<T>
    void write(std::string_view name, T value) const {
        write(name, std::span<const T>(&value, 1), {});
    }
    void write_text(std::string_view name, std::string_view text) const;

    Shape shape(std::string_view name) const;

    /// Fills `values` from a dataset that must have the given shape.
    template <typename T>
    void read(std::string_view name, std::span<T> values, const Shape& expected) const {
        read_numbers(name, number_type<T>(), values.data(), values.size(), expected);
    }
    /// One value, or an array of one dimension.
    template <typename T>
    T read(std::string_view name) const {
        T value{};
        read(name, std::span<T>(&value, 1), {});
        return value;
    }
    template <typename T>
    std::vector<T> read_array(std::string_view name) const {
        std::vector<T> values(array_size(name));
        read(name, std::span<T>(values), {values.size()});
        return values;
    }
    std::string read_text(std::string_view name) const;

    /// Attributes of this group.
    template <typename T>
    void write_attribute(std::string_view name, std::span<const T> values,
                         const Shape& shape) const {
        write_number_attribute(name, number_type<T>(), values.data(), shape);
    }
    void write_attribute(std::string_view name, std::string_view text) const;
    void write_attribute(std::string_view name, std::span<const std::string_view> texts) const;
    template <typename T>
    std::vector<T> read_attribute(std::string_view name, std::size_t expected_size) const {
        std::vector<T> values(expected_size);
        read_number_attribute(name, number_type<T>(), values.data(), expected_size);
        return values;
    }

    /// A second name, `name`, for the dataset at `target` (from the root of the file).
    void link(std::string_view name, std::string_view target) const;

    /// A dataset [N][M] that shows the last of the T frames of the dataset [T][N][M] at `source`
    /// (from the root of the file) without holding it.
    void show_last_frame(std::string_view name, std::string_view source) const;

    /// Lets the attribute `attribute` of the dataset `dataset` point to the object at `target`.
    void refer(std::string_view dataset, std::string_view attribute, std::string_view target) const;

  private:
    friend Group open_file(const std::filesystem::path&);
    friend void write_file(const std::filesystem::path&, const std::function<void(const Group&)>&);

    Group(Handle handle, std::string file, std::string name);
    void write_numbers(std::string_view name, NumberType type, const void* values,
                       std::size_t count, const Shape& shape) const;
    void read_numbers(std::string_view name, NumberType type, void* values, std::size_t count,
                      const Shape& expected) const;
    void write_number_attribute(std::string_view name, NumberType type, const void* values,
                                const Shape& shape) const;
    void read_number_attribute(std::string_view name, NumberType type, void* values,
                               std::size_t expected_size) const;
    std::size_t array_size(std::string_view name) const;
    Handle open_dataset(std::string_view name) const;
    [[noreturn]] void fail(std::string_view object, std::string_view what,
                           std::string_view remedy) const;

    Handle handle_;
    std::string file_;
    std::string name_;  ///< path of this group in the file, "" for the root
};

/// The root of an existing file, for reading. Throws FileError.
Group open_file(const std::filesystem::path& path);

/// Makes the file at `path` hold what `fill` writes under its root, or leaves it as it was
/// (core/whole_file.h). It is built in memory first, as large as the file will be: HDF5 1.10
/// crashes when the disk refuses one of its writes.
void write_file(const std::filesystem::path& path, const std::function<void(const Group&)>& fill);

}  // namespace jam::hdf5
