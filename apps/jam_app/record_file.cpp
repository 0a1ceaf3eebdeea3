// SPDX-License-Identifier: BSD-3-Clause
#include "jam_app/record_file.h"

#include "core/check.h"

#include <string>
#include <system_error>
#include <utility>

namespace jam::apps {

/// Bytes of the whole lines up to and with step `last`.
static std::uintmax_t kept_bytes(const std::filesystem::path& path, Count last) {
    std::ifstream in(path, std::ios::binary);
    std::uintmax_t kept = 0;
    std::string line;
    while (std::getline(in, line) && !in.eof()) {  // at the end of file: a line that was cut off
        if (record_from_json(line).step > last) break;
        kept += line.size() + 1;
    }
    return kept;
}

RecordFile::RecordFile(std::filesystem::path path, Count last) : path_(std::move(path)) {
    std::error_code failed;
    if (std::filesystem::exists(path_))
        std::filesystem::resize_file(path_, kept_bytes(path_, last), failed);
    out_.open(path_, std::ios::binary | std::ios::app);
    if (failed || !out_)
        throw FileError(
            fmt::format("{}: cannot be written; see to the rights of the folder", path_.string()));
}

void RecordFile::add(const Record& record) {
    out_ << json_line(record) << '\n' << std::flush;
    if (!out_)
        throw FileError(fmt::format("{}: the disk took no more; make room, then go on by --resume",
                                    path_.string()));
}

}  // namespace jam::apps
