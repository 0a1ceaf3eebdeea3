// SPDX-License-Identifier: BSD-3-Clause
// From a start to a jammed packing: the protocol as a whole.
#pragma once

#include "core/stage_times.h"
#include "jamming/convergence.h"
#include "jamming/jam_state.h"
#include "jamming/record.h"
#include "jamming/scene.h"
#include "jamming/verdict.h"

#include <functional>
#include <optional>
#include <string>

namespace jam {

/// What the library tells its caller while it runs; each may be empty. They are called between
/// steps, on the calling thread.
struct JamHooks {
    std::function<void(const Record&, const Verdict&)> on_record = {};
    /// The state is whole and may be written; a run that goes on from it has the same bits.
    std::function<void(const JamState&)> on_checkpoint = {};
    /// Asked after every step; true ends the run with its state whole.
    std::function<bool()> stop_requested = {};
};

enum class JamOutcome : std::uint8_t { converged, step_limit, time_limit, interrupted };

struct JamResult {
    JamOutcome outcome = JamOutcome::interrupted;
    Verdict verdict;          ///< of the final state
    Measurement measurement;  ///< of the final state; its packing is what is to be saved
    StageTimes times;
};

/// Throws InputError if the time step that the scene asks for is above stability_limit
/// (nph_step.h), with the masses and the damping of its protocol. jam_packing asks the same.
void require_stable_time_step(const Scene& scene, const JamState& state);

/// What a state from a checkpoint comes to when it needs no further step: it is at a limit or, by
/// the scene as it is now, converged. nullopt where it is to go on.
std::optional<JamResult> ending_without_a_step(const Scene& scene, const JamState& state);

/// Runs `state` by the scene's protocol until it is converged, a limit is reached or a stop is
/// requested. `state` is a start_state or what a checkpoint held; afterwards it is whole, and may
/// go on. Records are made every run.record_interval steps and at the end. Throws InputError when
/// the motion blows up (a time step beyond the stability limit).
JamResult jam_packing(const Scene& scene, JamState& state, const JamHooks& hooks = {});

}  // namespace jam
