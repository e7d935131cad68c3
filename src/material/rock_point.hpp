// A point of rock that may yield, or has cracks that close, in the plane of a run, and the stress it had at first.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <memory>

#include "material/yield_law.hpp"
#include "settings/settings.hpp"

namespace keyblock {

/// Strains are those of the plane since the start, (xx, yy, 2xy). What a point remembers is its plastic strain: the
/// elastic one is what the strain at hand leaves of it and of that of the initial stress, so that a body may be moved
/// without telling its points. Across the plane there is no strain, or no stress.
struct RockPoint {
  std::shared_ptr<const YieldLaw> law;
  Plane plane = Plane::strain;
  double area = 0;
  Eigen::Vector4d initial = Eigen::Vector4d::Zero();  ///< elastic strain of the initial stress: xx, yy, 2xy, zz

  /// The memory with the elastic strain that a strain leaves.
  YieldState as_at(const Eigen::Vector3d& strain, const YieldState& state) const;

  /// The law's answer at a strain, to a point that remembered `before`.
  Response respond(const Eigen::Vector3d& strain, const YieldState& before) const;

  /// (xx, yy, xy, zz), by elasticity alone.
  Eigen::Vector4d stress(const Eigen::Vector3d& strain, const YieldState& state) const;

  /// ∫ ½ εᵉ · D εᵉ, or W of cracks, over the area, less that of the initial stress.
  double stored(const Eigen::Vector3d& strain, const YieldState& state) const;

  /// Strain that intact elastic rock would not have: plastic, and by how much cracks have opened since the start.
  Eigen::Vector4d inelastic(const Eigen::Vector3d& strain, const YieldState& state) const;

  /// What the mean of the stresses at both ends of a way lacks (xx, yy, xy), so that its work on the change of elastic
  /// strain is that of the energy stored: (ΔW - σ̄ · Δεᵉ) n / (Δεᵉ · n), n = Δεᵉ with the shear of a tensor (Gonzalez
  /// 2000). None without cracks, or where all stay closed or open: the energy between is quadratic.
  Eigen::Vector3d missing_stress(const Eigen::Vector3d& strain0, const YieldState& before,
                                 const Eigen::Vector3d& strain1, const YieldState& after) const;
  /// Its derivative by the strain at the end, of a way on which nothing flows.
  Eigen::Matrix3d missing_stiffness(const Eigen::Vector3d& strain0, const YieldState& before,
                                    const Eigen::Vector3d& strain1, const YieldState& after) const;

  /// ∫ σ · Δεᵖ over the area, by the stress at the end.
  double plastic_work(const Eigen::Vector3d& strain, const YieldState& before, const YieldState& after) const;

 private:
  /// What the mean of the stresses of a way lacks: share times direction (xx, yy, 2xy as a tensor's, zz).
  struct Missing {
    CrackedResponse from, to;
    Eigen::Vector4d change = Eigen::Vector4d::Zero();  ///< Δεᵉ
    Eigen::Vector4d along = Eigen::Vector4d::Zero();   ///< n
    double work = 0;                                   ///< ΔW - σ̄ · Δεᵉ; 0: it lacks nothing
  };
  Missing missing(const Eigen::Vector3d& strain0, const YieldState& before, const Eigen::Vector3d& strain1,
                  const YieldState& after) const;

  /// Of a law with a closure.
  CrackedResponse cracked(const Eigen::Vector3d& strain, const YieldState& state) const;
};

}  // namespace keyblock
