// Rock on covers that may yield or has cracks: points of integration, their memories, forces and tangents.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "material/rock_point.hpp"
#include "model/continuum.hpp"
#include "result/plastic_state.hpp"
#include "system/whole_system.hpp"

namespace keyblock {

/// The memories of all points of a CoverYield.
using YieldStates = std::vector<YieldState>;

/// Elements whose material has a strength or cracks that close. With constant functions a point is a physical cover,
/// its gradient of deformation the mean over the cover's star weighted by λ_i, ∇N̄_a = ∫ λ_i ∇N_a / ∫ λ_i (Dohrmann et
/// al. 2000; Liu et al. 2009): elements with gradients of their own lock when they flow at constant volume. With other
/// functions points are those of integration of the elements.
///
/// Strain is ½ ln C in the axes of the undeformed body, additive there (Miehe, Apel & Lambrecht 2002); S = Pᵀ T with
/// P = ∂(½ ln C)/∂E.
class CoverYield {
 public:
  CoverYield(const Continuum& continuum, const CoverBasis& basis);

  bool is_empty() const { return points_.empty(); }
  int point_count() const { return static_cast<int>(points_.size()); }
  /// The functions of each point couple.
  void add_groups(FunctionGroups& groups) const;

  /// Memories before any displacement: the elastic strain of the initial stress.
  YieldStates start() const;

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
  /// A += ∂force_of_step/∂d1, made symmetric, as CoverElasticity::add_tangent.
  void add_tangent_of_step(const Way& way, SparseSystem& system) const;

  /// Of the stress of damping, `more` D Δε, over a step.
  double damping_work(const Eigen::VectorXd& d0, const Eigen::VectorXd& d1, std::span<const double> more) const;

  /// Memories at d, of points that had those of `before`; these where there is no answer at d.
  YieldStates after(const Eigen::VectorXd& d, const YieldStates& before) const;
  /// ∫ ½ εᵉ · D εᵉ, or W of cracks, less that of the initial stress.
  double stored(const Eigen::VectorXd& d, const YieldStates& states) const;
  /// ∫ T1 · Δεᵖ, by the stress at the end, which for associated flow is never negative.
  double plastic_work(const Eigen::VectorXd& d, const YieldStates& before, const YieldStates& after) const;

  /// Puts into `states` the memories that an element had as the element `was` of `before`, of the same triangle.
  void carry(int element, const CoverYield& before, int was, const YieldStates& from, YieldStates& states) const;

  /// What rock remembered at a point of an element, of which there is `area`.
  struct Remembered {
    Point at;
    double area = 0;
    YieldState memory;
  };
  /// The means of plastic strain and κ over points of every element, as a point's function weighs them, and the region
  /// of most of them (`MeanMemory`): of the mesh before, whatever it was.
  YieldStates gathered(std::span<const std::vector<Remembered>> of_elements) const;
  /// The mean at X, as `stress` has it (`MeanMemory`); nothing of an element that cannot yield.
  YieldState memory(const YieldStates& states, int element, Point at_start) const;

  /// The same in the axes of the plane, for an element turned by `angle` (rad).
  PlasticState plastic_state(const YieldStates& states, int element, Point at_start, double angle) const;
  /// The areas of all points that may yield.
  void add_totals(const YieldStates& states, PlasticTotals& totals) const;

  /// Cauchy stress of an element at X: the mean of the covers' points, weighted by λ; else of the element's points.
  Stress stress(const Eigen::VectorXd& d, const YieldStates& states, int element, Point at_start) const;
  /// √area of the largest point of a material; 0: it has none.
  double greatest_size(std::size_t material) const;

 private:
  struct YieldPoint {
    std::vector<int> functions;
    Eigen::Matrix2Xd gradients;  // of the functions
    RockPoint rock;
    std::size_t law = 0;  // number of the material
    int element = 0;      // one of its body
  };
  /// A point of an element, and what of it goes into its mean at X.
  struct Share {
    std::size_t point = 0;
    double weight = 0;
  };

  void add_averaged(const Continuum& continuum, const CoverBasis& basis);
  void add_of_elements(const Continuum& continuum, const CoverBasis& basis);
  std::vector<Share> shares(int element, Point at_start) const;
  Eigen::Matrix2d displacement_gradient(const YieldPoint& point, const Eigen::VectorXd& d) const;
  Eigen::Vector3d mean_stress(const YieldPoint& point, const Way& way, const Eigen::Vector3d& log0,
                              const Eigen::Vector3d& log1, const YieldState& before, const Response& end) const;
  double weight_of(const YieldPoint& point, const Way& way) const;
  void add_force(const YieldPoint& point, const Eigen::Matrix2d& f, const Eigen::Vector3d& second,
                 Eigen::VectorXd& force) const;
  /// Of a point with the stress S and the stiffness ∂S/∂E at F.
  static Eigen::MatrixXd tangent_at(const YieldPoint& point, const Eigen::Matrix2d& f, const Eigen::Matrix3d& stiffness,
                                    const Eigen::Vector3d& second);

  CoverBasis basis_;
  Plane plane_;
  bool averages_ = false;
  std::vector<std::shared_ptr<const YieldLaw>> laws_;  // one a material
  std::vector<Eigen::Matrix3d> elastic_;               // its modulus in the plane
  std::vector<YieldPoint> points_;
  std::vector<std::vector<std::size_t>> of_element_;  // its points, in the order of its functions where averaged
};

}  // namespace keyblock
