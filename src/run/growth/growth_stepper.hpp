// Grows cracks in statics. Each step finds the load at which a tip is about to extend, then extends the tips by one
// increment. Theory: docs/theory/10-fracture.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "run/growth/crack_front.hpp"
#include "step/stepper_of_scenes.hpp"

namespace keyblock {

/// Crack growth driven by the length of the cracks; the load follows (Bocca, Carpinteri & Valente 1991). Snap-back
/// needs nothing else. All loads of the file grow in proportion. So do stresses, at small strain even with frictional
/// contact. Step k is the equilibrium with the cracks after k - 1 increments.
class GrowthStepper : public StepperOfScenes {
 public:
  /// Takes a scene with growth. Throws std::invalid_argument if no stepper supports the scene.
  explicit GrowthStepper(Scene first);
  /// Restores the stepper from a checkpoint of the same scene. Throws InputError.
  GrowthStepper(Scene first, Archive& saved);

  /// Returns true if no tip is left, or a piece is cut free.
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
  /// Equilibrium with certain cracks, and the tips in it.
  struct Solved {
    std::unique_ptr<Stepper> stepper;
    StepReport report;
    std::vector<TipState> tips;
    std::vector<CrackStart> starts;  ///< of cracks in intact rock
    int next_number = 0;             ///< of an element
  };

  void describe_growth(Archive& archive);
  Scene scene_with(const std::vector<CrackPlan>& cracks, double factor) const;
  std::variant<Solved, StepFailure> solved(const std::vector<CrackPlan>& cracks, double factor) const;
  /// Marks tips just before a line; fails for other tips without room.
  std::optional<StepFailure> unfit_tip(const Stepper& solved, std::vector<TipState>& tips) const;
  /// Solves at the load factor at which one of these tips reaches its toughness. `factor`: first guess, then the
  /// result.
  std::variant<Solved, StepFailure> solved_at_toughness(double& factor, const std::vector<std::size_t>& tips) const;
  /// Returns the cracks extended by one increment, by the kinks of the tips and `more` of each.
  std::vector<CrackPlan> further(const std::vector<double>& more) const;
  /// Returns the corrections to the mean of the kinks before and after the step; zero if its trial fails.
  std::vector<double> corrections(const std::vector<CrackPlan>& trial) const;
  /// Sets the cracks of the next step, or the end of the run.
  void put_next();
  StepFailure failure(Finding why) const { return failed("alone", {}, std::move(why), FailureKind::cracks); }

  Scene first_;
  std::unique_ptr<Stepper> now_;
  State state_;                    ///< of `now_`, with the steps of the run
  std::vector<CrackPlan> cracks_;  ///< cracks of the next step
  CrackFront front_;               ///< at the end of the last step; if cracks start, no tip extends
  double load_factor_ = 1;
  CrackNotes notes_;
  bool is_done_ = false;
  int next_number_ = 0;  ///< of an element that comes
};

}  // namespace keyblock
