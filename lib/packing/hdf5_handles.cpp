// SPDX-License-Identifier: BSD-3-Clause
#include "packing/hdf5_handles.h"

#include "core/check.h"
#include "core/state_hash.h"
#include "core/whole_file.h"

#include <hdf5.h>

#include <algorithm>
#include <utility>

namespace jam::hdf5 {

namespace fs = std::filesystem;

static_assert(std::is_same_v<Handle::Id, hid_t> && std::is_same_v<herr_t, int>);

namespace {

/// Arrays up to this size lie in the object's header, whose checksum HDF5 keeps.
constexpr std::size_t compact_limit = 4096;
constexpr const char* checksum_name = "checksum";
constexpr const char* damage_remedy =
    "the file is damaged or was made by another program; use an earlier copy or convert it";
constexpr const char* memory_remedy = "there may be too little memory; free some";

/// HDF5 prints no errors of its own from here on: they go into our messages instead. For good,
/// since it would also print at the end of a program that met a damaged file.
void silence_hdf5() {
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

/// What the innermost function of HDF5 said of the failure before.
std::string innermost_reason() {
    std::string reason;
    const auto take_first = [](unsigned depth, const H5E_error2_t* error, void* out) -> herr_t {
        if (depth == 0 && error->desc != nullptr) *static_cast<std::string*>(out) = error->desc;
        return 0;
    };
    H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, take_first, &reason);
    std::replace(reason.begin(), reason.end(), '\n', ' ');
    return reason.empty() ? "HDF5 gives no reason" : reason;
}

/// The type in the file and in memory: our files are little-endian, as are the machines we run on.
hid_t hdf5_type(NumberType type) {
    switch (type) {
        case NumberType::float64:
            return H5T_IEEE_F64LE;
        case NumberType::int64:
            return H5T_STD_I64LE;
        case NumberType::uint64:
            return H5T_STD_U64LE;
        case NumberType::int32:
            return H5T_STD_I32LE;
        case NumberType::uint32:
            return H5T_STD_U32LE;
        case NumberType::uint8:
            return H5T_STD_U8LE;
    }
    return H5I_INVALID_HID;
}

std::uint64_t product(const Shape& shape) {
    std::uint64_t count = 1;
    for (const std::uint64_t extent : shape) count *= extent;
    return count;
}

std::uint64_t checksum_of(const void* values, std::size_t bytes) {
    return state_hash(std::span(static_cast<const std::byte*>(values), bytes));
}

Handle dataspace(const Shape& shape) {
    const std::vector<hsize_t> extents(shape.begin(), shape.end());
    return {shape.empty()
                ? H5Screate(H5S_SCALAR)
                : H5Screate_simple(static_cast<int>(extents.size()), extents.data(), nullptr),
            H5Sclose};
}

/// Fixed length, as MDAnalysis and VTK ask; HDF5 knows no empty string, so that one byte is
/// padding.
Handle string_type(std::size_t length, H5T_cset_t characters) {
    Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
    H5Tset_size(type.id(), std::max<std::size_t>(length, 1));
    H5Tset_strpad(type.id(), H5T_STR_NULLPAD);
    H5Tset_cset(type.id(), characters);
    return type;
}

/// Without times, so that the same packing always gives the same bytes.
Handle object_creation(hid_t property_class) {
    Handle creation(H5Pcreate(property_class), H5Pclose);
    H5Pset_obj_track_times(creation.id(), false);
    return creation;
}

Handle dataset_creation(std::size_t bytes) {
    Handle creation = object_creation(H5P_DATASET_CREATE);
    const bool compact = bytes > 0 && bytes <= compact_limit;
    H5Pset_layout(creation.id(), compact ? H5D_COMPACT : H5D_CONTIGUOUS);
    if (!compact) H5Pset_fill_time(creation.id(), H5D_FILL_TIME_NEVER);
    return creation;
}

void write_checksum(hid_t dataset, std::uint64_t checksum) {
    const Handle space = dataspace({});
    const Handle attribute(
        H5Acreate2(dataset, checksum_name, H5T_STD_U64LE, space.id(), H5P_DEFAULT, H5P_DEFAULT),
        H5Aclose);
    H5Awrite(attribute.id(), H5T_NATIVE_UINT64, &checksum);
}

/// True also where no checksum was stored.
bool matches_checksum(hid_t dataset, const void* values, std::size_t bytes) {
    if (H5Aexists(dataset, checksum_name) <= 0) return true;
    const Handle attribute(H5Aopen(dataset, checksum_name, H5P_DEFAULT), H5Aclose);
    std::uint64_t stored = 0;
    return H5Aread(attribute.id(), H5T_NATIVE_UINT64, &stored) >= 0 &&
           stored == checksum_of(values, bytes);
}

Shape shape_of(hid_t space) {
    const int rank = H5Sget_simple_extent_ndims(space);
    std::vector<hsize_t> extents(static_cast<std::size_t>(std::max(rank, 0)));
    if (rank > 0) H5Sget_simple_extent_dims(space, extents.data(), nullptr);
    return {extents.begin(), extents.end()};
}

std::string words(const Shape& shape) {
    return shape.empty() ? "a single value" : fmt::format("[{}]", fmt::join(shape, "]["));
}

void require_readable(const fs::path& path) {
    if (!fs::exists(path))
        throw FileError(fmt::format("{}: there is no such file; correct the path", path.string()));
    if (fs::is_directory(path))
        throw FileError(fmt::format("{}: is a folder; give the name of a file", path.string()));
}

/// The bytes of a file that was built in memory; valid until it is closed.
std::span<const std::byte> memory_image(hid_t file) {
    void** memory = nullptr;
    if (H5Fget_vfd_handle(file, H5P_DEFAULT, reinterpret_cast<void**>(&memory)) < 0) return {};
    const ssize_t size = H5Fget_file_image(file, nullptr, 0);
    if (size <= 0) return {};
    return {static_cast<const std::byte*>(*memory), static_cast<std::size_t>(size)};
}

/// Checksummed metadata (HDF5 1.8 and later read it), nothing on the disk.
Handle in_memory_access() {
    Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
    H5Pset_fapl_core(access.id(), std::size_t{1} << 20, false);
    H5Pset_libver_bounds(access.id(), H5F_LIBVER_V18, H5F_LIBVER_V110);
    return access;
}

}  // namespace

Handle::~Handle() {
    if (id_ >= 0) close_(id_);
}

Handle::Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}

Handle& Handle::operator=(Handle&& other) noexcept {
    std::swap(id_, other.id_);
    std::swap(close_, other.close_);
    return *this;
}

Group::Group(Handle handle, std::string file, std::string name)
    : handle_(std::move(handle)), file_(std::move(file)), name_(std::move(name)) {}

void Group::fail(std::string_view object, std::string_view what, std::string_view remedy) const {
    throw FileError(fmt::format("{}: {}/{}: {} ({}); {}", file_, name_, object, what,
                                innermost_reason(), remedy));
}

Group Group::open(std::string_view name) const {
    const std::string path(name);
    Handle group(H5Gopen2(handle_.id(), path.c_str(), H5P_DEFAULT), H5Gclose);
    if (group.id() < 0) fail(name, "there is no such group", damage_remedy);
    return {std::move(group), file_, name_ + "/" + path};
}

Group Group::create(std::string_view name) const {
    const std::string path(name);
    const Handle creation = object_creation(H5P_GROUP_CREATE);
    Handle group(H5Gcreate2(handle_.id(), path.c_str(), H5P_DEFAULT, creation.id(), H5P_DEFAULT),
                 H5Gclose);
    if (group.id() < 0) fail(name, "this group cannot be made", memory_remedy);
    return {std::move(group), file_, name_ + "/" + path};
}

bool Group::has(std::string_view name) const {
    for (std::size_t end = name.find('/');; end = name.find('/', end + 1)) {
        const std::string upto(name.substr(0, end));
        if (H5Lexists(handle_.id(), upto.c_str(), H5P_DEFAULT) <= 0) return false;
        if (end == std::string_view::npos) return true;
    }
}

void Group::write_numbers(std::string_view name, NumberType type, const void* values,
                          std::size_t count, const Shape& shape) const {
    if (product(shape) != count)
        throw FileError(fmt::format("{}: {}/{}: {} values given for a shape of {}; they must agree",
                                    file_, name_, name, count, words(shape)));
    const hid_t number = hdf5_type(type);
    const std::size_t bytes = count * H5Tget_size(number);
    const Handle space = dataspace(shape);
    const Handle creation = dataset_creation(bytes);
    const Handle dataset(H5Dcreate2(handle_.id(), std::string(name).c_str(), number, space.id(),
                                    H5P_DEFAULT, creation.id(), H5P_DEFAULT),
                         H5Dclose);
    if (dataset.id() < 0) fail(name, "this dataset cannot be made", memory_remedy);
    if (bytes == 0) return;
    if (H5Dwrite(dataset.id(), number, H5S_ALL, H5S_ALL, H5P_DEFAULT, values) < 0)
        fail(name, "its values cannot be written", memory_remedy);
    if (bytes > compact_limit) write_checksum(dataset.id(), checksum_of(values, bytes));
}

void Group::write_text(std::string_view name, std::string_view text) const {
    const std::string content = text.empty() ? std::string(1, '\0') : std::string(text);
    const Handle type = string_type(content.size(), H5T_CSET_UTF8);
    const Handle space = dataspace({});
    const Handle creation = dataset_creation(content.size());
    const Handle dataset(H5Dcreate2(handle_.id(), std::string(name).c_str(), type.id(), space.id(),
                                    H5P_DEFAULT, creation.id(), H5P_DEFAULT),
                         H5Dclose);
    if (dataset.id() < 0 ||
        H5Dwrite(dataset.id(), type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, content.data()) < 0)
        fail(name, "this text cannot be written", memory_remedy);
    if (content.size() > compact_limit)
        write_checksum(dataset.id(), checksum_of(content.data(), content.size()));
}

Handle Group::open_dataset(std::string_view name) const {
    Handle dataset(H5Dopen2(handle_.id(), std::string(name).c_str(), H5P_DEFAULT), H5Dclose);
    if (dataset.id() < 0) fail(name, "there is no such dataset", damage_remedy);
    return dataset;
}

Shape Group::shape(std::string_view name) const {
    const Handle dataset = open_dataset(name);
    const Handle space(H5Dget_space(dataset.id()), H5Sclose);
    if (space.id() < 0) fail(name, "its shape cannot be read", damage_remedy);
    return shape_of(space.id());
}

std::size_t Group::array_size(std::string_view name) const {
    const Shape found = shape(name);
    if (found.size() != 1)
        throw FileError(fmt::format("{}: {}/{}: has the shape {}, a list was expected; {}", file_,
                                    name_, name, words(found), damage_remedy));
    return found[0];
}

void Group::read_numbers(std::string_view name, NumberType type, void* values, std::size_t count,
                         const Shape& expected) const {
    const Shape found = shape(name);
    if (found != expected || product(expected) != count)
        throw FileError(fmt::format("{}: {}/{}: has the shape {}, {} was expected; {}", file_,
                                    name_, name, words(found), words(expected), damage_remedy));
    if (count == 0) return;
    const Handle dataset = open_dataset(name);
    const hid_t number = hdf5_type(type);
    if (H5Dread(dataset.id(), number, H5S_ALL, H5S_ALL, H5P_DEFAULT, values) < 0)
        fail(name, "its values cannot be read", damage_remedy);
    if (!matches_checksum(dataset.id(), values, count * H5Tget_size(number)))
        throw FileError(fmt::format(
            "{}: {}/{}: its values are not those that were saved (their checksum differs); use an "
            "earlier copy, or delete the attribute 'checksum' if the change was meant",
            file_, name_, name));
}

std::string Group::read_text(std::string_view name) const {
    const Handle dataset = open_dataset(name);
    const Handle type(H5Dget_type(dataset.id()), H5Tclose);
    if (H5Tget_class(type.id()) != H5T_STRING || H5Tis_variable_str(type.id()) != 0)
        fail(name, "is not a text of fixed length", damage_remedy);
    if (!shape(name).empty()) fail(name, "holds several texts, not one", damage_remedy);
    std::string text(H5Tget_size(type.id()), '\0');
    if (H5Dread(dataset.id(), type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, text.data()) < 0)
        fail(name, "its text cannot be read", damage_remedy);
    if (!matches_checksum(dataset.id(), text.data(), text.size()))
        fail(name, "its text is not the one that was saved", damage_remedy);
    text.resize(text.find_last_not_of('\0') + 1);
    return text;
}

void Group::write_number_attribute(std::string_view name, NumberType type, const void* values,
                                   const Shape& shape) const {
    const Handle space = dataspace(shape);
    const Handle attribute(H5Acreate2(handle_.id(), std::string(name).c_str(), hdf5_type(type),
                                      space.id(), H5P_DEFAULT, H5P_DEFAULT),
                           H5Aclose);
    if (attribute.id() < 0 || H5Awrite(attribute.id(), hdf5_type(type), values) < 0)
        fail(name, "this attribute cannot be written", memory_remedy);
}

void Group::write_attribute(std::string_view name, std::string_view text) const {
    const Handle type = string_type(text.size(), H5T_CSET_ASCII);
    const Handle space = dataspace({});
    const Handle attribute(H5Acreate2(handle_.id(), std::string(name).c_str(), type.id(),
                                      space.id(), H5P_DEFAULT, H5P_DEFAULT),
                           H5Aclose);
    const std::string content = text.empty() ? std::string(1, '\0') : std::string(text);
    if (attribute.id() < 0 || H5Awrite(attribute.id(), type.id(), content.data()) < 0)
        fail(name, "this attribute cannot be written", memory_remedy);
}

void Group::write_attribute(std::string_view name, std::span<const std::string_view> texts) const {
    std::size_t length = 1;
    for (const std::string_view text : texts) length = std::max(length, text.size());
    std::string content;
    for (const std::string_view text : texts) {
        content += text;
        content.append(length - text.size(), '\0');
    }
    const Handle type = string_type(length, H5T_CSET_ASCII);
    const Handle space = dataspace({texts.size()});
    const Handle attribute(H5Acreate2(handle_.id(), std::string(name).c_str(), type.id(),
                                      space.id(), H5P_DEFAULT, H5P_DEFAULT),
                           H5Aclose);
    if (attribute.id() < 0 || H5Awrite(attribute.id(), type.id(), content.data()) < 0)
        fail(name, "this attribute cannot be written", memory_remedy);
}

void Group::read_number_attribute(std::string_view name, NumberType type, void* values,
                                  std::size_t expected_size) const {
    const Handle attribute(H5Aopen(handle_.id(), std::string(name).c_str(), H5P_DEFAULT), H5Aclose);
    if (attribute.id() < 0) fail(name, "there is no such attribute", damage_remedy);
    const Handle space(H5Aget_space(attribute.id()), H5Sclose);
    const hssize_t found = H5Sget_simple_extent_npoints(space.id());
    if (found != static_cast<hssize_t>(expected_size))
        throw FileError(fmt::format("{}: {}/{}: has {} values, {} were expected; {}", file_, name_,
                                    name, found, expected_size, damage_remedy));
    if (H5Aread(attribute.id(), hdf5_type(type), values) < 0)
        fail(name, "this attribute cannot be read", damage_remedy);
}

void Group::link(std::string_view name, std::string_view target) const {
    if (H5Lcreate_hard(handle_.id(), std::string(target).c_str(), handle_.id(),
                       std::string(name).c_str(), H5P_DEFAULT, H5P_DEFAULT) < 0)
        fail(name, "this link cannot be made", memory_remedy);
}

void Group::show_last_frame(std::string_view name, std::string_view source) const {
    const Handle shown = open_dataset(source);
    const Handle source_space(H5Dget_space(shown.id()), H5Sclose);
    const Shape extents = shape_of(source_space.id());
    const std::vector<hsize_t> start = {extents.at(0) - 1, 0, 0};
    const std::vector<hsize_t> count = {1, extents.at(1), extents.at(2)};
    H5Sselect_hyperslab(source_space.id(), H5S_SELECT_SET, start.data(), nullptr, count.data(),
                        nullptr);
    const Handle space = dataspace({extents.at(1), extents.at(2)});
    const Handle creation = object_creation(H5P_DATASET_CREATE);
    H5Pset_virtual(creation.id(), space.id(), ".", std::string(source).c_str(), source_space.id());
    const Handle type(H5Dget_type(shown.id()), H5Tclose);
    const Handle dataset(H5Dcreate2(handle_.id(), std::string(name).c_str(), type.id(), space.id(),
                                    H5P_DEFAULT, creation.id(), H5P_DEFAULT),
                         H5Dclose);
    if (dataset.id() < 0) fail(name, "this virtual dataset cannot be made", memory_remedy);
}

void Group::refer(std::string_view dataset, std::string_view attribute,
                  std::string_view target) const {
    const Handle object = open_dataset(dataset);
    const Handle space = dataspace({});
    const Handle made(H5Acreate2(object.id(), std::string(attribute).c_str(), H5T_STD_REF_OBJ,
                                 space.id(), H5P_DEFAULT, H5P_DEFAULT),
                      H5Aclose);
    hobj_ref_t reference{};
    if (H5Rcreate(&reference, handle_.id(), std::string(target).c_str(), H5R_OBJECT, -1) < 0 ||
        H5Awrite(made.id(), H5T_STD_REF_OBJ, &reference) < 0)
        fail(attribute, "this reference cannot be made", memory_remedy);
}

Group open_file(const fs::path& path) {
    silence_hdf5();
    require_readable(path);
    const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
    H5Pset_file_locking(access.id(), true, true);  // file systems without locks are fine
    const Handle file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, access.id()), H5Fclose);
    if (file.id() < 0)
        throw FileError(
            fmt::format("{}: cannot be opened as an HDF5 file ({}); give a file that this program "
                        "saved, or an earlier copy",
                        path.string(), innermost_reason()));
    Handle root(H5Gopen2(file.id(), "/", H5P_DEFAULT), H5Gclose);
    if (root.id() < 0)
        throw FileError(fmt::format("{}: its root cannot be read ({}); {}", path.string(),
                                    innermost_reason(), damage_remedy));
    return {std::move(root), path.string(), ""};
}

void write_file(const fs::path& path, const std::function<void(const Group&)>& fill) {
    silence_hdf5();
    const Handle access = in_memory_access();
    const Handle creation = object_creation(H5P_FILE_CREATE);
    const Handle file(H5Fcreate("in memory", H5F_ACC_TRUNC, creation.id(), access.id()), H5Fclose);
    Handle handle(H5Gopen2(file.id(), "/", H5P_DEFAULT), H5Gclose);
    const Group root(std::move(handle), path.string(), "");
    if (root.handle_.id() < 0) root.fail("", "the file cannot be begun", memory_remedy);
    fill(root);
    if (H5Fflush(file.id(), H5F_SCOPE_LOCAL) < 0)
        root.fail("", "the file cannot be completed", memory_remedy);
    const std::span<const std::byte> image = memory_image(file.id());
    if (image.empty()) root.fail("", "the file cannot be completed", memory_remedy);
    write_whole_file(path, [&](FileSink& sink) { sink.write(image); });
}

}  // namespace jam::hdf5
