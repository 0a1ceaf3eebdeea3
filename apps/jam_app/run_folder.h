// SPDX-License-Identifier: BSD-3-Clause
// The folder of one run: what lies in it, and whether it may be used.
#pragma once

#include <filesystem>
#include <utility>

namespace jam::apps {

class RunFolder {
  public:
    explicit RunFolder(std::filesystem::path path) : path_(std::move(path)) {}
    ~RunFolder();
    RunFolder(const RunFolder&) = delete;
    RunFolder& operator=(const RunFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }
    std::filesystem::path packing() const { return path_ / "packing.h5"; }
    std::filesystem::path checkpoint() const { return path_ / "checkpoint.h5"; }
    std::filesystem::path record() const { return path_ / "record.jsonl"; }
    std::filesystem::path log() const { return path_ / "run.log"; }

    /// Throws InputError if a run lies here already, or if this is no folder.
    void require_free() const;

    /// Throws InputError unless a run with a checkpoint lies here.
    void require_checkpoint() const;

    /// Makes the folder where it is missing and keeps other programs out of it for as long as this
    /// lives. Throws InputError if one is in it, FileError if the folder cannot be made.
    void occupy();

  private:
    std::filesystem::path path_;
    int descriptor_ = -1;
};

}  // namespace jam::apps
