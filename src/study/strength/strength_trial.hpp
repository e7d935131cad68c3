// Makes one static run at a factor of strength reduction: decides whether it stands, and names moving blocks otherwise.
// Theory: docs/theory/11-strength-reduction.md.
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
#include "settings/settings_table.hpp"
#include "study/strength/reduced_problem.hpp"

namespace keyblock::study {

/// Result of a trial. undecided: statics did not finish, so that nothing is known at this factor.
enum class Verdict { stands, falls, undecided };

/// Returns a word for tables: "stands".
std::string name_of(Verdict verdict);

/// Row of the table of trials.
struct StrengthTrial {
  double factor = 1;
  Verdict verdict = Verdict::undecided;
  bool is_balanced = false;   ///< an equilibrium under all loads was found
  bool is_far = false;        ///< a body is too far from the drawing in it: see factor_of_safety.hpp
  bool is_past_knee = false;  ///< displacements have grown, in equilibrium or not: see factor_of_safety.hpp
  double growth = 1;          ///< displacement over that of the first equilibrium, if it is past the knee
  double growth_from = 1;     ///< factor of that equilibrium
  std::string why;            ///< in a sentence, if it does not stand or is past the knee
  /// Largest displacement of a corner since the start; without an equilibrium, at the end of the search.
  double displacement = 0;
  CarriedBlock farthest = {};  ///< relative to its width, in the equilibrium; without one its `way` is 0
  int rounds = 0;              ///< solves of contact forces or Newton iterations
  long long systems = 0;       ///< linear systems: machine-independent cost of the trial
};

/// State as shown in pictures.
struct StrengthState {
  Frame frame;
  FieldFrame field;
  std::vector<double> plastic_strains;  ///< κ in the middle of each element of the field
};

struct TrialOutcome {
  StrengthTrial told;
  StrengthState state;                      ///< last equilibrium
  std::optional<FieldFrame> attempt;        ///< end of a trial that falls, out of balance
  std::optional<Frame> attempt_frame = {};  ///< the same state
  bool rock_yields = false;                 ///< as in StepFailure, for the step without equilibrium
  std::vector<int> restless = {};           ///< numbers, from 0, of the blocks without equilibrium
};

/// Area relative to the mean below which a block that falls alone is loose: the limit of the `slivers` warning.
inline constexpr double kLooseArea = kSliverArea;
/// Greatest area of all omitted blocks over that of all blocks: a tenth of the default bracket width. The missing
/// weight then changes the factor by no more than that.
inline constexpr double kLooseInAll = 1e-3;

/// Makes trials of one problem. Statics of profile `standard` replaces the dynamics of the case: the equilibrium under
/// its loads is sought. Constant loads take one step (10 with NMM bodies).
class StrengthTrials {
 public:
  /// Prepares the trials. Throws InputError for a problem that cannot be prepared, or has nothing to reduce;
  /// std::invalid_argument for an invalid profile or override.
  StrengthTrials(ConfiguredCase made, Reduced what, Exempt exempt = {});

  /// Returns the case with the settings of the trials.
  const ConfiguredCase& made() const { return made_; }
  /// Returns the settings of the case that the trials replace, with the values that the case has.
  const std::vector<SettingText>& replaced() const { return replaced_; }
  const Problem& problem() const { return made_.problem; }
  Reduced what() const { return what_; }
  const Exempt& exempt() const { return exempt_; }
  /// Returns true if elastoplastic rock of NMM bodies is reduced, so that the factor depends on their mesh.
  bool depends_on_mesh() const;
  /// Returns the same trials on a mesh whose sides are `times` as long. Throws InputError if there is no such mesh.
  StrengthTrials on_coarser_mesh(double times) const;
  /// Returns the case at the factor 1.
  const Prepared& prepared() const { return prepared_; }
  /// Returns sentences on the changes that made the case static.
  const std::vector<std::string>& notes() const { return notes_; }

  /// Returns true if these blocks (numbers from 0), with those already omitted, may be left out. They must belong to a
  /// scene without stages, be small by both measures, and hold no point and no bolt.
  bool may_leave_out(const std::vector<int>& blocks) const;
  /// Removes the blocks, with a note. The others keep their numbers.
  void leave_out(const std::vector<int>& blocks);
  const std::vector<int>& left_out() const { return left_out_; }

  /// Runs a trial from zero load. A start at the equilibrium of another trial was tried on rock. Stable trials then
  /// take twice as many iterations, unstable ones three times, and the factor changes if ψ < φ. After `most_systems`
  /// linear systems the trial is given up as undecided. Throws StopRequested.
  TrialOutcome run(double factor, std::optional<long long> most_systems = std::nullopt) const;

 private:
  TrialOutcome decided(double factor) const;
  void replace_setting(const Settings& of_case, const char* name, const std::string& value);
  void note_exempt(const ExemptCount& held);
  Prepared prepared_at(double factor, ExemptCount* held = nullptr) const;
  bool may_yield() const;

  ConfiguredCase made_;
  Reduced what_;
  Exempt exempt_;
  std::vector<SettingText> replaced_;
  std::vector<std::string> notes_;
  Prepared prepared_;
  std::optional<Blocks> whole_;  ///< all blocks, once some are left out
  std::vector<int> left_out_;    ///< their numbers, from 0
};

}  // namespace keyblock::study
