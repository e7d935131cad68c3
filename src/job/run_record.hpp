// Holds what the record of a run, run.json, says of its inputs, course and end.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "api/case_values.hpp"
#include "formats/case.hpp"
#include "job/folder/made_by.hpp"
#include "result/extremes.hpp"
#include "result/reaction_curve.hpp"
#include "result/step_record.hpp"
#include "run/run.hpp"

namespace keyblock {

/// Input file as run.json names it.
struct InputRecord {
  std::string file;
  std::string sha256;
  std::string format;
  std::string evidence;
  std::string setting = {};  ///< that names the file; empty: a file of the case
};

/// Support or load of the scene before the first step.
struct SupportRecord {
  std::string kind;  ///< fixed_point, loading_point, held_edge
  Point at;
  int block = 0;         ///< its number, from 1
  Point direction = {};  ///< of the component that a held edge prescribes there; of points (0, 0)
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

enum class MotionState {
  at_rest,          ///< dynamic: came to rest
  moving,           ///< dynamic: still moves
  equilibrium,      ///< statics: found
  no_equilibrium,   ///< statics: the search failed
  not_equilibrium,  ///< statics from zero velocity: not reached yet
};

/// End of a run. Numbers from 0.
struct EndOfMotion {
  MotionState state = MotionState::at_rest;
  /// Dynamic runs: greatest kinetic energy in the last tenth of the steps over the largest stored energy. Empty without
  /// an energy balance.
  std::optional<double> kinetic_share = {};
  double speed = 0;  ///< greatest of a vertex at the end [length/time]
  int fastest = 0;   ///< number of its element
  Point fastest_at = {};
  double least_share_of_way = 0;                   ///< statics: fraction of the way in the last tenth of the steps
  std::optional<std::size_t> farthest_point = {};  ///< place of the measured point that moved farthest, in the frame
  double farthest_point_way = 0;                   ///< its displacement [length]
};

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

}  // namespace keyblock
