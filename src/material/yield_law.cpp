// Finds the axes of the trial stress, the plastic strain of a return, and the tangent in the plane.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "material/yield_law.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>

#include "material/principal_axes.hpp"
#include "material/strength.hpp"

namespace keyblock {
namespace {

// Difference of principal trial stresses, per greatest, below which they count as equal.
constexpr double kEqualStresses = 1e-7;
// Bound on iterations of the bracketed searches; each at least halves the bracket.
constexpr int kMostRounds = 200;
// Stress across the plane, per stress, that counts as zero.
constexpr double kNoStress = 1e-14;

/// In-plane axes of a stress (xx, yy, xy, zz) and its principal values in falling order.
struct Axes : PlaneAxes {
  std::array<int, 3> sorted;  // indices of the values, greatest first

  explicit Axes(const Eigen::Vector4d& stress) : PlaneAxes(stress) {
    // Equal values keep a fixed order: the first axis of the plane, zz, the second.
    sorted = {0, 2, 1};
    std::stable_sort(sorted.begin(), sorted.end(), [&](int a, int b) { return values(a) > values(b); });
  }

  Eigen::Vector3d in_order() const { return {values(sorted[0]), values(sorted[1]), values(sorted[2])}; }

  /// Converts sorted values to those of the first and second axis and zz.
  Eigen::Vector3d back(const Eigen::Vector3d& principal) const {
    Eigen::Vector3d v;
    for (int i = 0; i < 3; ++i) v(sorted[static_cast<std::size_t>(i)]) = principal(i);
    return v;
  }
};

/// Returns √(2/3) ‖dev ε‖ of a strain in principal axes (Hill 1950).
double equivalent(const Eigen::Vector3d& strain) {
  return std::sqrt(2.0 / 3) * (strain.array() - strain.mean()).matrix().norm();
}

/// Return whose κ equals that of its own plastic strain.
struct Flow {
  const SurfaceOfKappa& surface;
  const Eigen::Matrix3d& modulus;     // in principal axes
  const Eigen::Matrix3d& compliance;  // its inverse
  const Eigen::Vector3d& trial;
  double before;

  double missing(double kappa) const {
    const Eigen::Vector3d stress = stress_on_surface(surface, kappa, trial, modulus);
    return kappa - before - equivalent(compliance * (trial - stress));
  }

  /// Returns κ of the surface at the end. It lies between no flow and the loss of the whole deviator, or beyond under
  /// dilation. If strength does not change, it is the initial κ.
  double kappa() const {
    if (!surface.strength.change) return before;  // the surface does not depend on κ
    if (before >= surface.strain) return before - missing(before);
    double upper = before + std::max(-missing(before), equivalent(compliance * trial));
    for (int i = 0; i < kMostRounds && missing(upper) < 0; ++i) upper = before + 2 * (upper - before);
    if (!(missing(before) < 0)) return before;
    if (!(missing(upper) > 0)) return upper;
    std::uintmax_t rounds = kMostRounds;
    const auto close = [](double a, double b) { return std::abs(b - a) <= 4e-16 * std::max(std::abs(a), std::abs(b)); };
    const auto bracket =
        boost::math::tools::toms748_solve([this](double k) { return missing(k); }, before, upper, close, rounds);
    return std::abs(missing(bracket.first)) <= std::abs(missing(bracket.second)) ? bracket.first : bracket.second;
  }

  /// Returns ∂κ/∂trial, of g(κ, trial) = κ - κ0 - Δκ(C (trial - σ)) = 0.
  Eigen::RowVector3d kappa_by_trial(const PrincipalReturn& back) const {
    const Eigen::Vector3d plastic = compliance * (trial - back.stress);
    const double size = equivalent(plastic);
    if (!(size > 0)) return Eigen::RowVector3d::Zero();
    const Eigen::Vector3d deviator = plastic.array() - plastic.mean();
    const Eigen::RowVector3d by_plastic = (2.0 / 3 / size) * deviator.transpose();
    const double by_kappa = 1 + by_plastic * compliance * back.by_kappa;
    const Eigen::RowVector3d by_trial = by_plastic * compliance * (Eigen::Matrix3d::Identity() - back.by_trial);
    return by_trial / by_kappa;
  }
};

Eigen::Matrix3d principal_modulus(const Eigen::Matrix4d& d) {
  Eigen::Matrix3d p = Eigen::Matrix3d::Constant(d(0, 1));
  p.diagonal().setConstant(d(0, 0));
  return p;
}

Eigen::Matrix3d principal_compliance(const YieldLaw& law) {
  Eigen::Matrix3d c = Eigen::Matrix3d::Constant(-law.poissons_ratio / law.youngs_modulus);
  c.diagonal().setConstant(1 / law.youngs_modulus);
  return c;
}

/// Returns ∂stress/∂strain from the derivative of sorted principal stresses by sorted trial stresses.
Eigen::Matrix4d tangent_of(const Axes& axes, const Eigen::Matrix3d& sorted_by_trial, const Eigen::Vector3d& landed,
                           const Eigen::Matrix3d& modulus, double shear) {
  Eigen::Matrix3d by_trial;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      by_trial(axes.sorted[static_cast<std::size_t>(i)], axes.sorted[static_cast<std::size_t>(j)]) =
          sorted_by_trial(i, j);
  const Eigen::Matrix3d normal = by_trial * modulus;
  const double gap = axes.values(0) - axes.values(1);
  const double scale = axes.values.cwiseAbs().maxCoeff();
  const double spin = gap > kEqualStresses * scale
                          ? (landed(0) - landed(1)) / gap
                          : (by_trial(0, 0) - by_trial(0, 1) - by_trial(1, 0) + by_trial(1, 1)) / 2;
  Eigen::Matrix4d local = Eigen::Matrix4d::Zero();
  constexpr std::array<int, 3> place = {0, 1, 3};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      local(place[static_cast<std::size_t>(i)], place[static_cast<std::size_t>(j)]) = normal(i, j);
  local(2, 2) = shear * spin;
  const Eigen::Matrix4d turn = axes.turn();
  return turn.transpose() * local * turn;
}

}  // namespace

Eigen::Matrix4d YieldLaw::modulus() const {
  const double shear = youngs_modulus / (2 * (1 + poissons_ratio));
  const double lame = youngs_modulus * poissons_ratio / ((1 + poissons_ratio) * (1 - 2 * poissons_ratio));
  Eigen::Matrix4d d = Eigen::Matrix4d::Constant(lame);
  d.diagonal().array() += 2 * shear;
  d.row(2).setZero();
  d.col(2).setZero();
  d(2, 2) = shear;
  return d;
}

Eigen::Vector4d YieldLaw::elastic_strain(const Eigen::Vector4d& stress) const {
  if (!closure) return intact_strain(stress);
  const PlaneAxes axes(stress);
  const CrackedElasticity rock = cracked();
  Eigen::Vector4d cracks = axes.tensor(axes.values.unaryExpr([&](double s) { return rock.crack_strain(s); }));
  cracks(2) *= 2;
  return intact_strain(stress) + cracks;
}

Eigen::Vector4d YieldLaw::intact_strain(const Eigen::Vector4d& s) const {
  const double nu = poissons_ratio;
  return Eigen::Vector4d(s(0) - nu * (s(1) + s(3)), s(1) - nu * (s(0) + s(3)), 2 * (1 + nu) * s(2),
                         s(3) - nu * (s(0) + s(1))) /
         youngs_modulus;
}

bool YieldLaw::has_symmetric_tangent() const {
  if (!may_yield || strength.surface == YieldSurface::von_mises) return true;
  if (strength.change) return false;
  return strength.surface == YieldSurface::tresca || strength.values.friction_deg == strength.values.dilation_deg;
}

YieldLaw yield_law(const BlockMaterial& material) {
  return {material.youngs_modulus, material.poissons_ratio,
          material.strength ? *material.strength : unreachable_strength(), material.crack_closure,
          material.strength != nullptr};
}

Response respond_intact(const YieldLaw& law, const Eigen::Vector4d& increment, const YieldState& before, double size) {
  const Eigen::Matrix4d modulus = law.modulus();
  const Eigen::Vector4d strain = before.elastic + increment;
  Response r;
  r.stress = modulus * strain;
  r.tangent = modulus;
  r.plastic.setZero();
  r.after = {.elastic = strain, .plastic = before.plastic, .kappa = before.kappa, .region = YieldRegion::elastic};
  r.stored = strain.dot(r.stress) / 2;
  const Axes axes(r.stress);
  const Eigen::Vector3d trial = axes.in_order();
  const SurfaceOfKappa surface{law.strength, strain_of_change(law.strength, size)};
  if (!(excess_of_stress(surface, before.kappa, trial) > 0)) return r;

  const Eigen::Matrix3d principal = principal_modulus(modulus);
  const Eigen::Matrix3d compliance = principal_compliance(law);
  const Flow flow{surface, principal, compliance, trial, before.kappa};
  const double kappa = flow.kappa();
  const PrincipalReturn back = return_to_surface(surface, kappa, trial, principal);
  Eigen::Matrix3d by_trial = back.by_trial;
  if (law.strength.change) by_trial += back.by_kappa * flow.kappa_by_trial(back);
  r.after.kappa = law.strength.change ? kappa : before.kappa + equivalent(compliance * (trial - back.stress));
  const Eigen::Vector3d landed = axes.back(back.stress);
  r.stress = axes.tensor(landed);
  r.tangent = tangent_of(axes, by_trial, landed, principal, modulus(2, 2));
  r.after.elastic = law.elastic_strain(r.stress);
  r.after.region = back.region;
  r.plastic = strain - r.after.elastic;
  r.after.plastic += r.plastic;
  r.stored = r.after.elastic.dot(r.stress) / 2;
  return r;
}

Response respond_intact_plane_stress(const YieldLaw& law, const Eigen::Vector3d& increment, const YieldState& before,
                                     double size) {
  const Eigen::Matrix4d modulus = law.modulus();
  Eigen::Vector4d all(increment(0), increment(1), increment(2), 0);
  const Eigen::Vector4d elastic = modulus * (before.elastic + all);
  double across = -elastic(3) / modulus(3, 3);  // of an elastic point
  const auto at = [&](double zz) {
    all(3) = zz;
    return respond_intact(law, all, before, size);
  };
  Response r = at(across);
  const SurfaceOfKappa surface{law.strength, strain_of_change(law.strength, size)};
  const double strength = is_reachable(law.strength) ? surface_scale(surface, before.kappa) : 0;
  const double scale = std::max(elastic.cwiseAbs().maxCoeff(), strength);
  // Stress across rises with the strain across: expand to a bracket, then take Newton steps inside it.
  double low = across, high = across;
  double reach = std::max(std::abs(r.stress(3)), kNoStress * scale) / modulus(3, 3);
  const bool rising = r.stress(3) < 0;
  for (int i = 0; i < kMostRounds && (rising ? r.stress(3) < 0 : r.stress(3) > 0); ++i) {
    (rising ? low : high) = across;
    across += rising ? reach : -reach;
    (rising ? high : low) = across;
    reach *= 2;
    r = at(across);
  }
  for (int i = 0; i < kMostRounds && std::abs(r.stress(3)) > kNoStress * scale && low < high; ++i) {
    (r.stress(3) < 0 ? low : high) = across;
    const double newton = across - r.stress(3) / r.tangent(3, 3);
    const double next = newton > low && newton < high ? newton : low + (high - low) / 2;
    if (next == across) break;
    across = next;
    r = at(across);
  }
  if (r.tangent(3, 3) > 0) r.tangent -= (r.tangent.col(3) * r.tangent.row(3) / r.tangent(3, 3)).eval();
  r.tangent.row(3).setZero();
  r.tangent.col(3).setZero();
  return r;
}

}  // namespace keyblock
