// Law of a point that may yield: from an increment of strain and its memory to stress, tangent and new memory.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>

#include "material/crack_closure.hpp"
#include "material/principal_return.hpp"
#include "problem/analysis.hpp"
#include "problem/yield.hpp"

namespace keyblock {

/// An isotropic elastic material with a strength, or with cracks that close, or both.
struct YieldLaw {
  double youngs_modulus = 0;
  double poissons_ratio = 0;
  Strength strength;
  std::optional<CrackClosure> closure = {};
  bool may_yield = true;  ///< false: the strength is one that nothing reaches

  /// D of (xx, yy, 2xy, zz), 4 × 4; of closed cracks.
  Eigen::Matrix4d modulus() const;

  /// Elastic strain of a stress (xx, yy, xy, zz), that of cracks included.
  Eigen::Vector4d elastic_strain(const Eigen::Vector4d& stress) const;
  /// Its part between cracks, D⁻¹ σ.
  Eigen::Vector4d intact_strain(const Eigen::Vector4d& stress) const;

  /// Whether ∂stress/∂strain is symmetric at every stress: flow normal to a surface that stays, or of von Mises.
  bool has_symmetric_tangent() const;

  /// Only of one with a closure.
  CrackedElasticity cracked() const { return {youngs_modulus, poissons_ratio, *closure}; }
};

/// Of a material; rock without a strength has one that nothing reaches.
YieldLaw yield_law(const BlockMaterial& material);

/// What a point remembers. Strains as (xx, yy, 2xy, zz).
struct YieldState {
  Eigen::Vector4d elastic = Eigen::Vector4d::Zero();  ///< of an initial stress too, and of cracks
  Eigen::Vector4d plastic = Eigen::Vector4d::Zero();  ///< since the start
  double kappa = 0;                                   ///< ∫ √(2/3) ‖dev dεᵖ‖
  YieldRegion region = YieldRegion::elastic;          ///< where the last increment ended
};

/// What a point answers. Stresses as (xx, yy, xy, zz), tension positive.
struct Response {
  Eigen::Vector4d stress;
  Eigen::Matrix4d tangent;  ///< ∂stress/∂increment; not symmetric where flow is not normal
  double stored = 0;        ///< ½ εᵉ · D εᵉ, or W of cracks
  Eigen::Vector4d plastic;  ///< increment of the plastic strain
  YieldState after;
  bool is_found = true;  ///< false: the search for the strain of cracks ended off it, and nothing of this holds
};

/// The return in principal stresses (`principal_return`) at the end of the increment, implicit in κ: one scalar
/// unknown, bracketed. The tangent is the exact derivative, with the turn of the axes in the plane,
/// G (σ1 - σ2)/(σ1ᵗʳ - σ2ᵗʳ) (de Souza Neto, Perić & Owen 2008, app. A). Pure. `size`: √area of the point, for
/// softening by fracture energy. Cracks that close: `respond_with_cracks`.
Response respond(const YieldLaw& law, const Eigen::Vector4d& increment, const YieldState& before, double size);

/// Under plane stress: the increment's zz is found so that the stress zz is none; the tangent is that of the three
/// strains in the plane (row and column of zz are 0). Stress zz is none to rounding of the strength, or of the greatest
/// stress at the last try where no zz gives none.
Response respond_plane_stress(const YieldLaw& law, const Eigen::Vector3d& increment, const YieldState& before,
                              double size);

}  // namespace keyblock
