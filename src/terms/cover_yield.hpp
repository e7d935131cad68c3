// Rock on covers that may yield: points of integration with a memory, their forces and tangents under large strain.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "material/yield_law.hpp"
#include "model/continuum.hpp"
#include "system/whole_system.hpp"

namespace keyblock {

/// The memories of all points of a CoverYield.
using YieldStates = std::vector<YieldState>;

/// Elements whose material has a strength. With constant functions a point is a physical cover, its gradient of
/// deformation the mean over the cover's star weighted by λ_i, ∇N̄_a = ∫ λ_i ∇N_a / ∫ λ_i (Dohrmann et al. 2000;
/// Liu et al. 2009): elements with gradients of their own lock when they flow at constant volume. With other functions
/// points are those of integration of the elements.
///
/// Strain is ½ ln C in the axes of the undeformed body, additive there (Miehe, Apel & Lambrecht 2002), and the law's
/// increment that of the step; S = Pᵀ T with P = ∂(½ ln C)/∂E.
class CoverYield {
 public:
  CoverYield(const Continuum& continuum, const CoverBasis& basis);

  bool is_empty() const { return points_.empty(); }
  int point_count() const { return static_cast<int>(points_.size()); }
  /// The functions of each point couple.
  void add_groups(FunctionGroups& groups) const;

  /// Memories before any displacement: the elastic strain of the initial stress.
  YieldStates start() const;

  /// Bodies at d1, when all points had the memories `before` at d0.
  struct Answer {
    Eigen::VectorXd force;  ///< ∫ ∇N · F S
    YieldStates after;
    bool is_turned_over = false;  ///< a point's area is none or less: ½ ln C does not tell it from its mirror image
  };
  Answer answer(const Eigen::VectorXd& d0, const YieldStates& before, const Eigen::VectorXd& d1) const;

  /// A += ∂force/∂d1; not symmetric where flow is not normal to the surface. `elastic_share`: of the elastic stiffness
  /// in place of as much of the law's tangent, for stress in a corner of the surface, which no strain changes.
  void add_tangent(const Eigen::VectorXd& d0, const YieldStates& before, const Eigen::VectorXd& d1,
                   double elastic_share, WholeSystem& system) const;

  /// Puts into `states` the memories that an element had as the element `was` of `before`, of the same triangle.
  void carry(int element, const CoverYield& before, int was, const YieldStates& from, YieldStates& states) const;

  /// Cauchy stress of an element at X: the mean of the covers' points, weighted by λ; else of the element's points.
  Stress stress(const Eigen::VectorXd& d, const YieldStates& states, int element, Point at_start) const;
  /// √area of the largest point of a material; 0: it has none.
  double greatest_size(std::size_t material) const;

 private:
  struct YieldPoint {
    std::vector<int> functions;
    Eigen::Matrix2Xd gradients;  // of the functions
    double area = 0;
    std::size_t law = 0;      // in laws_
    Eigen::Vector4d initial;  // stress xx, yy, xy, zz
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
  Response respond_at(const YieldPoint& point, const Eigen::Vector3d& log_change, const YieldState& before) const;
  Eigen::MatrixXd tangent_at(const YieldPoint& point, const Eigen::Matrix2d& h, const Response& response) const;

  CoverBasis basis_;
  Plane plane_;
  bool averages_ = false;
  std::vector<YieldLaw> laws_;            // one a material
  std::vector<Eigen::Matrix3d> elastic_;  // its modulus in the plane
  std::vector<YieldPoint> points_;
  std::vector<std::vector<std::size_t>> of_element_;  // its points, in the order of its functions where averaged
};

}  // namespace keyblock
