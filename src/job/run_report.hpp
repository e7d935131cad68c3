// Builds the record of a run, run.json: inputs, choices and results. Its keys are stable.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "api/case_values.hpp"
#include "base/counted.hpp"
#include "formats/case.hpp"
#include "job/folder/made_by.hpp"
#include "job/verdict/end_of_motion.hpp"
#include "result/extremes.hpp"
#include "result/reaction_curve.hpp"
#include "result/step_record.hpp"
#include "run/prepare.hpp"
#include "run/run.hpp"

namespace keyblock {

/// Input file as run.json names it.
struct InputRecord {
  std::string file;
  std::string sha256;
  std::string format;
  std::string evidence;
};

/// Support or load of the scene before the first step.
struct SupportRecord {
  std::string kind;  ///< fixed_point, loading_point
  Point at;
  int block = 0;  ///< its number, from 1
};

/// Wall time of each phase [s].
struct Timings {
  double read = 0;
  double prepare = 0;  ///< cutting and building the model
  double run = 0;      ///< steps, and the frames written on the way
};

/// Progress of a static run: `share` of the way to equilibrium; nothing if its steps show no sign of one.
struct EquilibriumWay {
  std::optional<double> share;
  double last_step_ratio = 0;  ///< the last step over the one before; 0 if each step is an equilibrium
};

/// Progress from which a static run counts as in equilibrium.
inline constexpr double kNearEquilibrium = 0.99;

struct RunRecord {
  std::string profile;
  std::string profile_because;  ///< reason for the choice of profile
  Units units = {};             ///< declared by the case
  std::vector<InputRecord> inputs;
  std::vector<ChangedValue> values = {};  ///< of the case file, changed after reading
  StepTotals totals;
  StepRows steps;
  std::vector<StepReport> traced;  ///< every step, if a trace is requested
  LedgerSums ledger_sums;
  LedgerRows ledger;
  RunOutcome outcome;
  Extremes extremes;                            ///< of the last frame
  std::optional<PlasticExtremes> plastic = {};  ///< of the last frame, if rock is elastoplastic
  std::vector<ReactionCurve> reactions = {};    ///< of edges driven by load steps of elastoplastic rock
  bool is_static = false;
  std::optional<EquilibriumWay> equilibrium_way;  ///< of completed static runs
  std::optional<EndOfMotion> motion = {};         ///< empty if the run has no step
  Timings timings;
  Warnings warnings;
  double energy_created = 0;  ///< over the largest stored energy, for comparison with `energy_limit`
  Warnings doubts;            ///< reasons to distrust a completed run; also among `warnings`
  int record_every = 1;
  std::vector<int> left_out = {};  ///< numbers, from 0, of elements that the pictures leave out
  std::vector<int> held = {};      ///< numbers, from 0, of blocks with a fixed point at the end
  formats::MaterialNames names = {};
  std::vector<SupportRecord> supports = {};
  std::vector<std::string> outputs;  ///< file names in the run's folder
  Checksums checksums = {};          ///< of outputs and frames
};

/// "no_equilibrium", "undecided" or "cracks".
const char* word_for(FailureKind kind);

/// Option of `run`, and its effect with the verb first: "shows the motion".
struct Remedy {
  std::string option;
  std::string what;
};

/// Returns options to try after a failed run; empty if no remedy is known.
std::vector<Remedy> what_to_try(const Prepared& prepared, const RunOutcome& outcome);

nlohmann::ordered_json inputs_json(const std::vector<InputRecord>& inputs);

/// Returns every warning with its place and its values.
nlohmann::ordered_json warning_list_json(const Warnings& warnings);

/// Returns name, count and first occurrence of each kind of warning, with the values of the first.
nlohmann::ordered_json warnings_json(const Warnings& warnings);

/// Returns every setting by its name.
nlohmann::ordered_json all_settings_json(const Settings& settings);

nlohmann::ordered_json requirements_json(const Requirements& requirements);

nlohmann::ordered_json run_json(const Prepared& prepared, const RunRecord& record);

}  // namespace keyblock
