// SPDX-License-Identifier: BSD-3-Clause
// A text file line by line, in memory that does not grow with the file.
#pragma once

#include "core/types.h"

#include <filesystem>
#include <string_view>
#include <vector>

namespace jam {

class LineReader {
  public:
    /// Throws FileError if the file cannot be opened.
    explicit LineReader(const std::filesystem::path& path);
    ~LineReader();
    LineReader(const LineReader&) = delete;
    LineReader& operator=(const LineReader&) = delete;

    /// Goes to the next line; false at the end of the file. Throws FileError if the disk fails and
    /// InputError for a line too long to be one of a text file.
    bool next();

    /// The current line, without its end; valid until next().
    std::string_view line() const { return line_; }
    Count number() const { return number_; }

    /// Where the line after the current one begins, to come back to.
    struct Place {
        Count byte = 0;
        Count lines_before = 0;
    };
    Place place() const { return {buffer_start_ + static_cast<Count>(begin_), number_}; }
    void go_to(const Place& place);

    /// Throws InputError: file, number of the current line, and `problem`, which says what was
    /// expected and the remedy.
    [[noreturn]] void fail(std::string_view problem) const;

  private:
    bool refill();

    std::filesystem::path path_;
    int descriptor_;
    std::vector<char> buffer_;
    std::size_t begin_ = 0;   ///< of what is not yet read, in buffer_
    std::size_t end_ = 0;     ///< of what is filled
    Count buffer_start_ = 0;  ///< place of buffer_[0] in the file
    std::string_view line_;
    Count number_ = 0;
};

}  // namespace jam
