// SPDX-License-Identifier: BSD-3-Clause
// DIR/record.jsonl: one line of JSON for each record, for programs to read.
#pragma once

#include "jamming/record.h"

#include <filesystem>
#include <fstream>

namespace jam::apps {

class RecordFile {
  public:
    /// Opens the file to append to it, without the lines after step `last` (none: all are kept) and
    /// without a last line that is not whole. Throws FileError.
    RecordFile(std::filesystem::path path, Count last);

    /// The line is with the system when this returns. Throws FileError when the disk takes no more.
    void add(const Record& record);

  private:
    std::filesystem::path path_;
    std::ofstream out_;
};

}  // namespace jam::apps
