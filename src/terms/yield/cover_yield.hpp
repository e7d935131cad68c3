// Rock on covers that may yield or has cracks: forces, tangents and energy of its points.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <span>

#include "system/whole_system.hpp"
#include "terms/yield/yield_points.hpp"

namespace keyblock {

/// Forces, tangents, energy and stress of the rock of these points.
///
/// Strain is ½ ln C in the axes of the undeformed body, additive there (Miehe, Apel & Lambrecht 2002); S = Pᵀ T with
/// P = ∂(½ ln C)/∂E.
class CoverYield : public YieldPoints {
 public:
  using YieldPoints::YieldPoints;

  /// Bodies at rest at d, when all points had the memories `before`.
  struct Answer {
    Eigen::VectorXd force;  ///< ∫ ∇N · F S
    YieldStates after;
    /// False where a point's area is none or less, for ½ ln C does not tell it from its mirror image, or where its law
    /// found no stress: force and memories are then of no use.
    bool exists = true;
  };
  Answer answer(const Eigen::VectorXd& d, const YieldStates& before) const;

  /// A += ∂force/∂d; not symmetric where flow is not normal to the surface. `elastic_share`: of the elastic stiffness
  /// in place of as much of the law's tangent, for stress in a corner of the surface, which no strain changes.
  void add_tangent(const Eigen::VectorXd& d, const YieldStates& before, double elastic_share,
                   WholeSystem& system) const;

  /// A step from d0, where points have the memories `before`, to d1. `theta` as CoverElasticity has it, and `more` of
  /// every element.
  struct Way {
    const Eigen::VectorXd& d0;
    const YieldStates& before;
    const Eigen::VectorXd& d1;
    double theta = 1;
    std::span<const double> more = {};
  };
  /// The force of a step, ∫ ∇N · S F_halfᵀ, whose work is (1 - θ) T0 · Δε + θ T1 · Δε, T0 the stress at d0, T1 that of
  /// the law at d1 (`log_step_stress`), with what cracks that close in between lack (`RockPoint::missing_stress`): the
  /// change of the energy stored, the plastic work, and a rest that vanishes with the step. Not finite where there is
  /// none (`Answer::exists`).
  Eigen::VectorXd force_of_step(const Way& way) const;
  /// A += ∂force_of_step/∂d1, made symmetric, as CoverElasticity::add_tangent; `whole`, if there is one, takes the
  /// exact derivative of points whose law has a tangent that is not symmetric in place of that.
  void add_tangent_of_step(const Way& way, SparseSystem& system, WholeSystem* whole = nullptr) const;

  /// Of the stress of damping, `more` D Δε, over a step.
  double damping_work(const Eigen::VectorXd& d0, const Eigen::VectorXd& d1, std::span<const double> more) const;

  /// Memories at d, of points that had those of `before`; these where there is no answer at d.
  YieldStates after(const Eigen::VectorXd& d, const YieldStates& before) const;
  /// ∫ ½ εᵉ · D εᵉ, or W of cracks, less that of the initial stress.
  double stored(const Eigen::VectorXd& d, const YieldStates& states) const;
  /// ∫ T1 · Δεᵖ, by the stress at the end, which for associated flow is never negative.
  double plastic_work(const Eigen::VectorXd& d, const YieldStates& before, const YieldStates& after) const;

  /// Cauchy stress of an element at X: the mean of the covers' points, weighted by λ; else of the element's points.
  Stress stress(const Eigen::VectorXd& d, const YieldStates& states, int element, Point at_start) const;

 private:
  Eigen::Matrix2d displacement_gradient(const YieldPoint& point, const Eigen::VectorXd& d) const;
  Eigen::Vector3d mean_stress(const YieldPoint& point, const Way& way, const Eigen::Vector3d& log0,
                              const Eigen::Vector3d& log1, const YieldState& before, const Response& end) const;
  double weight_of(const YieldPoint& point, const Way& way) const;
  void add_force(const YieldPoint& point, const Eigen::Matrix2d& f, const Eigen::Vector3d& second,
                 Eigen::VectorXd& force) const;
  /// Of a force with F and S that moves with the stiffness ∂S/∂E, where E does so as at F `of_strain`; the change of F
  /// is `share` of that of the deformation.
  static Eigen::MatrixXd tangent_at(const YieldPoint& point, const Eigen::Matrix2d& f, const Eigen::Matrix2d& of_strain,
                                    const Eigen::Matrix3d& stiffness, const Eigen::Vector3d& second, double share = 1);
};

}  // namespace keyblock
