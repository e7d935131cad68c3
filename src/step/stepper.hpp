// What the run loop sees of a dynamics: a state, and a way to make the next step.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "base/archive.hpp"
#include "model/cover_basis.hpp"
#include "model/scene/scene.hpp"
#include "model/state.hpp"
#include "result/contact_frame.hpp"
#include "result/crack_notes.hpp"
#include "result/force_balance.hpp"
#include "result/frame.hpp"
#include "result/ledger.hpp"
#include "result/plastic_state.hpp"
#include "result/start_report.hpp"
#include "result/step_report.hpp"

namespace keyblock {

/// Whether a step that could not be made says something of the scene: that rock finds no equilibrium under its loads,
/// or that something accelerates. Otherwise the calculation did not come to an end; `cracks`: for a tip that has no
/// room or cannot be judged, so that other rules of motion do not help; `inside_out`: an element turned inside out.
enum class FailureKind { undecided, no_equilibrium, accelerates, cracks, inside_out };
constexpr bool is_of_the_scene(FailureKind kind) {
  return kind == FailureKind::no_equilibrium || kind == FailureKind::accelerates;
}

/// A step that could not be made: the state is that of the last accepted step.
struct StepFailure {
  std::string reason;                 ///< one sentence
  std::vector<std::size_t> contacts;  ///< numbers (from 0) of the contacts that would not settle
  FailureKind kind = FailureKind::undecided;
  int passes = 0;  ///< as in StepReport
  /// Rock that may yield was on its surface at the last equilibrium, or where the search for the next one ended; told
  /// by statics.
  bool rock_yields = false;
  std::vector<ElementIndex> elements = {};  ///< that move away, too far for a step, or turned inside out
};

/// One scene of several: which steps were made on it.
struct SceneReport {
  std::string name;
  int first_step = 0;  ///< after which it began
  int last_step = 0;
  double end_time = 0;
  bool asks_equilibrium = false;
  bool is_balanced = false;                 ///< it ended because its forces were balanced
  std::optional<ForceBalance> forces = {};  ///< at its end, where its steps sum them
};

/// Where bodies on covers have moved: x = X + Σ N_a(X) d_a.
struct CoverDisplacement {
  const CoverBasis& basis;
  const Eigen::VectorXd& d;
  bool is_large = true;                           ///< false: the solution of linear elasticity
  const Eigen::VectorXd* acceleration = nullptr;  ///< of the functions, in time; none at rest
};

class Stepper {
 public:
  virtual ~Stepper() = default;

  /// Whether one scene ends and another begins, or the run does, at the last accepted step; and whether the run does,
  /// however many steps were asked for.
  virtual bool ends_scene() const { return false; }
  virtual bool is_done() const { return false; }
  /// Why it is, in words, where the user has not asked for an end there; else empty.
  virtual std::string why_done() const { return {}; }
  /// The scenes so far, where there is more than one.
  virtual std::vector<SceneReport> scenes() const { return {}; }

  /// What the next step will be made on.
  virtual const Model& model() const = 0;
  virtual const Settings& settings() const = 0;
  /// At the end of the last accepted step.
  virtual const State& state() const = 0;
  /// Before any load: displacements are counted from here.
  virtual const StartPlaces& unloaded() const = 0;
  /// At the point of an element that lay at `start` before any load: on covers there, else that of the element.
  virtual Stress stress_at(ElementIndex e, Point) const { return state().elements[e].stress; }
  /// Likewise; none of rock that cannot yield.
  virtual std::optional<PlasticState> plastic_at(ElementIndex, Point) const { return std::nullopt; }
  /// Of all rock that may yield; none where none may.
  virtual std::optional<PlasticTotals> plastic_totals() const { return std::nullopt; }
  /// Where the step that failed last had come to, out of balance: what moves. None where nothing is known of it.
  virtual std::optional<State> attempted() const { return std::nullopt; }
  /// What touches, and what it bore in the last accepted step; none where the scene has no contact.
  virtual ContactFrames contacts() const { return {}; }
  virtual StartReport start_report() const { return {}; }
  /// On failure the state is unchanged, and where it throws StopRequested in the middle of a step.
  virtual std::variant<StepReport, StepFailure> advance() = 0;

  /// Energy ledger after the last accepted step; all zero if `ledger = off`.
  virtual LedgerRow ledger() const = 0;
  virtual LedgerScope ledger_scope() const = 0;

  /// Loads and supports of bodies on covers after the last accepted step, where the stepper sums them.
  virtual std::optional<ForceBalance> forces() const { return std::nullopt; }
  /// Of the bodies on covers after the last accepted step; none without them, or before anything was solved.
  virtual std::optional<CoverDisplacement> on_covers() const { return std::nullopt; }
  /// Crack tips after the last accepted step, where the run follows them, and the factor of all loads there.
  virtual std::vector<TipState> tips() const { return {}; }
  virtual double load_factor() const { return 1; }
  /// Notes on cracks so far.
  virtual CrackNotes crack_notes() const { return {}; }
  /// Of each prescribed displacement: the mean of its length along the edge, where steps follow it.
  virtual std::vector<double> driven() const { return {}; }
  /// Of the scene's loads and displacements, after the last accepted step; none where steps do not seek it.
  virtual std::optional<double> load_share() const { return std::nullopt; }

  /// Everything that the coming steps depend on. Saving changes nothing.
  virtual void save(Archive& archive) = 0;
};

/// The stepper of one scene, which may give way to that of the next.
class SceneStepper : public Stepper {
 public:
  /// Goes on in the scene that follows, at the same step and time. Throws std::invalid_argument for a scene that cannot
  /// be stepped.
  virtual std::unique_ptr<SceneStepper> in_next(const SceneChange& change) const = 0;

  /// Whether all loads are on, forces are balanced to this share of the largest, and nothing moves faster than this
  /// share of the speed that the largest acceleration of a load gives over the size of a block.
  virtual bool is_at_rest(double share) const = 0;
};

}  // namespace keyblock
