// Finds the sides of the surface that limit a trial stress, and the stress there.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "material/principal/principal_return.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <unsupported/Eigen/AutoDiff>

#include "material/principal/cone_return.hpp"
#include "problem/units/unit_conversion.hpp"

namespace keyblock {
namespace {

using namespace principal;

// Rounding error of multipliers, order and limits, per stress, allowed in the choice of sides.
constexpr double kRoundOff = 1e-13;

// ---- planes in principal stresses: Tresca, Mohr–Coulomb, limits of tension

template <class T>
T passive_ratio(const T& angle) {
  using std::sin;
  const T sine = sin(angle);
  return T((1.0 + sine) / (1.0 - sine));
}

/// Planes k σi - σj ≤ f_c with flow m e_i - e_j, and σi ≤ T with T at most the apex.
template <class T>
struct Planes {
  T ratio, flow, strength, tension;
  bool limited = false;

  Planes(const SurfaceOfKappa& surface, double kappa) {
    using std::sqrt;
    const ValuesAt<T> v(surface, kappa);
    ratio = passive_ratio(v.friction);
    flow = passive_ratio(v.dilation);
    strength = T(2.0 * v.cohesion * sqrt(ratio));
    tension = v.tension;
    limited = v.limited && (!has_apex() || value_of(tension) < value_of(apex()));
  }
  bool has_apex() const { return value_of(ratio) > 1; }
  T apex() const { return T(strength / (ratio - 1.0)); }
};

/// Shear side between two principal stresses, or the tension limit of one (`lesser` < 0).
struct Side {
  int greater = 0;
  int lesser = -1;
};

/// Sides that limit a stress together, and the region they form.
struct Corner {
  std::array<Side, 3> sides;
  int count;
  YieldRegion region;
};

constexpr Corner kPlane{{{{0, 2}}}, 1, YieldRegion::plane};
constexpr Corner kUpperEdge{{{{0, 2}, {1, 2}}}, 2, YieldRegion::edge};  // σ1 = σ2
constexpr Corner kLowerEdge{{{{0, 2}, {0, 1}}}, 2, YieldRegion::edge};  // σ2 = σ3
constexpr Corner kApex{{}, 0, YieldRegion::apex};
constexpr std::array<Corner, 8> kTensionCorners = {{
    {{{{0}}}, 1, YieldRegion::tension},
    {{{{0}, {1}}}, 2, YieldRegion::tension},
    {{{{0}, {1}, {2}}}, 3, YieldRegion::tension},
    {{{{0, 2}, {0}}}, 2, YieldRegion::tension},
    {{{{0, 2}, {0, 1}, {0}}}, 3, YieldRegion::tension},
    {{{{0, 2}, {0}, {1}}}, 3, YieldRegion::tension},
    {{{{1, 2}, {0}, {1}}}, 3, YieldRegion::tension},
    {{{{0, 2}, {1, 2}, {0}}}, 3, YieldRegion::tension},
}};

/// Normal of a side, D times its flow, and its limit.
template <class T>
struct SideAt {
  PrincipalValues<T> normal, relaxed;
  T limit;

  SideAt(Side side, const Planes<T>& p, const Eigen::Matrix3d& d) {
    normal.fill(T(0.0));
    PrincipalValues<T> flow;
    flow.fill(T(0.0));
    const auto i = static_cast<std::size_t>(side.greater);
    if (side.lesser < 0) {
      normal[i] = flow[i] = T(1.0);
      limit = p.tension;
    } else {
      const auto j = static_cast<std::size_t>(side.lesser);
      normal[i] = p.ratio;
      flow[i] = p.flow;
      normal[j] = flow[j] = T(-1.0);
      limit = p.strength;
    }
    for (int row = 0; row < 3; ++row) {
      const auto r = static_cast<std::size_t>(row);
      relaxed[r] = T(d(row, 0) * flow[0] + d(row, 1) * flow[1] + d(row, 2) * flow[2]);
    }
  }
};

template <class T>
T dot(const PrincipalValues<T>& a, const PrincipalValues<T>& b) {
  return T(a[0] * b[0] + a[1] * b[1] + a[2] * b[2]);
}

/// Returns the plastic multipliers x of the sides of a corner.
Eigen::Vector3d multipliers(const Corner& corner, const PrincipalValues<double>& trial, const Planes<double>& p,
                            const Eigen::Matrix3d& d) {
  Eigen::Matrix3d system = Eigen::Matrix3d::Identity();
  Eigen::Vector3d beyond = Eigen::Vector3d::Zero();
  for (int i = 0; i < corner.count; ++i) {
    const SideAt<double> side(corner.sides[static_cast<std::size_t>(i)], p, d);
    beyond(i) = dot(side.normal, trial) - side.limit;
    for (int j = 0; j < corner.count; ++j)
      system(i, j) = dot(side.normal, SideAt<double>(corner.sides[static_cast<std::size_t>(j)], p, d).relaxed);
  }
  return system.partialPivLu().solve(beyond);
}

/// Returns the stress on one or two sides, before rounding is removed from the values that they fix.
template <class T>
PrincipalValues<T> relaxed_onto(const Corner& corner, const PrincipalValues<T>& trial, const Planes<T>& p,
                                const Eigen::Matrix3d& d) {
  const SideAt<T> a(corner.sides[0], p, d);
  const T beyond = T(dot(a.normal, trial) - a.limit);
  const T stiffness = dot(a.normal, a.relaxed);
  PrincipalValues<T> stress = trial;
  if (corner.count == 1) {
    const T x = T(beyond / stiffness);
    for (std::size_t i = 0; i < 3; ++i) stress[i] = T(trial[i] - x * a.relaxed[i]);
    return stress;
  }
  const SideAt<T> b(corner.sides[1], p, d);
  const T other_beyond = T(dot(b.normal, trial) - b.limit);
  const T ab = dot(a.normal, b.relaxed), ba = dot(b.normal, a.relaxed), bb = dot(b.normal, b.relaxed);
  const T determinant = T(stiffness * bb - ab * ba);
  const T x = T((beyond * bb - ab * other_beyond) / determinant);
  const T y = T((stiffness * other_beyond - ba * beyond) / determinant);
  for (std::size_t i = 0; i < 3; ++i) stress[i] = T(trial[i] - x * a.relaxed[i] - y * b.relaxed[i]);
  return stress;
}

/// Returns the stress in a corner. The values fixed by its sides are set, not subtracted, so that it lies on them to
/// the last digit.
template <class T>
PrincipalValues<T> land(const Corner& corner, const PrincipalValues<T>& trial, const Planes<T>& p,
                        const Eigen::Matrix3d& d) {
  const auto below = [&](const T& greater) { return T(p.ratio * greater - p.strength); };
  if (corner.count == 0) return {p.apex(), p.apex(), p.apex()};
  const bool limits = corner.region == YieldRegion::tension;
  const bool shears = corner.sides[0].lesser >= 0;
  if (corner.count == 3) {
    if (!shears) return {p.tension, p.tension, p.tension};
    const T low = below(p.tension);
    const bool lower = corner.sides[1].lesser == 1;
    return {p.tension, lower ? low : p.tension, low};
  }
  const PrincipalValues<T> s = relaxed_onto(corner, trial, p, d);
  if (!limits) {
    if (corner.count == 1) return {s[0], s[1], below(s[0])};
    if (corner.sides[1].greater == 0) return {s[0], below(s[0]), below(s[0])};
    const T both = T((s[0] + s[1]) / 2.0);
    return {both, both, below(both)};
  }
  if (shears) return {p.tension, s[1], below(p.tension)};
  return {p.tension, corner.count == 2 ? p.tension : s[1], s[2]};
}

Corner shear_corner(const PrincipalValues<double>& trial, const Planes<double>& p, const Eigen::Matrix3d& d) {
  const PrincipalValues<double> plane = land(kPlane, trial, p, d);
  // Equal stresses stay equal: near the plane, rounding would decide which of them alone is limited.
  const double equal = kRoundOff * std::max({std::abs(trial[0]), std::abs(trial[2]), p.strength});
  const bool upper = plane[0] < plane[1] || trial[0] - trial[1] <= equal;
  const bool lower = plane[1] < plane[2] || trial[1] - trial[2] <= equal;
  if (!upper && !lower) return kPlane;
  const auto holds = [&](const Corner& edge) {
    const PrincipalValues<double> s = land(edge, trial, p, d);
    return !p.has_apex() || s[0] >= s[2];
  };
  if (upper && holds(kUpperEdge)) {
    const bool also_lower = lower && (multipliers(kUpperEdge, trial, p, d).head<2>().array() < 0).any();
    if (!also_lower) return kUpperEdge;
  }
  if (lower && holds(kLowerEdge)) return kLowerEdge;
  return kApex;
}

/// Returns by how much a corner's stress violates the conditions of the solution.
double fault_of(const Corner& corner, const PrincipalValues<double>& trial, const Planes<double>& p,
                const Eigen::Matrix3d& d) {
  const PrincipalValues<double> s = land(corner, trial, p, d);
  double fault = std::max({s[1] - s[0], s[2] - s[1], s[0] - p.tension, p.ratio * s[0] - s[2] - p.strength});
  const Eigen::Vector3d x = multipliers(corner, trial, p, d) * d(0, 0);
  for (int i = 0; i < corner.count; ++i) fault = std::max(fault, -x(i));
  return std::isfinite(fault) ? fault : std::numeric_limits<double>::infinity();
}

Corner corner_of(const PrincipalValues<double>& trial, const Planes<double>& p, const Eigen::Matrix3d& d) {
  const bool sheared = p.ratio * trial[0] - trial[2] > p.strength;
  const Corner shear = sheared ? shear_corner(trial, p, d) : kPlane;
  if (!p.limited || (sheared ? land(shear, trial, p, d)[0] : trial[0]) <= p.tension) return shear;
  const double rounding = kRoundOff * std::max({std::abs(trial[0]), std::abs(trial[2]), p.strength});
  const Corner* least = kTensionCorners.data();
  double least_fault = std::numeric_limits<double>::infinity();
  for (const Corner& corner : kTensionCorners) {
    const double fault = fault_of(corner, trial, p, d);
    if (fault <= rounding) return corner;
    if (fault < least_fault) {
      least = &corner;
      least_fault = fault;
    }
  }
  return *least;
}

// ---- planes and cones

bool has_planes(const SurfaceOfKappa& surface) {
  return surface.strength.surface == YieldSurface::tresca || surface.strength.surface == YieldSurface::mohr_coulomb;
}

double bulk_of(const Eigen::Matrix3d& d) {
  return (d(0, 0) + 2 * d(0, 1)) / 3;
}
double shear_modulus_of(const Eigen::Matrix3d& d) {
  return (d(0, 0) - d(0, 1)) / 2;
}

YieldRegion region_of(ConePart part) {
  if (part == ConePart::cone) return YieldRegion::plane;
  return part == ConePart::apex ? YieldRegion::apex : YieldRegion::tension;
}

PrincipalValues<double> array_of(const Eigen::Vector3d& v) {
  return {v(0), v(1), v(2)};
}

Eigen::Vector3d ordered(const PrincipalValues<double>& s) {
  return {std::max(s[0], s[2]), std::clamp(s[1], std::min(s[0], s[2]), std::max(s[0], s[2])), std::min(s[0], s[2])};
}

}  // namespace

Cone cone_of(ConeMatching matching, double cohesion, double friction_deg) {
  Cone cone;
  ConeAt<double>::matched(matching, cohesion, friction_deg * kDegree, cone.slope, cone.strength);
  return cone;
}

double surface_scale(const SurfaceOfKappa& surface, double kappa) {
  if (has_planes(surface)) return Planes<double>(surface, kappa).strength;
  return ConeAt<double>(surface, kappa).strength * std::numbers::sqrt3;
}

double excess_of_stress(const SurfaceOfKappa& surface, double kappa, const Eigen::Vector3d& stress) {
  if (has_planes(surface)) {
    const Planes<double> p(surface, kappa);
    const double shear = p.ratio * stress(0) - stress(2) - p.strength;
    return p.limited ? std::max(shear, stress(0) - p.tension) : shear;
  }
  const ConeAt<double> cone(surface, kappa);
  const double mean = stress.mean();
  const double shear = shear_of(array_of(stress)) + 3 * cone.slope * mean - cone.strength;
  return cone.limited ? std::max(shear, mean - cone.tension) : shear;
}

Eigen::Vector3d stress_on_surface(const SurfaceOfKappa& surface, double kappa, const Eigen::Vector3d& trial,
                                  const Eigen::Matrix3d& d) {
  if (!(excess_of_stress(surface, kappa, trial) > 0)) return trial;
  const PrincipalValues<double> from = array_of(trial);
  if (has_planes(surface)) {
    const Planes<double> p(surface, kappa);
    return ordered(land(corner_of(from, p, d), from, p, d));
  }
  const ConeAt<double> cone(surface, kappa);
  const double bulk = bulk_of(d), shear = shear_modulus_of(d);
  return ordered(land(part_of(from, cone, bulk, shear), from, cone, bulk, shear));
}

PrincipalReturn return_to_surface(const SurfaceOfKappa& surface, double kappa, const Eigen::Vector3d& trial,
                                  const Eigen::Matrix3d& d) {
  PrincipalReturn back;
  back.stress = trial;
  back.by_trial.setIdentity();
  back.by_kappa.setZero();
  if (!(excess_of_stress(surface, kappa, trial) > 0)) return back;
  const PrincipalValues<double> from = array_of(trial);
  PrincipalValues<Dual> dual;
  for (int i = 0; i < 3; ++i) dual[static_cast<std::size_t>(i)] = Dual(trial(i), 4, i);
  PrincipalValues<Dual> landed;
  if (has_planes(surface)) {
    const Corner corner = corner_of(from, Planes<double>(surface, kappa), d);
    landed = land(corner, dual, Planes<Dual>(surface, kappa), d);
    back.region = corner.region;
  } else {
    const double bulk = bulk_of(d), shear = shear_modulus_of(d);
    const ConePart part = part_of(from, ConeAt<double>(surface, kappa), bulk, shear);
    landed = land(part, dual, ConeAt<Dual>(surface, kappa), bulk, shear);
    back.region = region_of(part);
  }
  PrincipalValues<double> values;
  for (std::size_t i = 0; i < 3; ++i) {
    values[i] = landed[i].value();
    back.by_trial.row(static_cast<Eigen::Index>(i)) = landed[i].derivatives().head<3>();
    back.by_kappa(static_cast<Eigen::Index>(i)) = landed[i].derivatives()(3);
  }
  back.stress = ordered(values);
  return back;
}

}  // namespace keyblock
