// Computes stress, tangent and new memory of an elastoplastic point from a strain increment and its memory.
// Theory: docs/theory/09-plasticity.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>

#include "material/crack_closure.hpp"
#include "material/principal/principal_return.hpp"
#include "problem/analysis.hpp"
#include "problem/yield.hpp"

namespace keyblock {

/// Isotropic elastic material with a strength, or with cracks that close, or both.
struct YieldLaw {
  double youngs_modulus = 0;
  double poissons_ratio = 0;
  Strength strength;
  std::optional<CrackClosure> closure = {};
  bool may_yield = true;  ///< false: the strength is one that no stress reaches

  /// Returns D of (xx, yy, 2xy, zz), 4 × 4; that of closed cracks.
  Eigen::Matrix4d modulus() const;

  /// Returns the elastic strain of a stress (xx, yy, xy, zz), including that of cracks.
  Eigen::Vector4d elastic_strain(const Eigen::Vector4d& stress) const;
  /// Returns the part of the strain between cracks, D⁻¹ σ.
  Eigen::Vector4d intact_strain(const Eigen::Vector4d& stress) const;

  /// Returns true if ∂stress/∂strain is symmetric at every stress: flow normal to a constant surface, or von Mises.
  bool has_symmetric_tangent() const;

  /// Precondition: the law has a closure.
  CrackedElasticity cracked() const { return {youngs_modulus, poissons_ratio, *closure}; }
};

/// Returns the law of a material; rock without a strength gets one that no stress reaches.
YieldLaw yield_law(const BlockMaterial& material);

/// Memory of a point. Strains as (xx, yy, 2xy, zz).
struct YieldState {
  Eigen::Vector4d elastic = Eigen::Vector4d::Zero();  ///< includes that of an initial stress and of cracks
  Eigen::Vector4d plastic = Eigen::Vector4d::Zero();  ///< since the start
  double kappa = 0;                                   ///< ∫ √(2/3) ‖dev dεᵖ‖
  YieldRegion region = YieldRegion::elastic;          ///< region at the end of the last increment
};

/// Response of a point. Stresses as (xx, yy, xy, zz), tension positive.
struct Response {
  Eigen::Vector4d stress;
  Eigen::Matrix4d tangent;  ///< ∂stress/∂increment; not symmetric if flow is not normal
  double stored = 0;        ///< ½ εᵉ · D εᵉ, or W of cracks
  Eigen::Vector4d plastic;  ///< increment of the plastic strain
  YieldState after;
  bool is_found = true;  ///< false: the search for the crack strain failed, and no value here is valid
};

/// Returns the response of rock without cracks that close, with the return in principal stresses (`principal_return`)
/// at the end of the increment. It is implicit in κ, the one scalar unknown, which is bracketed. The tangent is the
/// exact derivative. The rotation of the axes in the plane gives G (σ1 - σ2)/(σ1ᵗʳ - σ2ᵗʳ) (de Souza Neto, Perić & Owen
/// 2008, app. A). Pure. `size`: √area of the point, for softening by fracture energy. All laws: `respond`.
Response respond_intact(const YieldLaw& law, const Eigen::Vector4d& increment, const YieldState& before, double size);

/// Returns the response under plane stress: the zz of the increment makes the stress zz zero. The tangent is that of
/// the three strains in the plane (row and column of zz are 0). Stress zz is zero up to rounding of the strength. If no
/// zz reaches that, it is zero up to rounding of the greatest stress at the last try.
Response respond_intact_plane_stress(const YieldLaw& law, const Eigen::Vector3d& increment, const YieldState& before,
                                     double size);

}  // namespace keyblock
