// Computes forces, tangents and energy of elastoplastic or cracked rock on covers at its points.
// Theory: docs/theory/09-plasticity.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <span>

#include "system/whole_system.hpp"
#include "terms/yield/yield_points.hpp"

namespace keyblock {

/// Forces, tangents, energy and stress of the rock of these points.
///
/// Strain is ½ ln C in the axes of the undeformed body, where it is additive (Miehe, Apel & Lambrecht 2002). S = Pᵀ T
/// with P = ∂(½ ln C)/∂E.
class CoverYield : public YieldPoints {
 public:
  using YieldPoints::YieldPoints;

  /// Static forces of bodies at d, for points with the memories `before`.
  struct Answer {
    Eigen::VectorXd force;  ///< ∫ ∇N · F S
    YieldStates after;
    /// False if a point's area is not positive, because ½ ln C does not distinguish it from its mirror image, or if its
    /// law found no stress. Force and memories are then invalid.
    bool exists = true;
  };
  Answer answer(const Eigen::VectorXd& d, const YieldStates& before) const;

  /// Adds ∂force/∂d to A; not symmetric if flow is not normal to the surface. `elastic_share` replaces that share of
  /// the law's tangent by the elastic stiffness, for stress in a corner of the surface, which no strain changes.
  void add_tangent(const Eigen::VectorXd& d, const YieldStates& before, double elastic_share,
                   WholeSystem& system) const;

  /// Step from d0, where points have the memories `before`, to d1. `theta` and `more` per element as in
  /// CoverElasticity.
  struct Way {
    const Eigen::VectorXd& d0;
    const YieldStates& before;
    const Eigen::VectorXd& d1;
    double theta = 1;
    std::span<const double> more = {};
  };
  /// Returns the force of a step, ∫ ∇N · S F_halfᵀ, whose work is (1 - θ) T0 · Δε + θ T1 · Δε. T0 is the stress at d0,
  /// T1 that of the law at d1 (`log_step_stress`); `RockPoint::missing_stress` is added for cracks that close in
  /// between. The work is the change of stored energy, plus the plastic work, plus a rest that vanishes with the step.
  /// Not finite if there is no stress (`Answer::exists`).
  Eigen::VectorXd force_of_step(const Way& way) const;
  /// Adds ∂force_of_step/∂d1 to A, made symmetric, as CoverElasticity::add_tangent does. If `whole` is given, points
  /// whose law has an unsymmetric tangent add their exact derivative to it instead.
  void add_tangent_of_step(const Way& way, SparseSystem& system, WholeSystem* whole = nullptr) const;

  /// Returns the work of the stress of damping, `more` D Δε, over a step.
  double damping_work(const Eigen::VectorXd& d0, const Eigen::VectorXd& d1, std::span<const double> more) const;

  /// Returns the memories at d of points that had those of `before`; returns `before` if there is no response at d.
  YieldStates after(const Eigen::VectorXd& d, const YieldStates& before) const;
  /// Returns ∫ ½ εᵉ · D εᵉ, or W of cracks, minus that of the initial stress.
  double stored(const Eigen::VectorXd& d, const YieldStates& states) const;
  /// Returns ∫ T1 · Δεᵖ, with the stress at the end; never negative for associated flow.
  double plastic_work(const Eigen::VectorXd& d, const YieldStates& before, const YieldStates& after) const;

  /// Returns the Cauchy stress of an element at X: the mean of the covers' points, weighted by λ, or else that of the
  /// element's points.
  Stress stress(const Eigen::VectorXd& d, const YieldStates& states, int element, Point at_start) const;

 private:
  Eigen::Matrix2d displacement_gradient(const YieldPoint& point, const Eigen::VectorXd& d) const;
  Eigen::Vector3d mean_stress(const YieldPoint& point, const Way& way, const Eigen::Vector3d& log0,
                              const Eigen::Vector3d& log1, const YieldState& before, const Response& end) const;
  double weight_of(const YieldPoint& point, const Way& way) const;
  void add_force(const YieldPoint& point, const Eigen::Matrix2d& f, const Eigen::Vector3d& second,
                 Eigen::VectorXd& force) const;
  /// Returns the tangent of a force with F and S whose stiffness is ∂S/∂E, with E taken at F `of_strain`. The change of
  /// F is `share` of that of the deformation.
  static Eigen::MatrixXd tangent_at(const YieldPoint& point, const Eigen::Matrix2d& f, const Eigen::Matrix2d& of_strain,
                                    const Eigen::Matrix3d& stiffness, const Eigen::Vector3d& second, double share = 1);
};

}  // namespace keyblock
