// The record of a run, run.json: what went in, what was chosen, what came out. Its keys are stable.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "base/counted.hpp"
#include "formats/case.hpp"
#include "job/verdict/end_of_motion.hpp"
#include "result/extremes.hpp"
#include "result/reaction_curve.hpp"
#include "result/step_record.hpp"
#include "run/prepare.hpp"
#include "run/run.hpp"

namespace keyblock {

/// An input file as run.json names it.
struct InputRecord {
  std::string file;
  std::string sha256;
  std::string format;
  std::string evidence;
};

/// Seconds of wall time.
struct Timings {
  double read = 0;
  double prepare = 0;  ///< cutting and building the model
  double run = 0;      ///< steps, and the frames written on the way
};

/// How far a static run came: `share` of the way to equilibrium, none where its steps show no sign of one.
struct EquilibriumWay {
  std::optional<double> share;
  double last_step_ratio = 0;  ///< the last step over the one before; 0 where each step is an equilibrium
};

/// A static run that has come this far is in equilibrium.
inline constexpr double kNearEquilibrium = 0.99;

struct RunRecord {
  std::string profile;
  std::string profile_because;  ///< why it is the one
  Units units = {};             ///< that the case declares
  std::vector<InputRecord> inputs;
  StepTotals totals;
  StepRows steps;
  std::vector<StepReport> traced;  ///< every step, where a trace is asked for
  LedgerSums ledger_sums;
  LedgerRows ledger;
  RunOutcome outcome;
  Extremes extremes;                            ///< of the last frame
  std::optional<PlasticExtremes> plastic = {};  ///< of the last frame, where rock may yield
  std::vector<ReactionCurve> reactions = {};    ///< of edges that load steps of such rock drive
  bool is_static = false;
  std::optional<EquilibriumWay> equilibrium_way;  ///< of static runs that came to their end
  std::optional<EndOfMotion> motion = {};         ///< none of a run without a step
  Timings timings;
  Warnings warnings;
  double energy_created = 0;  ///< over the largest stored energy, as `energy_limit` judges it
  Warnings doubts;            ///< why a run that came to its end is not trusted; among `warnings` too
  int record_every = 1;
  std::vector<int> left_out = {};    ///< numbers, from 0, of elements that the pictures leave out
  std::vector<int> held = {};        ///< numbers, from 0, of blocks with a fixed point at the end
  std::vector<std::string> outputs;  ///< file names in the run's folder
};

/// An option of `run`, and its effect with the verb first: "shows the motion".
struct Remedy {
  std::string option;
  std::string what;
};

/// What to try where a run failed; empty where nothing is known to help.
std::vector<Remedy> what_to_try(const Prepared& prepared, const RunOutcome& outcome);

nlohmann::ordered_json inputs_json(const std::vector<InputRecord>& inputs);

/// Every warning with its place.
nlohmann::ordered_json warning_list_json(const Warnings& warnings);

/// Warnings as name, count and the first of each.
nlohmann::ordered_json warnings_json(const Warnings& warnings);

/// Every setting by its name.
nlohmann::ordered_json all_settings_json(const Settings& settings);

nlohmann::ordered_json requirements_json(const Requirements& requirements);

nlohmann::ordered_json run_json(const Prepared& prepared, const RunRecord& record);

}  // namespace keyblock
