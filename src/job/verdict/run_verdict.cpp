// Looks at the end of the run first, then at doubts, then at the motion.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "job/verdict/run_verdict.hpp"

#include <algorithm>
#include <array>

#include "job/verdict/end_of_motion.hpp"

namespace keyblock {
namespace {

using Json = nlohmann::ordered_json;

struct MotionVerdict {
  MotionState motion;
  RunState state;
  std::string_view tone;
};

constexpr std::array<MotionVerdict, 5> kMotions{{{MotionState::at_rest, RunState::at_rest, "good"},
                                                 {MotionState::moving, RunState::moving, "warn"},
                                                 {MotionState::equilibrium, RunState::equilibrium, "good"},
                                                 {MotionState::no_equilibrium, RunState::no_equilibrium, "bad"},
                                                 {MotionState::not_equilibrium, RunState::not_equilibrium, "warn"}}};

Json member_at(const Json& of, const char* key) {
  return of.is_object() ? of.value(key, Json()) : Json();
}

std::string text_at(const Json& of, const char* key) {
  const Json found = member_at(of, key);
  return found.is_string() ? found.get<std::string>() : std::string();
}

}  // namespace

RunVerdict verdict_of(const Json& record) {
  if (!record.is_object()) return {RunState::unfinished, "run not finished", "plain"};
  const Json outcome = member_at(record, "outcome"), doubts = member_at(outcome, "doubts");
  const std::string end = text_at(outcome, "end"), motion = text_at(member_at(outcome, "motion"), "state");
  if (end == "failed") return {RunState::failed, "failed", "bad", text_at(outcome, "reason")};
  if (end != "finished") return {RunState::stopped, "stopped early", "warn", text_at(outcome, "ended_early")};
  if (doubts.is_array() && !doubts.empty())
    return {RunState::unreliable, "results unreliable", "bad",
            doubts[0].is_string() ? doubts[0].get<std::string>() : std::string()};
  const auto found = std::ranges::find(kMotions, motion, [](const MotionVerdict& own) { return word_for(own.motion); });
  if (found == kMotions.end()) return {RunState::finished, "finished", "plain"};
  return {found->state, words_for(found->motion), found->tone};
}

}  // namespace keyblock
