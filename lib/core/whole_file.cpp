// SPDX-License-Identifier: BSD-3-Clause
#include "core/whole_file.h"

#include "core/check.h"

#include <cerrno>
#include <fcntl.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace jam {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t buffer_size = std::size_t{1} << 20;

std::string_view remedy_of(int error) {
    switch (error) {
        case ENOSPC:
        case EDQUOT:
            return "free some space or choose another folder";
        case EFBIG:
            return "raise the limit on file sizes (ulimit -f) or choose another disk";
        case EACCES:
        case EPERM:
        case EROFS:
            return "choose a folder that you may write to";
        case ENOENT:
            return "make the folder first, or correct the path";
        case ENOTDIR:
            return "a part of the path is a file; correct the path";
        default:
            return "check the disk and the path";
    }
}

[[noreturn]] void fail(const fs::path& path, std::string_view what, int error) {
    throw FileError(fmt::format("{}: {} ({}); {}", path.string(), what,
                                std::generic_category().message(error), remedy_of(error)));
}

fs::path folder_of(const fs::path& path) {
    return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

/// The file that `path` means in the end, so that a link stays a link when its file is replaced.
fs::path target_of(const fs::path& path) {
    std::error_code error;
    fs::path target = fs::weakly_canonical(path, error);
    if (error) return path;
    const fs::file_status status = fs::status(target, error);
    if (fs::is_directory(status))
        throw FileError(fmt::format("{}: is a folder; give the name of a file", path.string()));
    if (fs::exists(status) && !fs::is_regular_file(status))
        throw FileError(
            fmt::format("{}: is a device or a pipe, which cannot be replaced as a "
                        "whole; give the name of a file",
                        path.string()));
    return target;
}

/// A rename survives a power cut only once the folder itself is on the disk.
void sync_folder(const fs::path& folder) {
    const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor < 0) return;  // a folder that may be written but not read
    const int error = ::fsync(descriptor) == 0 ? 0 : errno;
    ::close(descriptor);
    // Some file systems cannot sync a folder and say EINVAL; they order a rename by themselves.
    if (error != 0 && error != EINVAL) fail(folder, "cannot be synced to the disk", error);
}

/// Removes a file at the end of a scope unless it was released before.
class RemovedUnlessReleased {
  public:
    explicit RemovedUnlessReleased(const fs::path& path) : path_(path) {}
    ~RemovedUnlessReleased() {
        if (!released_) ::unlink(path_.c_str());
    }
    RemovedUnlessReleased(const RemovedUnlessReleased&) = delete;
    RemovedUnlessReleased& operator=(const RemovedUnlessReleased&) = delete;
    void release() { released_ = true; }

  private:
    fs::path path_;
    bool released_ = false;
};

}  // namespace

FileSink::FileSink(const fs::path& path)
    : path_(path),
      descriptor_(::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666)) {
    if (descriptor_ < 0) fail(path_, "cannot be created", errno);
    buffer_.reserve(buffer_size);
}

FileSink::~FileSink() {
    ::close(descriptor_);
}

void FileSink::write(std::span<const std::byte> bytes) {
    if (buffer_.size() + bytes.size() > buffer_size) flush();
    if (bytes.size() >= buffer_size) return write_through(bytes);
    buffer_.insert(buffer_.end(), bytes.begin(), bytes.end());
}

void FileSink::flush() {
    write_through(buffer_);
    buffer_.clear();
}

void FileSink::write_through(std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) fail(path_, "cannot be written", errno);
        bytes = bytes.subspan(static_cast<std::size_t>(written));
    }
}

void FileSink::sync() {
    flush();
    if (::fsync(descriptor_) != 0) fail(path_, "cannot be synced to the disk", errno);
}

void write_whole_file(const fs::path& path, const std::function<void(FileSink&)>& fill) {
    const fs::path target = target_of(path);
    const fs::path partial = target.string() + ".partial";
    FileSink sink(partial);
    RemovedUnlessReleased cleanup(partial);
    fill(sink);
    sink.sync();
    if (::rename(partial.c_str(), target.c_str()) != 0) fail(path, "cannot be replaced", errno);
    cleanup.release();
    sync_folder(folder_of(target));
}

void write_whole_file(const fs::path& path, std::string_view text) {
    write_whole_file(path, [&](FileSink& sink) { sink.write(text); });
}

void make_folder(const fs::path& path, std::string_view remedy) {
    std::error_code failed;
    fs::create_directories(path, failed);
    if (failed)
        throw FileError(fmt::format("{}: the folder cannot be made ({}); {}", path.string(),
                                    failed.message(), remedy));
}

}  // namespace jam
