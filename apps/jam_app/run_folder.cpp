// SPDX-License-Identifier: BSD-3-Clause
#include "jam_app/run_folder.h"

#include "core/check.h"
#include "core/whole_file.h"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <string>
#include <sys/file.h>
#include <system_error>
#include <unistd.h>

namespace jam::apps {

RunFolder::~RunFolder() {
    if (descriptor_ >= 0) close(descriptor_);  // and with it goes the lock
}

void RunFolder::require_free() const {
    std::error_code none;
    const auto status = std::filesystem::status(path_, none);
    require(!std::filesystem::exists(status) || std::filesystem::is_directory(status),
            "{}: must be a folder, and a file has this name; give another by --out",
            path_.string());
    for (const auto& file : {checkpoint(), packing(), record()})
        require(!std::filesystem::exists(file, none),
                "{}: holds a run already ({}); go on with it by --resume, or give another "
                "folder by --out",
                path_.string(), file.filename().string());
}

void RunFolder::require_checkpoint() const {
    require(std::filesystem::is_regular_file(checkpoint()),
            "--resume: no run with a checkpoint lies in {}; leave out --resume to start one, or "
            "give its folder by --out",
            path_.string());
}

static std::string reason() {
    return std::strerror(errno);
}

void RunFolder::occupy() {
    make_folder(path_, "give another by --out");
    descriptor_ = open(path_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor_ < 0)
        throw FileError(fmt::format("{}: the folder cannot be opened ({}); give another by --out",
                                    path_.string(), reason()));
    require(flock(descriptor_, LOCK_EX | LOCK_NB) == 0,
            "{}: another jam_app is at work in this folder; wait for it, or give another by --out",
            path_.string());
}

}  // namespace jam::apps
