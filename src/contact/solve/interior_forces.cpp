// Follows the central path with rooms and multipliers; one factorisation per step serves prediction and correction.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/solve/interior_forces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "base/context.hpp"
#include "contact/solve/active_forces.hpp"

namespace keyblock {
namespace {

// From far away three steps reduce the product tenfold. Successful searches took 10 to 50 steps, and none more than 60.
constexpr int kMostPathSteps = 60;
// Initial product of room and multiplier, relative to the mean energy of forces and gaps. Values of 1e-3 to 1 took as
// many steps.
constexpr double kFirstProduct = 1e-2;
// A step ends at this fraction of the way to the nearest bound.
constexpr double kOfWayToBound = 0.995;
// Least target of a step relative to the product, below the accuracy of a prediction.
constexpr double kLeastAim = 1e-6;
// A part below kShortPart is short. Damping then begins at kDamping of W_ii and grows tenfold per short part in a row.
// It falls again after a part above kLongPart.
constexpr double kShortPart = 0.05;
constexpr double kDamping = 1e-3;
constexpr double kLongPart = 0.3;
constexpr double kTenfold = 10;
constexpr int kMostShort = 15;
// Fraction of W_ii added for a force without a spring: redundant ones would make the matrix singular.
constexpr double kRegularShare = 1e-8;
// Initial distance of friction bounds, at least this fraction of a natural force.
constexpr double kLeastFrictionRoom = 1e-3;
// Residual that iterations may leave instead of a factorisation, over the goal.
constexpr double kLeftOfGoal = 0.01;
// Bisections for a tangential force between its bounds, down to round-off.
constexpr int kBisections = 60;

// Bound of a force: room = sign × force + slope × normal force of the pair + given.
struct Bound {
  Eigen::Index row;
  double sign;
  double slope;
  double given;
  double room = 0;
  double multiplier = 0;
  double room_change = 0;
  double multiplier_change = 0;

  double product() const { return room * multiplier; }
  double stiffness() const { return multiplier / room; }
  double product_after(double part) const {
    return (room + part * room_change) * (multiplier + part * multiplier_change);
  }
  /// Sets the change of the multiplier that brings the product to `aim` for the known change of the room.
  void follow(double aim) { multiplier_change = aim / room - multiplier - stiffness() * room_change; }
};

class Interior {
 public:
  Interior(const FrictionalProblem& problem, FrictionalSolution so_far)
      : problem_(problem), solution_(std::move(so_far)), forces_(solution_.forces), own_(problem.w.diagonal()) {
    for (std::size_t i = 0; i < problem_.count(); ++i) add_bounds(i);
  }

  // If the path from the current forces leads nowhere, the path from zero is a different one. So is that from half of
  // the best forces, which is too dear for very many pairs.
  FrictionalSolution run() {
    if (bounds_.empty() || !is_complementary()) return std::move(solution_);
    follow_path(energy_of_change());
    if (!is_solved()) {
      forces_.setZero();
      follow_path(std::numeric_limits<double>::infinity());
    }
    if (!is_solved() && !problem_.has_very_many()) {
      forces_ = solution_.forces / 2;
      follow_path(std::numeric_limits<double>::infinity());
    }
    return std::move(solution_);
  }

 private:
  // Laws without room for a tangential force have no unknown for it.
  void add_bounds(std::size_t pair) {
    const auto n = static_cast<Eigen::Index>(2 * pair);
    const ForceLaw& law = problem_.laws[pair];
    const auto unknown = [&](Eigen::Index force) {
      set_.columns.push_back({static_cast<Eigen::Index>(set_.rows.size()), 1, 0});
      set_.rows.push_back(force);
    };
    unknown(n);
    if (law.can_open()) bounds_.push_back({n, 1, 0, -law.least});
    if (law.friction == 0 && law.cohesion == 0) {
      set_.columns.push_back({});
      return;
    }
    unknown(n + 1);
    if (std::isinf(law.cohesion)) return;
    for (const double sign : {1.0, -1.0}) bounds_.push_back({n + 1, sign, law.friction, law.cohesion});
  }

  void follow_path(double most_energy) {
    begin(most_energy);
    if (!(product_ > 0)) return;  // nothing to balance
    damping_ = 0;
    int short_parts = 0;
    for (int k = 0; k < kMostPathSteps && short_parts < kMostShort; ++k) {
      begin_system();
      if (!step()) break;
      keep_best();
      if (is_solved()) break;
      short_parts = part_ < kShortPart ? short_parts + 1 : 0;
    }
  }

  // A normal force that may pull has no bound, so that a friction limit that grows with it fits no complementarity
  // problem.
  bool is_complementary() const {
    return std::ranges::all_of(problem_.laws, [](const ForceLaw& law) { return law.can_open() || law.friction == 0; });
  }

  static double change_of_room(const Bound& bound, const Eigen::VectorXd& change) {
    return bound.sign * change[bound.row] + (bound.slope == 0 ? 0 : bound.slope * change[bound.row - 1]);
  }

  // Returns the greatest energy of a change by the natural map.
  double energy_of_change() const {
    const Eigen::VectorXd change = natural_map(problem_, forces_).forces - forces_;
    return change.cwiseAbs2().cwiseProduct(own_).maxCoeff();
  }

  // Starts with forces as near to the path as each can be alone. With the other forces fixed and the target force of
  // the natural map, room − product / (W_ii room) is the target of the room (Chen & Harker 1993).
  void begin(double most_energy) {
    const Tried now = tried(problem_, forces_);
    const double energy =
        std::max(forces_.cwiseAbs2().cwiseProduct(own_).mean(), problem_.b.cwiseAbs2().cwiseQuotient(own_).mean());
    product_ = std::min(kFirstProduct * energy, most_energy);
    const Eigen::VectorXd wanted = forces_ - now.y.cwiseQuotient(own_);
    for (std::size_t i = 0; i < problem_.count(); ++i) {
      const auto n = static_cast<Eigen::Index>(2 * i);
      const ForceLaw& law = problem_.laws[i];
      if (law.can_open()) {
        const double room = wanted[n] - law.least;
        forces_[n] = law.least + (room + std::sqrt(room * room + 4 * product_ / own_[n])) / 2;
      }
      if (set_.columns[2 * i + 1].unknown < 0)
        forces_[n + 1] = 0;
      else if (!std::isinf(law.cohesion))
        begin_between(n, law, wanted[n + 1]);
    }
    for (Bound& bound : bounds_) {
      bound.room = change_of_room(bound, forces_) + bound.given;
      bound.multiplier = product_ / bound.room;
    }
  }

  // Sets the tangential force between its two bounds.
  void begin_between(Eigen::Index n, const ForceLaw& law, double wanted) {
    const double natural = std::sqrt(product_ / own_[n + 1]);
    if (law.friction > 0 && law.cohesion + law.friction * forces_[n] < kLeastFrictionRoom * natural)
      forces_[n] = (kLeastFrictionRoom * natural - law.cohesion) / law.friction;
    const double limit = law.cohesion + law.friction * forces_[n];
    double low = -limit;
    double high = limit;
    for (int i = 0; i < kBisections; ++i) {
      const double force = (low + high) / 2;
      const double pull = natural * natural * (1 / (limit - force) - 1 / (limit + force));
      (force - wanted + pull > 0 ? high : low) = force;
    }
    forces_[n + 1] = kOfWayToBound * (low + high) / 2;
  }

  // Factorises the matrix of a step: W with the stiffness of the bounds on its diagonal. A bound that depends on the
  // normal force couples the two forces of its pair, expressed as λt = unknown + coupled λn (active_forces.hpp).
  void factorise() {
    Eigen::VectorXd added = damping_ * own_;
    for (Eigen::Index i = 0; i < added.size(); ++i)
      if (!(problem_.w.added()[i] > 0)) added[i] += kRegularShare * own_[i];
    Eigen::VectorXd coupling = Eigen::VectorXd::Zero(added.size());
    for (const Bound& bound : bounds_) {
      added[bound.row] += bound.stiffness();
      coupling[bound.row] += bound.sign * bound.slope * bound.stiffness();
    }
    ActiveSet set = set_;
    for (Eigen::Index i = 1; i < added.size(); i += 2) {
      if (coupling[i] == 0) continue;
      set.columns[static_cast<std::size_t>(i)].coupled = -coupling[i] / (problem_.w.added()[i] + added[i]);
      set.slips = true;
    }
    system_.reset();  // its factorisation is reused
    system_ = std::make_unique<ActiveForces>(problem_, std::move(set), added);
    ++solution_.solves;
  }

  // Returns false if the matrix is singular.
  bool step() {
    factorise();
    Eigen::VectorXd right = -tried(problem_, forces_).y;
    if (!change_by(right)) return false;
    double before = 0;
    for (Bound& bound : bounds_) {
      bound.follow(0);
      before += bound.product();
    }
    const double predicted = longest_part();
    double after = 0;
    for (const Bound& bound : bounds_) after += bound.product_after(predicted);
    product_ = before / static_cast<double>(bounds_.size());
    const double aim = std::max(std::pow(after / before, 3), kLeastAim) * product_;
    std::vector<double> corrected;
    for (const Bound& bound : bounds_) {
      corrected.push_back(aim - bound.room_change * bound.multiplier_change);
      right[bound.row] += bound.sign * corrected.back() / bound.room;
    }
    if (!change_by(right)) return false;
    for (std::size_t i = 0; i < bounds_.size(); ++i) bounds_[i].follow(corrected[i]);
    take(std::min(1.0, kOfWayToBound * longest_part()));
    return true;
  }

  // Solves the system for `right` and keeps the change. The multiplier of a friction bound acts on the tangential force
  // and not on the normal one. That is Coulomb's law, and makes the matrix unsymmetric.
  bool change_by(const Eigen::VectorXd& right) {
    const auto change = system_->solve(-right, Eigen::VectorXd::Zero(right.size()), kLeftOfGoal * problem_.goal);
    if (!change || !change->allFinite()) return false;
    change_ = *change;
    for (Bound& bound : bounds_) bound.room_change = change_of_room(bound, change_);
    return true;
  }

  double longest_part() const {
    double part = 1;
    for (const Bound& bound : bounds_) {
      if (bound.room_change < 0) part = std::min(part, -bound.room / bound.room_change);
      if (bound.multiplier_change < 0) part = std::min(part, -bound.multiplier / bound.multiplier_change);
    }
    return part;
  }

  void take(double part) {
    part_ = part;
    forces_ += part * change_;
    for (Bound& bound : bounds_) {
      bound.room = change_of_room(bound, forces_) + bound.given;
      bound.multiplier += part * bound.multiplier_change;
    }
    if (part < kShortPart)
      damping_ = std::max(kTenfold * damping_, kDamping);
    else if (part > kLongPart)
      damping_ = damping_ > kDamping ? damping_ / kTenfold : 0;
  }

  void keep_best() {
    const Tried now = tried(problem_, forces_);
    const double left = residual(problem_, now);
    const bool is_good = is_acceptable(problem_, now);
    if (!(left < solution_.residual) || (solution_.converged && !is_good)) return;
    solution_.residual = left;
    solution_.forces = forces_;
    solution_.converged = is_good;
  }

  bool is_solved() const { return solution_.residual <= problem_.goal; }

  const FrictionalProblem& problem_;
  FrictionalSolution solution_;  ///< with the best forces found
  Eigen::VectorXd forces_;
  Eigen::VectorXd change_;
  Eigen::VectorXd own_;  ///< W_ii
  ActiveSet set_;        ///< all unknown forces
  std::vector<Bound> bounds_;
  std::unique_ptr<ActiveForces> system_;
  double product_ = 0;  ///< mean product of room and multiplier
  double damping_ = 0;  ///< fraction of W_ii in the matrix
  double part_ = 1;     ///< of the last accepted step
};

}  // namespace

FrictionalSolution interior_forces(const FrictionalProblem& problem, FrictionalSolution so_far) {
  return Interior(problem, std::move(so_far)).run();
}

}  // namespace keyblock
