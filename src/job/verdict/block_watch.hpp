// Watches single blocks through a run: sums over a scene hide a small one.
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

/// Looks for blocks that move faster than anything could make them move, for blocks that contacts turn by a large angle
/// within a step, and, under the rules of Shi's programs, for blocks that hang on contacts without tensile strength.
class BlockWatch {
 public:
  /// At the start and after every step; the row of the ledger of that instant follows at the start, and precedes later.
  void add(const Stepper& stepper);
  void add(const LedgerRow& row);
  /// With every frame: its contacts, and its model.
  void add(const Frame& frame, const ContactFrames& contacts, const Model& model, const Settings& settings);
  void describe(Archive& archive);

  /// One doubt for each of these, at `place`. `keeps_energy`: the work of loads was known.
  Warnings doubts(const Settings& settings, bool keeps_energy, const Place& place) const;

 private:
  /// The block whose kinetic energy exceeded its sources most.
  struct Thrown {
    double excess = 0;  ///< kinetic energy over what weight, loads and strains can give
    int number = 0;     ///< from 0
    int step = 0;
    Point at;
    double speed = 0;      ///< that its kinetic energy amounts to [length/time]
    double accounted = 0;  ///< speed that its sources give [length/time]
  };
  /// The block that turned most in a step beside what its spin at the start of the step accounts for.
  struct Turned {
    double angle = 0;  ///< rad
    int number = 0;
    int step = 0;
    Point at;
  };
  /// The block of the last frame that hung most, of those that hung in more than half of the frames.
  struct Hanging {
    double share = 0;  ///< tension that it hangs on, over its weight
    double fall = 0;   ///< over its size, in the time of the run if nothing bore it
    int number = 0;
    int other = 0;
    Point at;
  };

  void look_at_turn(const Stepper& stepper, ElementIndex e, double spin);
  void look_at_sources(const Stepper& stepper, ElementIndex e, Point weight);
  void look_at_speeds(const Stepper& stepper, const std::vector<Point>& weights);

  // Energies over mass [length²/time²].
  double begun_ = 0;     ///< greatest kinetic energy at the start, or of what is driven
  double fallen_ = 0;    ///< greatest work of its weight on a block
  double released_ = 0;  ///< greatest loss of strain energy of a block
  double work_ = 0;      ///< of loads on all blocks, and of bolts and springs that were tight at the start [energy]
  bool has_row_ = false;
  std::vector<double> strained_;  ///< by number, greatest strain energy so far
  std::vector<double> kinetic_;   ///< of the step at hand, by element
  Thrown worst_;
  std::vector<double> rotations_;  ///< by number, at the end of the last step (rad)
  std::vector<double> spins_;      ///< by number, there [1/time]
  Turned turned_;
  int frames_ = 0;            ///< but the start
  std::vector<double> hung_;  ///< by number, frames in which the block hung
  Hanging last_;
};

}  // namespace keyblock
