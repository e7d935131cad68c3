// Declares the interface between the run loop and a kind of dynamics: the state, and a way to make the next step.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "base/archive.hpp"
#include "base/words/finding.hpp"
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

/// Cause of a failed step. `no_equilibrium` and `accelerates` are results about the scene: rock finds no equilibrium
/// under its loads, or a body accelerates. The other kinds mean that the calculation did not finish. `cracks`: a tip
/// has no room or cannot be judged, so that other rules of motion do not help. `inside_out`: an element turned inside
/// out.
enum class FailureKind { undecided, no_equilibrium, accelerates, cracks, inside_out };
constexpr bool is_of_the_scene(FailureKind kind) {
  return kind == FailureKind::no_equilibrium || kind == FailureKind::accelerates;
}

/// A step that could not be made. The state stays that of the last accepted step.
struct StepFailure {
  std::string reason;                 ///< one sentence
  std::vector<std::size_t> contacts;  ///< numbers (from 0) of the contacts that did not settle
  FailureKind kind = FailureKind::undecided;
  int passes = 0;  ///< as in StepReport
  /// True if elastoplastic rock was on its yield surface at the last equilibrium or at the end of the next search. Set
  /// by statics only.
  bool rock_yields = false;
  std::vector<ElementIndex> elements = {};  ///< that move away, move too far for a step, or turned inside out
  Finding cause = {};                       ///< the values behind the reason
};

/// Returns a failure whose reason is the sentence of `cause`, within that of the form `frame` with its values.
StepFailure failed(std::string_view frame, const Facts& values, Finding cause,
                   FailureKind kind = FailureKind::undecided);

/// Steps made in one of several scenes.
struct SceneReport {
  std::string name;
  int first_step = 0;  ///< last step before the scene
  int last_step = 0;
  double end_time = 0;
  bool asks_equilibrium = false;
  bool is_balanced = false;                 ///< the scene ended because its forces were in balance
  std::optional<ForceBalance> forces = {};  ///< at its end, if its steps compute them
};

/// Displacement field of NMM bodies: x = X + Σ N_a(X) d_a.
struct CoverDisplacement {
  const CoverBasis& basis;
  const Eigen::VectorXd& d;
  bool is_large = true;                           ///< false: solution of linear elasticity
  const Eigen::VectorXd* acceleration = nullptr;  ///< second time derivative of d; null in statics
};

class Stepper {
 public:
  virtual ~Stepper() = default;

  /// Returns true if a scene, or the run, ended with the last accepted step. `is_done`: true only at the end of the
  /// run, even if more steps were requested.
  virtual bool ends_scene() const { return false; }
  virtual bool is_done() const { return false; }
  /// Returns the reason why the run is done, if the user did not request this end; otherwise empty.
  virtual std::string why_done() const { return {}; }
  /// Returns the scenes so far, if there are several.
  virtual std::vector<SceneReport> scenes() const { return {}; }

  /// Returns the model of the next step.
  virtual const Model& model() const = 0;
  virtual const Settings& settings() const = 0;
  /// Returns the state at the end of the last accepted step.
  virtual const State& state() const = 0;
  /// Returns the positions before any load, the origin of all displacements.
  virtual const StartPlaces& unloaded() const = 0;
  /// Returns the stress at the point that lay at `start` before any load; the stress of a DDA block is uniform.
  virtual Stress stress_at(ElementIndex e, Point) const { return state().elements[e].stress; }
  /// Returns the plastic state at the same point; empty for rock that cannot yield.
  virtual std::optional<PlasticState> plastic_at(ElementIndex, Point) const { return std::nullopt; }
  /// Returns the totals of all elastoplastic rock; empty without such rock.
  virtual std::optional<PlasticTotals> plastic_totals() const { return std::nullopt; }
  /// Returns the state out of balance that the last failed step reached, which shows what moves; empty if unknown.
  virtual std::optional<State> attempted() const { return std::nullopt; }
  /// Returns the contacts and their forces in the last accepted step; empty if the scene has no contact.
  virtual ContactFrames contacts() const { return {}; }
  /// Returns a function that computes the same after further steps, as long as the stepper lives.
  virtual std::function<ContactFrames()> contacts_later() const {
    return [made = contacts()] { return made; };
  }
  virtual StartReport start_report() const { return {}; }
  /// Makes the next step. The state is unchanged if the step fails or throws StopRequested.
  virtual std::variant<StepReport, StepFailure> advance() = 0;

  /// Returns the energy balance after the last accepted step; all zero if `ledger = off`.
  virtual LedgerRow ledger() const = 0;
  virtual LedgerScope ledger_scope() const = 0;

  /// Returns loads and support reactions of NMM bodies after the last accepted step, if the stepper computes them.
  virtual std::optional<ForceBalance> forces() const { return std::nullopt; }
  /// Returns the displacements of the NMM bodies after the last accepted step; empty without such bodies or a solution.
  virtual std::optional<CoverDisplacement> on_covers() const { return std::nullopt; }
  /// Returns the crack tips after the last accepted step, if the run follows them. `load_factor`: factor of all loads
  /// there.
  virtual std::vector<TipState> tips() const { return {}; }
  virtual double load_factor() const { return 1; }
  /// Returns the notes on cracks so far.
  virtual CrackNotes crack_notes() const { return {}; }
  /// Returns the mean displacement along the edge [length] per prescribed displacement, if steps follow it.
  virtual std::vector<double> driven() const { return {}; }
  /// Returns the load fraction of the scene after the last accepted step; empty if steps do not search for it.
  virtual std::optional<double> load_share() const { return std::nullopt; }

  /// Saves all data on which later steps depend. Changes nothing.
  virtual void save(Archive& archive) = 0;
};

/// Steps one scene; another stepper can continue from it in the next scene.
class SceneStepper : public Stepper {
 public:
  /// Returns the stepper of the next scene, at the same step and time. Throws std::invalid_argument if no stepper
  /// supports the scene.
  virtual std::unique_ptr<SceneStepper> in_next(const SceneChange& change) const = 0;

  /// Returns true if all loads act, forces balance to the fraction `share` of the largest, and nothing moves faster
  /// than `share` of a reference speed. The largest acceleration by a load reaches that speed over the size of a block.
  virtual bool is_at_rest(double share) const = 0;
};

}  // namespace keyblock
