// Grows cracks under given loads, in dynamics or statics, with DDA blocks and contact. Each step uses the scene of the
// last one, recut where a tip extended. Theory: docs/theory/10-fracture.md.
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

/// Crack growth under given loads. After each step, tips whose K_eq has reached the toughness extend by an increment,
/// and cracks start where the strength is reached. The next step uses bodies cut accordingly, which keep their motion
/// (carry_motion.hpp). In statics the kink is the mean of those before and after a trial of the step. Faces then part
/// at once, and the work of their tractions is lost. In dynamics a tip extends no faster than surface waves, and its
/// new faces part as PartingFaces defines.
class GrowthUnderLoads : public StepperOfScenes {
 public:
  /// Takes a scene with growth for the standard step. Throws std::invalid_argument if the scene cannot be stepped.
  explicit GrowthUnderLoads(Scene first);
  /// Restores the stepper from a checkpoint of the same scene. Throws InputError.
  GrowthUnderLoads(Scene first, Archive& saved);

  std::variant<StepReport, StepFailure> advance() override;
  LedgerScope ledger_scope() const override;
  std::vector<TipState> tips() const override { return front_.tips; }
  CrackNotes crack_notes() const override { return notes_; }
  void save(Archive& archive) override;

 private:
  const Stepper& now() const override { return *now_; }
  /// Time since which a tip has been at its place.
  struct Arrival {
    Point at;
    double time = 0;
  };
  /// Start of an extending tip and its energy per length.
  struct Piece {
    Point from;
    double energy = 0;
  };

  bool is_in_time() const;
  void describe(Archive& archive);
  int first_on_covers() const;  ///< index of the first NMM element in the model
  /// Cuts the scene with `next_` and returns the stepper of the last scene. Throws InputError if the cut is impossible.
  std::unique_ptr<StandardStepper> recut();
  /// Sets `next_` to the mean of the kinks before and after a trial of the step, whose other effects are undone. A
  /// trial that fails, or changes no direction, is the step itself.
  std::optional<std::variant<StepReport, StepFailure>> correct();
  void begin_to_part(const std::vector<CrackPlan>& after);
  void look_at_tips();
  /// Sets `next_` for extending tips, tip i by its kink and more[i] (rad), and for starting cracks.
  void put_next(const std::vector<double>& more);
  bool may_go_on(const TipState& tip, double speed) const;

  Scene first_;
  std::unique_ptr<StandardStepper> now_;
  CrackFront front_;
  std::vector<CrackPlan> next_;        ///< cracks of the next step; empty: those of `front_`
  std::vector<Piece> pieces_;          ///< new pieces in `next_`
  std::vector<PartingFaces> parting_;  ///< dynamics only
  std::vector<RefinedPoint> refined_;  ///< of the current mesh: parted faces still have the field of a tip
  std::vector<Arrival> arrivals_;      ///< of tips that extended
  CrackNotes notes_;
  int next_number_ = 0;  ///< of the next new element
};

}  // namespace keyblock
