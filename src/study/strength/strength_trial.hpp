// One run of statics at a factor of strength reduction: whether it stands, and what moves where it does not.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "api/plan.hpp"
#include "api/strength_choice.hpp"
#include "cut/bodies/slivers.hpp"
#include "result/field_frame.hpp"
#include "result/frame.hpp"
#include "run/verdict/far_from_drawing.hpp"
#include "study/strength/reduced_problem.hpp"

namespace keyblock::study {

/// undecided: statics came to no end, so that nothing is known of the scene at this factor.
enum class Verdict { stands, falls, undecided };

/// A word for tables: "stands".
std::string name_of(Verdict verdict);

/// What a table of trials says of one.
struct StrengthTrial {
  double factor = 1;
  Verdict verdict = Verdict::undecided;
  bool is_balanced = false;   ///< an equilibrium with all loads on was found
  bool is_far = false;        ///< a body lies too far from the drawing in it: see factor_of_safety.hpp
  bool is_past_knee = false;  ///< displacements have grown, whether or not it stands: see factor_of_safety.hpp
  std::string why;            ///< in a sentence, if it does not stand or is past the knee
  /// Largest of a corner since the start; where there is no equilibrium, at the point where the search was given up.
  double displacement = 0;
  CarriedBlock farthest = {};  ///< beside its width, in the equilibrium; without one its way is 0
  int rounds = 0;              ///< solves of contact forces or Newton iterations
  long long systems = 0;       ///< linear systems: the cost of the trial, whatever the machine
};

/// A state as pictures show it.
struct StrengthState {
  Frame frame;
  FieldFrame field;
  std::vector<double> plastic_strains;  ///< κ in the middle of each element of the field
};

struct TrialOutcome {
  StrengthTrial told;
  StrengthState state;                ///< the last equilibrium
  std::optional<FieldFrame> attempt;  ///< where a trial that falls had come to, out of balance
  bool rock_yields = false;           ///< as StepFailure has it, of the step that found no equilibrium
  std::vector<int> restless = {};     ///< numbers, from 0, of the blocks for which there is none
};

/// A block is loose where it falls by itself and is smaller than this share of the mean area: what `slivers` warns of.
inline constexpr double kLooseArea = kSliverArea;
/// All that are left out may have this share of the area of all blocks: a tenth of the width of bracket that is sought
/// unless asked otherwise, so that the weight that goes with them is no more than that to the factor.
inline constexpr double kLooseInAll = 1e-3;

/// Makes trials of one problem. Statics of profile `standard`, whatever the case asks for: a case of motion in time
/// becomes one of equilibrium under its loads, in one step where they do not change (10 on covers).
class StrengthTrials {
 public:
  /// Throws InputError for a problem that cannot be prepared, or has nothing to reduce; std::invalid_argument for a
  /// profile or an override that is none.
  StrengthTrials(ConfiguredCase made, Reduced what, Exempt exempt = {});

  const Problem& problem() const { return made_.problem; }
  Reduced what() const { return what_; }
  const Exempt& exempt() const { return exempt_; }
  /// Returns true if elastoplastic rock of NMM bodies is reduced, so that the factor depends on their mesh.
  bool depends_on_mesh() const;
  /// The same trials on a mesh whose sides are `times` as long. Throws InputError if there is no such mesh.
  StrengthTrials on_coarser_mesh(double times) const;
  /// As at the factor 1.
  const Prepared& prepared() const { return prepared_; }
  /// Sentences on how the case was changed to be one of statics.
  const std::vector<std::string>& notes() const { return notes_; }

  /// Whether these blocks (numbers from 0), with those left out before, may be left out: blocks of a scene without
  /// stages that are small by both measures and carry no point and no bolt.
  bool may_leave_out(const std::vector<int>& blocks) const;
  /// Takes them away; a note says so. The others keep their numbers.
  void leave_out(const std::vector<int>& blocks);
  const std::vector<int>& left_out() const { return left_out_; }

  /// From no load. Beginning at the equilibrium of another trial was tried on rock: what stands takes twice as many
  /// rounds, what falls three times, and where ψ < φ the factor becomes another. Beyond `most_systems` linear systems
  /// it is given up as undecided. Throws StopRequested.
  TrialOutcome run(double factor, std::optional<long long> most_systems = std::nullopt) const;

 private:
  TrialOutcome decided(double factor) const;
  void note_exempt(const ExemptCount& held);
  Prepared prepared_at(double factor, ExemptCount* held = nullptr) const;
  bool may_yield() const;

  ConfiguredCase made_;
  Reduced what_;
  Exempt exempt_;
  std::vector<std::string> notes_;
  Prepared prepared_;
  std::optional<Blocks> whole_;  ///< all blocks, once some are left out
  std::vector<int> left_out_;    ///< their numbers, from 0
};

}  // namespace keyblock::study
