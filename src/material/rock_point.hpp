// Evaluates a point of elastoplastic or cracked rock in the plane of a run, from its initial stress on.
// Theory: docs/theory/09-plasticity.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <memory>

#include "material/yield_law.hpp"
#include "settings/settings.hpp"

namespace keyblock {

/// Strains are those of the plane since the start, (xx, yy, 2xy). A point stores its plastic strain. Its elastic strain
/// is the present strain plus that of the initial stress, minus the plastic one. So a body may move without an update
/// of its points. There is no strain or no stress across the plane.
struct RockPoint {
  std::shared_ptr<const YieldLaw> law;
  Plane plane = Plane::strain;
  double area = 0;
  Eigen::Vector4d initial = Eigen::Vector4d::Zero();  ///< elastic strain of the initial stress: xx, yy, 2xy, zz

  /// Returns the memory with the elastic strain at this strain.
  YieldState as_at(const Eigen::Vector3d& strain, const YieldState& state) const;

  /// Returns the law's response at a strain, for a point with the memory `before`.
  Response respond(const Eigen::Vector3d& strain, const YieldState& before) const;

  /// Returns the elastic stress (xx, yy, xy, zz).
  Eigen::Vector4d stress(const Eigen::Vector3d& strain, const YieldState& state) const;

  /// Returns ∫ ½ εᵉ · D εᵉ, or W of cracks, over the area, minus that of the initial stress.
  double stored(const Eigen::Vector3d& strain, const YieldState& state) const;

  /// Returns the strain that intact elastic rock would not have: plastic strain and the opening of cracks since the
  /// start.
  Eigen::Vector4d inelastic(const Eigen::Vector3d& strain, const YieldState& state) const;

  /// Returns the correction (xx, yy, xy) to the mean of the stresses at both ends of a path. With it, the work on the
  /// change of elastic strain is the change of stored energy: (ΔW - σ̄ · Δεᵉ) n / (Δεᵉ · n). n is Δεᵉ with tensor shear
  /// (Gonzalez 2000). It is zero without cracks, or if all stay closed or open, because the energy is then quadratic.
  Eigen::Vector3d missing_stress(const Eigen::Vector3d& strain0, const YieldState& before,
                                 const Eigen::Vector3d& strain1, const YieldState& after) const;
  /// Returns its derivative by the strain at the end, on a path without plastic flow.
  Eigen::Matrix3d missing_stiffness(const Eigen::Vector3d& strain0, const YieldState& before,
                                    const Eigen::Vector3d& strain1, const YieldState& after) const;

  /// Returns ∫ σ · Δεᵖ over the area, with the stress at the end.
  double plastic_work(const Eigen::Vector3d& strain, const YieldState& before, const YieldState& after) const;

 private:
  /// Correction to the mean of the stresses of a path: share times direction (xx, yy, 2xy as a tensor's, zz).
  struct Missing {
    CrackedResponse from, to;
    Eigen::Vector4d change = Eigen::Vector4d::Zero();  ///< Δεᵉ
    Eigen::Vector4d along = Eigen::Vector4d::Zero();   ///< n
    double work = 0;                                   ///< ΔW - σ̄ · Δεᵉ; 0: no correction
  };
  Missing missing(const Eigen::Vector3d& strain0, const YieldState& before, const Eigen::Vector3d& strain1,
                  const YieldState& after) const;

  /// Returns the response of a law with a closure.
  CrackedResponse cracked(const Eigen::Vector3d& strain, const YieldState& state) const;
};

}  // namespace keyblock
