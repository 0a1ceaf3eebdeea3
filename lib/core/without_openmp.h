// SPDX-License-Identifier: BSD-3-Clause
// Keeps libraries that bring OpenMP along (CHOLMOD) on the calling thread.
#pragma once

namespace jam {

/// While one lives, no OpenMP region of this thread runs on more than one thread: two pools of
/// threads on the same processors wait for each other.
class WithoutOpenMp {
  public:
    WithoutOpenMp();
    ~WithoutOpenMp();
    WithoutOpenMp(const WithoutOpenMp&) = delete;
    WithoutOpenMp& operator=(const WithoutOpenMp&) = delete;

  private:
    int levels_before_;
};

}  // namespace jam
