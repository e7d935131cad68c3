// Formulates contact, bond and constraint forces of a step as a complementarity problem, and solves it. Theory:
// docs/theory/05-frictional-contact.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "contact/solve/contact_matrix.hpp"

namespace keyblock {

/// Admissible pair of forces, normal and tangential:
///     λn ≥ least,   |λt| ≤ max(0, cohesion + friction λn).
struct ForceLaw {
  double friction = 0;  ///< μ
  double cohesion = 0;  ///< tangential force without normal force; infinite if nothing slips, open or closed
  double least = 0;  ///< smallest normal force: 0 of a contact, −tensile strength of a bond, −∞ of a constraint

  /// Returns the largest tangential force under a normal force.
  double limit(double normal) const;

  /// Returns the tangential limit at the least normal force: 0, unless nothing slips at all.
  double limit_open() const { return std::isinf(cohesion) ? cohesion : 0; }

  bool can_open() const { return !std::isinf(least); }
};

/// Law of a fixed point: both forces take any value that keeps y = 0.
inline constexpr ForceLaw kHeld{0, std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};

/// Law of a bolt, or of a face that must not move: the normal force keeps yn = 0, pushing or pulling, without friction.
inline constexpr ForceLaw kBilateral{0, 0, -std::numeric_limits<double>::infinity()};

/// Problem y = W λ + b, with entries 2i (normal) and 2i + 1 (tangential) of pair i:
///     λn − least ≥ 0 ⊥ yn ≥ 0,   |λt| ≤ limit,   λt opposes yt, and yt = 0 while |λt| < limit.
/// Compliance (1/p) adds to the diagonal of W, which must be positive.
struct FrictionalProblem {
  ContactMatrix w;
  Eigen::VectorXd b;
  std::vector<ForceLaw> laws;
  double goal = 0;        ///< target of the residual, in the unit of λ
  double acceptable = 0;  ///< residual accepted if the goal is out of reach; at least the goal
  Eigen::VectorXd
      proximal;  ///< weights of the first proximal term, as 1/p of an augmented Lagrangian; empty: chosen by the solver
  /// |y| that counts as zero. Redundant forces may have to close gaps made unequal by round-off, which no forces can.
  double gap_tolerance = 0;
  /// Force on an open contact, off its least value, that counts as zero. A larger one, of either sign and at most
  /// `acceptable`, stays in the solution.
  double no_force = std::numeric_limits<double>::infinity();
  Eigen::VectorXd scale{};  ///< compliance by which y is judged as a force, positive; empty: the diagonal of W
  /// Fraction of every tolerance that judges a force, positive and at most 1: forces that do not act on each other have
  /// tolerances of their own. Empty: the whole.
  Eigen::VectorXd share{};
  double share_of(Eigen::Index force) const { return share.size() > 0 ? share[force] : 1; }
  /// Returns true in statics, which judge y by a scale of their own.
  bool is_static() const { return scale.size() > 0; }
  const Eigen::VectorXd& compliance() const { return is_static() ? scale : w.diagonal(); }
  std::size_t count() const { return laws.size(); }
  /// Returns true if a sparse factorisation is worth more than the last digits of redundant forces.
  bool has_many() const { return count() > kFewPairs; }
  bool has_very_many() const { return count() > kVeryManyPairs; }

  static constexpr std::size_t kFewPairs = 50;
  /// More pairs than this end at acceptable forces: the goal would cost more than it is worth.
  static constexpr std::size_t kVeryManyPairs = 1000;
};

/// State of a pair. open: at the least normal force, zero for a contact. open_stick: the same, yet yt = 0.
/// slip_forward: λt = +limit.
enum class Grip { open, open_stick, stick, slip_forward, slip_backward };

inline bool is_open(Grip grip) {
  return grip == Grip::open || grip == Grip::open_stick;
}

struct FrictionalSolution {
  Eigen::VectorXd forces;
  double residual = 0;
  int solves = 0;                      ///< linear systems factorised
  int fallbacks = 0;                   ///< detours through the interior
  bool converged = false;              ///< acceptable
  std::vector<std::size_t> undecided;  ///< pairs with the largest residuals at the end, if it is not acceptable
};

/// Forces after the natural map (Alart & Curnier 1991). r is the inverse of the compliance by which y is judged (W_ii
/// unless the problem has a scale):
///     λn → max(least, λn − rn yn),  λt → clamp(λt − rt yt, ± limit of the new λn).
struct NaturalMap {
  Eigen::VectorXd forces;
  std::vector<Grip> grips;
};
NaturalMap natural_map(const FrictionalProblem& problem, const Eigen::VectorXd& forces);
/// Returns the same from laws, forces, y and the compliance by which y is judged.
NaturalMap natural_map(const std::vector<ForceLaw>& laws, const Eigen::VectorXd& forces, const Eigen::VectorXd& y,
                       const Eigen::VectorXd& compliance);

/// Term `weights` ∘ (λ − reference) added to y. It makes redundant contacts regular, and vanishes at λ = reference.
struct Proximal {
  Eigen::VectorXd weights;
  Eigen::VectorXd reference;
};

/// Forces with their y, stored for repeated use: the product with W is the main cost of judging forces.
struct Tried {
  Eigen::VectorXd forces;
  Eigen::VectorXd y;  ///< W λ + b
};
Tried tried(const FrictionalProblem& problem, Eigen::VectorXd forces);
NaturalMap natural_map(const FrictionalProblem& problem, const Tried& tried);
NaturalMap natural_map(const FrictionalProblem& problem, const Tried& tried, const Proximal& proximal);

/// Returns the largest change of a force, each divided by its share of the tolerances.
double largest(const FrictionalProblem& problem, const Eigen::VectorXd& change);

/// Returns the `largest` change of λ by the natural map, which is zero exactly at the solution.
double residual(const FrictionalProblem& problem, const Eigen::VectorXd& forces);
double residual(const FrictionalProblem& problem, const Tried& tried);

/// Returns the pair of forces with the largest residual. Needs at least one pair.
std::size_t worst_pair(const FrictionalProblem& problem, const Eigen::VectorXd& forces);

/// Returns true if every force is settled: the natural map changes it acceptably little, or its law allows it and its
/// |y| is within tolerance.
bool is_acceptable(const FrictionalProblem& problem, const Eigen::VectorXd& forces);
bool is_acceptable(const FrictionalProblem& problem, const Tried& tried);

/// Linear system of the last active set, for problems that differ only in b.
struct KeptSystem;

/// Solves by Newton's method on the natural map from `start`. If that cycles, it takes a detour through the interior of
/// the bounds, then Newton again. Forces of open contacts are exactly zero, except those above `no_force`. `kept` is
/// used if its active set fits, and then holds the last system.
FrictionalSolution solve(const FrictionalProblem& problem, const Eigen::VectorXd& start, KeptSystem* kept = nullptr);
FrictionalSolution solve(const FrictionalProblem& problem, Tried start, KeptSystem* kept = nullptr);

}  // namespace keyblock
