// SPDX-License-Identifier: BSD-3-Clause
// Files that are whole or absent: the one door through which the library writes to a disk.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <span>
#include <string_view>
#include <vector>

namespace jam {

/// Where the content of a file goes; collects small pieces into large writes.
class FileSink {
  public:
    /// Creates or empties the file at `path`. Throws FileError.
    explicit FileSink(const std::filesystem::path& path);
    ~FileSink();
    FileSink(const FileSink&) = delete;
    FileSink& operator=(const FileSink&) = delete;

    /// Throws FileError when the disk takes no more.
    void write(std::span<const std::byte> bytes);
    void write(std::string_view text) { write(std::as_bytes(std::span(text))); }

    /// Everything written reaches the disk before this returns. Throws FileError.
    void sync();

  private:
    void flush();
    void write_through(std::span<const std::byte> bytes);

    std::filesystem::path path_;
    int descriptor_;
    std::vector<std::byte> buffer_;
};

/// Makes the file at `path` hold what `fill` writes, or leaves it as it was: the content is written
/// to `path` + ".partial" in the same folder, synced to the disk, and renamed. When anything fails,
/// the exception passes on (FileError for the disk's own failures), the earlier file stays and no
/// partial one is left.
void write_whole_file(const std::filesystem::path& path,
                      const std::function<void(FileSink&)>& fill);

/// The same for content that is at hand.
void write_whole_file(const std::filesystem::path& path, std::string_view text);

/// Makes the folder and those above it where they are missing. Throws FileError, which ends in
/// `remedy`.
void make_folder(const std::filesystem::path& path, std::string_view remedy);

}  // namespace jam
