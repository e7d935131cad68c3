// Contact, bond and constraint forces of a step as a complementarity problem, and its solution.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "contact/solve/contact_matrix.hpp"

namespace keyblock {

/// What a pair of forces, normal and tangential, may be:
///     λn ≥ least,   |λt| ≤ max(0, cohesion + friction λn).
struct ForceLaw {
  double friction = 0;  ///< μ
  double cohesion = 0;  ///< tangential force held without normal force; infinite where nothing slips, open or not
  double least = 0;     ///< smallest normal force: 0 of a touch, −tensile strength of a bond, −∞ of a constraint

  /// Largest tangential force under a normal force.
  double limit(double normal) const;

  /// At the least normal force there is no tangential force, unless nothing slips at all.
  double limit_open() const { return std::isinf(cohesion) ? cohesion : 0; }

  bool can_open() const { return !std::isinf(least); }
};

/// Both forces take whatever value keeps y = 0: a held point.
inline constexpr ForceLaw kHeld{0, std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};

/// The normal force keeps yn = 0, pushing or pulling, and there is no other: a bolt, or a face that must not move.
inline constexpr ForceLaw kBilateral{0, 0, -std::numeric_limits<double>::infinity()};

/// y = W λ + b with entries 2i (normal) and 2i + 1 (tangential) of pair i:
///     λn − least ≥ 0 ⊥ yn ≥ 0,   |λt| ≤ limit,   λt opposes yt, and yt = 0 while |λt| < limit.
/// Compliance (1/p) stands on the diagonal of W, which must be positive.
struct FrictionalProblem {
  ContactMatrix w;
  Eigen::VectorXd b;
  std::vector<ForceLaw> laws;
  double goal = 0;        ///< residual to aim at, in the unit of λ
  double acceptable = 0;  ///< residual that counts as solved where the goal is out of reach; at least the goal
  Eigen::VectorXd
      proximal;  ///< weights of the first proximal term, as 1/p of an augmented Lagrangian; empty: our choice
  /// |y| that counts as zero: redundant forces may be asked to close gaps that round-off made unequal, and then no
  /// forces do.
  double gap_tolerance = 0;
  /// Force on an open touch, off its least, that counts as none; more than that, of either sign and at most acceptable,
  /// stays in the solution.
  double no_force = std::numeric_limits<double>::infinity();
  Eigen::VectorXd scale{};  ///< compliance by which y is judged as a force, positive; empty: the diagonal of W
  const Eigen::VectorXd& compliance() const { return scale.size() > 0 ? scale : w.diagonal(); }
  std::size_t count() const { return laws.size(); }
  /// Whether a sparse factor is worth more than the last digits of forces that are redundant anyhow.
  bool has_many() const { return count() > kFewPairs; }
  bool has_very_many() const { return count() > kVeryManyPairs; }

  static constexpr std::size_t kFewPairs = 50;
  /// More pairs end at acceptable forces: the goal costs more there than it is worth.
  static constexpr std::size_t kVeryManyPairs = 1000;
};

/// open: at the least normal force, which is none for a touch; open_stick: the same, yet yt = 0; slip_forward: λt =
/// +limit.
enum class Grip { open, open_stick, stick, slip_forward, slip_backward };

inline bool is_open(Grip grip) {
  return grip == Grip::open || grip == Grip::open_stick;
}

struct FrictionalSolution {
  Eigen::VectorXd forces;
  double residual = 0;
  int solves = 0;                      ///< linear systems factorised
  int fallbacks = 0;                   ///< detours by the interior
  bool converged = false;              ///< acceptable
  std::vector<std::size_t> undecided;  ///< pairs that hold the residual up at the end, where it is not acceptable
};

/// What λ would become under the natural map (Alart & Curnier 1991), with r one over the compliance by which y is
/// judged (W_ii unless the problem has a scale):
///     λn → max(least, λn − rn yn),  λt → clamp(λt − rt yt, ± limit of the new λn).
struct NaturalMap {
  Eigen::VectorXd forces;
  std::vector<Grip> grips;
};
NaturalMap natural_map(const FrictionalProblem& problem, const Eigen::VectorXd& forces);
/// The same of laws, forces, y and the compliance by which y is judged.
NaturalMap natural_map(const std::vector<ForceLaw>& laws, const Eigen::VectorXd& forces, const Eigen::VectorXd& y,
                       const Eigen::VectorXd& compliance);

/// A term `weights` ∘ (λ − reference) added to y: it makes redundant contacts regular, and vanishes where λ is the
/// reference.
struct Proximal {
  Eigen::VectorXd weights;
  Eigen::VectorXd reference;
};

/// Forces with what they make, where that is wanted more than once: the product with W is what judging them costs.
struct Tried {
  Eigen::VectorXd forces;
  Eigen::VectorXd y;  ///< W λ + b
};
Tried tried(const FrictionalProblem& problem, Eigen::VectorXd forces);
NaturalMap natural_map(const FrictionalProblem& problem, const Tried& tried);
NaturalMap natural_map(const FrictionalProblem& problem, const Tried& tried, const Proximal& proximal);

/// Largest change of λ by the natural map: zero at the solution and only there.
double residual(const FrictionalProblem& problem, const Eigen::VectorXd& forces);
double residual(const FrictionalProblem& problem, const Tried& tried);

/// The pair of forces that the natural map would change most: it holds the residual up. At least one pair is there.
std::size_t worst_pair(const FrictionalProblem& problem, const Eigen::VectorXd& forces);

/// Whether every force is settled: the natural map changes it by no more than is acceptable, or it is one that its law
/// allows and its |y| is tolerated.
bool is_acceptable(const FrictionalProblem& problem, const Eigen::VectorXd& forces);
bool is_acceptable(const FrictionalProblem& problem, const Tried& tried);

/// The linear system of the last active set, for problems that differ in b alone.
struct KeptSystem;

/// Newton on the natural map from `start`; where that goes round in a cycle, a detour by the interior of the bounds,
/// and Newton again. The forces of open touches are exactly zero, but for those above `no_force`. `kept` is used
/// where its system is that of an active set, and holds the last one after.
FrictionalSolution solve(const FrictionalProblem& problem, const Eigen::VectorXd& start, KeptSystem* kept = nullptr);
FrictionalSolution solve(const FrictionalProblem& problem, Tried start, KeptSystem* kept = nullptr);

}  // namespace keyblock
