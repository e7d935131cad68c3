// Iterates on the crack strain; see crack_return.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "material/crack_return.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <utility>

#include "material/principal_axes.hpp"
#include "material/strength.hpp"

namespace keyblock {
namespace {

constexpr int kMostRounds = 60;
constexpr int kMostHalvings = 8;
// Error of the crack strain, per crack strain and closing strain, at which iterations end.
constexpr double kSettled = 4e-16;
// Error, per trial strain, left by rounding of stress.
constexpr double kGood = 1e-13;
// Largest error of a response that is used.
constexpr double kUsable = 1e-9;
// Slope along a direction, per slope at its start, at which a place is accepted.
constexpr double kFlatEnough = 0.1;

/// Finds the crack strain along the first two axes and, in plane strain, zz.
struct CrackSearch {
  const YieldLaw& intact;  ///< without the closure
  const CrackedElasticity& rock;
  const Eigen::Vector3d& strain;  ///< principal, of the trial
  const YieldState& before;
  double size;
  bool is_plane_stress;

  struct Point {
    Eigen::Vector3d cracks;  ///< w
    Response answer;         ///< of intact rock to the strain minus w, in principal axes
    Eigen::Vector3d missing;
    double error = 0;  ///< greatest missing strain, relative to that of a closed crack and w
  };

  Eigen::Vector3d stress(const Response& answer) const {
    return {answer.stress(0), answer.stress(1), answer.stress(3)};
  }

  Point at(const Eigen::Vector3d& cracks) const {
    Point p;
    p.cracks = cracks;
    YieldState state = before;
    state.elastic << strain(0) - cracks(0), strain(1) - cracks(1), 0, strain(2) - cracks(2);
    p.answer = is_plane_stress ? respond_intact_plane_stress(intact, Eigen::Vector3d::Zero(), state, size)
                               : respond_intact(intact, Eigen::Vector4d::Zero(), state, size);
    const Eigen::Vector3d s = stress(p.answer);
    p.missing.setZero();
    for (int i = 0; i < axes(); ++i) p.missing(i) = cracks(i) - rock.crack_strain(s(i));
    p.error = p.missing.cwiseAbs().maxCoeff() /
              std::max(cracks.cwiseAbs().maxCoeff(), -rock.compliance() * rock.closing_stress());
    return p;
  }

  /// Returns ∂(principal stress)/∂(principal strain) of intact rock.
  static Eigen::Matrix3d tangent(const Response& answer) {
    constexpr std::array<int, 3> place{0, 1, 3};
    Eigen::Matrix3d t;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        t(i, j) = answer.tangent(place[static_cast<std::size_t>(i)], place[static_cast<std::size_t>(j)]);
    return t;
  }

  /// Returns ∂w/∂σ of each axis.
  Eigen::Vector3d opening(const Point& p) const {
    const Eigen::Vector3d s = stress(p.answer);
    Eigen::Vector3d by = Eigen::Vector3d::Zero();
    for (int i = 0; i < axes(); ++i)
      if (!rock.is_closed(s(i))) by(i) = rock.compliance();
    return by;
  }

  /// Returns Newton's change of w: ∂(missing)/∂w = 1 + ∂w/∂σ ∂σ/∂ε.
  static Eigen::Vector3d change(const Point& p, const Eigen::Vector3d& opening, const Eigen::Vector3d& missing) {
    const Eigen::Matrix3d slope = Eigen::Matrix3d::Identity() + opening.asDiagonal() * tangent(p.answer);
    return -slope.partialPivLu().solve(missing);
  }

  /// Iterates from w and halves steps that overshoot; returns the best point found.
  Point settled(const Eigen::Vector3d& start) const {
    Point best = at(start);
    for (int round = 0; round < kMostRounds && best.error > kSettled; ++round) {
      Eigen::Vector3d step = change(best, opening(best), best.missing);
      bool is_better = false;
      for (int halving = 0; halving < kMostHalvings && !is_better && step.allFinite(); ++halving, step /= 2) {
        Point next = at(best.cracks + step);
        is_better = next.error < best.error;
        if (is_better) best = std::move(next);
      }
      if (!is_better) break;
    }
    return best;
  }

  /// Returns k w - σ, the gradient of ½ k w · w plus the energy of intact rock at ε - w. If flow is normal to the
  /// surface, w minimises that sum, with w_i no less than that of closed cracks.
  Eigen::Vector3d gradient(const Point& p) const {
    Eigen::Vector3d g = p.cracks / rock.compliance() - stress(p.answer);
    for (int i = axes(); i < 3; ++i) g(i) = 0;
    return g;
  }

  /// Returns Newton's direction among cracks that are not closed, or about to open.
  Eigen::Vector3d descent(const Point& p, const Eigen::Vector3d& gradient) const {
    Eigen::Vector3d step = Eigen::Vector3d::Zero();
    std::array<bool, 3> is_kept{};
    for (int i = 0; i < 3; ++i)
      is_kept[static_cast<std::size_t>(i)] = i >= axes() || (is_shut(p, i) && gradient(i) > 0);
    for (int round = 0; round < 3; ++round) {
      Eigen::Matrix3d slope = tangent(p.answer);
      slope.diagonal().array() += 1 / rock.compliance();
      Eigen::Vector3d right = -gradient;
      for (int i = 0; i < 3; ++i) {
        if (!is_kept[static_cast<std::size_t>(i)]) continue;
        slope.row(i).setZero();
        slope.col(i).setZero();
        slope(i, i) = 1;
        right(i) = 0;
      }
      step = slope.partialPivLu().solve(right);
      for (int i = 0; i < axes(); ++i) is_kept[static_cast<std::size_t>(i)] |= is_shut(p, i) && step(i) < 0;
    }
    for (int i = 0; i < 3; ++i)
      if (is_kept[static_cast<std::size_t>(i)]) step(i) = 0;
    return step;
  }

  bool is_shut(const Point& p, int i) const { return p.cracks(i) <= closed_strain() * (1 - kSettled); }

  /// Descends with the place along each direction bracketed by the sign of the slope there. It is used if iterations by
  /// the error alternate between sides of an edge.
  Point descended(const Eigen::Vector3d& start) const {
    const auto within = [&](const Eigen::Vector3d& w) { return Eigen::Vector3d(w.cwiseMax(closed_strain())); };
    Point now = at(within(start)), best = now;
    for (int round = 0; round < kMostRounds && best.error > kSettled; ++round) {
      const Eigen::Vector3d first = gradient(now);
      const Eigen::Vector3d step = descent(now, first);
      const double falls = first.dot(step);
      if (!step.allFinite() || !(falls < 0)) break;
      double reach = 1;
      for (int i = 0; i < axes(); ++i)
        if (step(i) < 0) reach = std::min(reach, (closed_strain() - now.cracks(i)) / step(i));
      double low = 0, high = reach, share = reach;
      Point next = at(within(now.cracks + share * step));
      for (int halving = 0; halving < kMostRounds; ++halving) {
        const double slope = gradient(next).dot(step);
        if (slope <= kFlatEnough * -falls && (share == reach || slope >= kFlatEnough * falls)) break;
        (slope > 0 ? high : low) = share;
        share = low + (high - low) / 2;
        next = at(within(now.cracks + share * step));
      }
      now = std::move(next);
      if (now.error < best.error) best = now;
    }
    return best;
  }

  Point found(const Eigen::Vector3d& start) const {
    const Point first = settled(start);
    if (misses_by(first) <= kGood) return first;
    const Point second = descended(first.cracks);
    return second.error < first.error ? second : first;
  }

  /// Returns the missing strain relative to the trial strain, or to that of a closed crack if larger.
  double misses_by(const Point& p) const {
    return p.missing.cwiseAbs().maxCoeff<Eigen::PropagateNaN>() /
           std::max(strain.cwiseAbs().maxCoeff(), -closed_strain());
  }

  double closed_strain() const { return rock.compliance() * rock.closing_stress(); }
  int axes() const { return is_plane_stress ? 2 : 3; }
};

Response respond_with_cracks(const YieldLaw& law, const Eigen::Vector4d& increment, const YieldState& before,
                             double size, bool is_plane_stress) {
  const CrackedElasticity rock = law.cracked();
  const Eigen::Vector4d strain = before.elastic + increment;
  const CrackedResponse elastic = cracked_response(rock, strain, is_plane_stress);
  Response r;
  r.stress = elastic.stress;
  r.tangent = elastic.tangent;
  r.stored = elastic.stored;
  r.plastic.setZero();
  r.after = {
      .elastic = elastic.strain, .plastic = before.plastic, .kappa = before.kappa, .region = YieldRegion::elastic};
  const SurfaceOfKappa surface{law.strength, strain_of_change(law.strength, size)};
  Eigen::Vector3d principal = PlaneAxes(elastic.stress).values;
  std::ranges::sort(principal, std::greater<>());
  if (!(excess_of_stress(surface, before.kappa, principal) > 0)) return r;

  YieldLaw intact = law;
  intact.closure.reset();
  const PlaneAxes axes(Eigen::Vector4d(strain(0), strain(1), strain(2) / 2, strain(3)));
  const CrackSearch search{intact, rock, axes.values, before, size, is_plane_stress};
  const Eigen::Index count = is_plane_stress ? 2 : 3;
  Eigen::Vector3d start = Eigen::Vector3d::Zero();
  start.head(count) = cracked_state(rock, axes.values.head(count)).cracks;
  const CrackSearch::Point end = search.found(start);
  r.is_found = search.misses_by(end) <= kUsable;
  const Eigen::Vector3d stress = search.stress(end.answer);
  // σ(ε - w), dw = ∂w/∂σ dσ.
  const Eigen::Matrix3d by_strain = CrackSearch::tangent(end.answer);
  const Eigen::Matrix3d normal =
      (Eigen::Matrix3d::Identity() + by_strain * search.opening(end).asDiagonal()).partialPivLu().solve(by_strain);
  r.stress = axes.tensor(stress);
  r.tangent = isotropic_tangent(axes, stress, normal);
  r.after.elastic = law.elastic_strain(r.stress);
  r.after.region = end.answer.after.region;
  r.after.kappa = end.answer.after.kappa;
  Eigen::Vector4d total = strain;
  if (is_plane_stress) total(3) = end.answer.after.elastic(3) + end.answer.plastic(3);
  r.plastic = total - r.after.elastic;
  r.after.plastic += r.plastic;
  r.stored = cracked_response(rock, r.after.elastic, is_plane_stress).stored;
  return r;
}

}  // namespace

Response respond(const YieldLaw& law, const Eigen::Vector4d& increment, const YieldState& before, double size) {
  return law.closure ? respond_with_cracks(law, increment, before, size, false)
                     : respond_intact(law, increment, before, size);
}

Response respond_plane_stress(const YieldLaw& law, const Eigen::Vector3d& increment, const YieldState& before,
                              double size) {
  if (!law.closure) return respond_intact_plane_stress(law, increment, before, size);
  return respond_with_cracks(law, {increment(0), increment(1), increment(2), 0}, before, size, true);
}

}  // namespace keyblock
