// Cracks that grow at rest: in each step the load under which a tip is about to go on, then the tips one increment
// further.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "run/growth/crack_front.hpp"
#include "step/stepper_of_scenes.hpp"

namespace keyblock {

/// The length of the cracks is what is driven, and the load follows (Bocca, Carpinteri & Valente 1991): snap-back needs
/// nothing else. All loads of the file grow in proportion; stresses do too, in contact with friction as well, for small
/// strain. Step k is the equilibrium with the cracks as they are after k - 1 increments.
class GrowthStepper : public StepperOfScenes {
 public:
  /// Of a scene with growth. Throws std::invalid_argument for one that cannot be stepped.
  explicit GrowthStepper(Scene first);
  /// As it was saved, of the same scene. Throws InputError.
  GrowthStepper(Scene first, Archive& saved);

  /// Where no tip is left, or a piece is cut free.
  bool is_done() const override { return is_done_; }
  std::string why_done() const override;
  const Settings& settings() const override { return first_.settings; }
  const State& state() const override { return state_; }
  std::variant<StepReport, StepFailure> advance() override;
  LedgerRow ledger() const override { return {}; }
  LedgerScope ledger_scope() const override { return {}; }
  std::vector<TipState> tips() const override { return front_.tips; }
  double load_factor() const override { return load_factor_; }
  CrackNotes crack_notes() const override { return notes_; }
  void save(Archive& archive) override;

 private:
  const Stepper& now() const override { return *now_; }
  /// An equilibrium with some cracks, and the tips in it.
  struct Solved {
    std::unique_ptr<Stepper> stepper;
    StepReport report;
    std::vector<TipState> tips;
    std::vector<CrackStart> starts;  ///< of cracks in intact rock
  };

  void describe_growth(Archive& archive);
  Scene scene_with(const std::vector<CrackPlan>& cracks, double factor) const;
  std::variant<Solved, StepFailure> solved(const std::vector<CrackPlan>& cracks, double factor) const;
  /// Marks tips just before a line; fails where one has no room otherwise.
  std::optional<StepFailure> unfit_tip(const Stepper& solved, std::vector<TipState>& tips) const;
  /// The same under the factor at which one of these tips reaches its toughness; begins with `factor`, and puts it.
  std::variant<Solved, StepFailure> solved_at_toughness(double& factor, const std::vector<std::size_t>& tips) const;
  /// The cracks one increment further, by the kinks of the tips and `more` of each.
  std::vector<CrackPlan> further(const std::vector<double>& more) const;
  /// By the mean of the kinks before and after the step; none where its trial fails.
  std::vector<double> corrections(const std::vector<CrackPlan>& trial) const;
  /// Puts the cracks of the next step, or that there is none.
  void put_next();
  StepFailure failure(const std::string& why) const { return {why, {}, FailureKind::cracks, 0}; }

  Scene first_;
  std::unique_ptr<Stepper> now_;
  State state_;                    ///< of `now_`, with the steps of the run
  std::vector<CrackPlan> cracks_;  ///< those of the step to come
  CrackFront front_;               ///< at the end of the last step; where cracks start no tip goes on
  double load_factor_ = 1;
  CrackNotes notes_;
  bool is_done_ = false;
};

}  // namespace keyblock
