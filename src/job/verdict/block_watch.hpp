// Watches single blocks during a run: sums over a scene hide a small one.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "base/archive.hpp"
#include "result/contact_frame.hpp"
#include "result/frame.hpp"
#include "result/ledger.hpp"
#include "step/stepper.hpp"

namespace keyblock {

/// Finds blocks that move faster than any source of energy permits, and blocks that contacts rotate by a large angle
/// within a step. Under the rules of Shi's programs, it also finds blocks that hang on contacts without tensile
/// strength.
class BlockWatch {
 public:
  /// Call both at the start and after every step. The row of the energy balance follows at the start, and precedes
  /// later.
  void add(const Stepper& stepper);
  void add(const LedgerRow& row);
  /// Call it with every frame: its contacts, and its model.
  void add(const Frame& frame, const ContactFrames& contacts, const Model& model, const Settings& settings);
  void describe(Archive& archive);

  /// Returns one doubt per kind, at `place`. `keeps_energy`: the work of loads is known.
  Warnings doubts(const Settings& settings, bool keeps_energy, const Place& place) const;

 private:
  /// Block whose kinetic energy exceeded its sources most.
  struct Thrown {
    double excess = 0;  ///< kinetic energy over that available from weight, loads and strains
    int number = 0;     ///< from 0
    int step = 0;
    Point at;
    double speed = 0;      ///< equivalent of its kinetic energy [length/time]
    double accounted = 0;  ///< speed available from its sources [length/time]
  };
  /// Block with the largest rotation in a step beyond that of its spin at the start of the step.
  struct Turned {
    double angle = 0;  ///< rad
    int number = 0;
    int step = 0;
    Point at;
  };
  /// Block of the last frame with the largest tension, among those that hung in more than half of the frames.
  struct Hanging {
    double share = 0;  ///< tension on it, over its weight
    double fall = 0;   ///< free fall during the run, over its size
    int number = 0;
    int other = 0;
    Point at;
  };

  void look_at_turn(const Stepper& stepper, ElementIndex e, double spin);
  void look_at_sources(const Stepper& stepper, ElementIndex e, Point weight);
  void look_at_speeds(const Stepper& stepper, const std::vector<Point>& weights);

  // Energies over mass [length²/time²].
  double begun_ = 0;     ///< greatest kinetic energy at the start, or of driven bodies
  double fallen_ = 0;    ///< greatest work of its weight on a block
  double released_ = 0;  ///< greatest loss of strain energy of a block
  double work_ = 0;      ///< of loads on all blocks, and of bolts and springs that were tight at the start [energy]
  bool has_row_ = false;
  std::vector<double> strained_;  ///< by number, greatest strain energy so far
  std::vector<double> kinetic_;   ///< of the current step, by element
  Thrown worst_;
  std::vector<double> rotations_;  ///< by number, at the end of the last step (rad)
  std::vector<double> spins_;      ///< by number, there [1/time]
  Turned turned_;
  int frames_ = 0;            ///< without the start
  std::vector<double> hung_;  ///< by number, frames in which the block hung
  Hanging last_;
};

}  // namespace keyblock
