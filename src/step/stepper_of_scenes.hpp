// Forwards the stepper interface to the stepper of the current scene.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "step/stepper.hpp"

namespace keyblock {

/// Shows the results of the current scene's stepper. The derived class changes scenes in `advance`; it also defines the
/// end of the run, the scope of the energy balance and the saved data.
class StepperOfScenes : public Stepper {
 public:
  const Model& model() const override { return now().model(); }
  const Settings& settings() const override { return now().settings(); }
  const State& state() const override { return now().state(); }
  const StartPlaces& unloaded() const override { return now().unloaded(); }
  Stress stress_at(ElementIndex e, Point start) const override { return now().stress_at(e, start); }
  std::optional<PlasticState> plastic_at(ElementIndex e, Point start) const override {
    return now().plastic_at(e, start);
  }
  std::optional<PlasticTotals> plastic_totals() const override { return now().plastic_totals(); }
  std::optional<State> attempted() const override { return now().attempted(); }
  ContactFrames contacts() const override { return now().contacts(); }
  StartReport start_report() const override { return now().start_report(); }
  LedgerRow ledger() const override { return now().ledger(); }
  std::optional<ForceBalance> forces() const override { return now().forces(); }
  std::optional<CoverDisplacement> on_covers() const override { return now().on_covers(); }
  std::vector<double> driven() const override { return now().driven(); }
  std::optional<double> load_share() const override { return now().load_share(); }

 private:
  virtual const Stepper& now() const = 0;
};

}  // namespace keyblock
