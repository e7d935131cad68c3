// Cracks that grow under the loads as they are, in time or at rest, beside blocks and in contact: each step is made on
// the scene that the steps before left, cut anew where a tip went on.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <variant>
#include <vector>

#include "fracture/parting_faces.hpp"
#include "run/growth/crack_front.hpp"
#include "step/standard_stepper.hpp"
#include "step/stepper_of_scenes.hpp"

namespace keyblock {

/// After each step the tips whose K_eq has reached the toughness go on by an increment, those cracks start that have
/// reached the strength, and the next step is made on bodies cut so, which keep their motion (carry_motion.hpp). At
/// rest the kink is the mean of those before and after a trial of the step, and faces part at once, the work that they
/// would have done being lost. In time a tip goes on no faster than waves run along a free surface, and its new faces
/// part as PartingFaces says.
class GrowthUnderLoads : public StepperOfScenes {
 public:
  /// Of a scene with growth that the standard step moves. Throws std::invalid_argument for one that cannot be stepped.
  explicit GrowthUnderLoads(Scene first);
  /// As it was saved, of the same scene. Throws InputError.
  GrowthUnderLoads(Scene first, Archive& saved);

  std::variant<StepReport, StepFailure> advance() override;
  LedgerScope ledger_scope() const override;
  std::vector<TipState> tips() const override { return front_.tips; }
  CrackNotes crack_notes() const override { return notes_; }
  void save(Archive& archive) override;

 private:
  const Stepper& now() const override { return *now_; }
  /// Since when a tip is where it is.
  struct Arrival {
    Point at;
    double time = 0;
  };
  /// What a tip that goes on takes per length.
  struct Piece {
    Point from;
    double energy = 0;
  };

  bool is_in_time() const;
  void describe(Archive& archive);
  int first_on_covers() const;  ///< its index among the elements of the model
  /// Cuts the scene with `next_` and returns the stepper of the scene before. Throws InputError where it cannot be cut
  /// so.
  std::unique_ptr<StandardStepper> recut();
  /// Puts `next_` to the mean of the kinks before and after a trial of the step, which leaves nothing else behind. A
  /// trial that fails, or turns no tip, is the step itself.
  std::optional<std::variant<StepReport, StepFailure>> correct();
  void begin_to_part(const std::vector<CrackPlan>& after);
  void look_at_tips();
  /// `next_` of the tips that go on, tip i by its kink and more[i] (rad), and of the cracks that start.
  void put_next(const std::vector<double>& more);
  bool may_go_on(const TipState& tip, double speed) const;

  Scene first_;
  std::unique_ptr<StandardStepper> now_;
  CrackFront front_;
  std::vector<CrackPlan> next_;        ///< cracks of the coming step; empty: those of `front_`
  std::vector<Piece> pieces_;          ///< what `next_` gains
  std::vector<PartingFaces> parting_;  ///< in time
  std::vector<RefinedPoint> refined_;  ///< of the present mesh: where faces parted, the field is still that of a tip
  std::vector<Arrival> arrivals_;      ///< of tips that went on
  CrackNotes notes_;
  int next_number_ = 0;  ///< of an element that is new
};

}  // namespace keyblock
