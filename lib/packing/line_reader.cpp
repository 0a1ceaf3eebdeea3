// SPDX-License-Identifier: BSD-3-Clause
#include "packing/line_reader.h"

#include "core/check.h"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <system_error>
#include <unistd.h>

namespace jam {

namespace {

constexpr std::size_t longest_line = std::size_t{1} << 20;

[[noreturn]] void fail_to_read(const std::filesystem::path& path, int error) {
    throw FileError(fmt::format("{}: cannot be read ({}); correct the path or the permissions",
                                path.string(), std::generic_category().message(error)));
}

}  // namespace

LineReader::LineReader(const std::filesystem::path& path)
    : path_(path), descriptor_(::open(path.c_str(), O_RDONLY | O_CLOEXEC)), buffer_(longest_line) {
    if (descriptor_ < 0) fail_to_read(path_, errno);
}

LineReader::~LineReader() {
    ::close(descriptor_);
}

/// Moves what is left to the front and fills up behind it; false at the end of the file.
bool LineReader::refill() {
    std::memmove(buffer_.data(), buffer_.data() + begin_, end_ - begin_);
    buffer_start_ += static_cast<Count>(begin_);
    end_ -= begin_;
    begin_ = 0;
    if (end_ == buffer_.size()) {
        ++number_;
        fail("this line is longer than a line of a text file; give a file of the right kind");
    }
    ssize_t got = 0;
    do got = ::read(descriptor_, buffer_.data() + end_, buffer_.size() - end_);
    while (got < 0 && errno == EINTR);
    if (got < 0) fail_to_read(path_, errno);
    end_ += static_cast<std::size_t>(got);
    return got > 0;
}

bool LineReader::next() {
    const char* newline = nullptr;
    std::size_t searched = 0;
    while (newline == nullptr) {
        newline = static_cast<const char*>(
            std::memchr(buffer_.data() + begin_ + searched, '\n', end_ - begin_ - searched));
        searched = end_ - begin_;
        if (newline == nullptr && !refill()) break;
    }
    if (newline == nullptr && searched == 0) return false;
    const std::size_t length =
        newline == nullptr ? searched : static_cast<std::size_t>(newline - &buffer_[begin_]);
    line_ = {buffer_.data() + begin_, length};
    begin_ += newline == nullptr ? length : length + 1;
    ++number_;
    if (line_.ends_with('\r')) line_.remove_suffix(1);
    return true;
}

void LineReader::go_to(const Place& place) {
    if (::lseek(descriptor_, place.byte, SEEK_SET) < 0) fail_to_read(path_, errno);
    buffer_start_ = place.byte;
    begin_ = end_ = 0;
    number_ = place.lines_before;
}

void LineReader::fail(std::string_view problem) const {
    throw InputError(fmt::format("{}:{}: {}", path_.string(), number_, problem));
}

}  // namespace jam
