// SPDX-License-Identifier: BSD-3-Clause
#include "jam_app/stop_signal.h"

#include <csignal>

namespace jam::apps {

// A signal handler can reach nothing but a global.
static volatile std::sig_atomic_t signal_that_came = 0;

static void note_signal(int signal) {
    signal_that_came = signal;
    std::signal(signal, SIG_DFL);
}

StopSignal::StopSignal() {
    signal_that_came = 0;
    std::signal(SIGINT, note_signal);
    std::signal(SIGTERM, note_signal);
}

StopSignal::~StopSignal() {
    std::signal(SIGINT, SIG_DFL);
    std::signal(SIGTERM, SIG_DFL);
}

bool StopSignal::came() const {
    return signal_that_came != 0;
}

std::string StopSignal::name() const {
    return signal_that_came == SIGINT ? "Ctrl-C" : "SIGTERM";
}

}  // namespace jam::apps
