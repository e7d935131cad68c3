// Points of integration of rock on covers that may yield or has cracks: where they are, and what they remember.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <memory>
#include <set>
#include <span>
#include <vector>

#include "material/rock_point.hpp"
#include "model/continuum.hpp"
#include "result/plastic_state.hpp"
#include "system/sparse_system.hpp"

namespace keyblock {

/// The memories of all points of YieldPoints.
using YieldStates = std::vector<YieldState>;

/// Of elements whose material has a strength or cracks that close. With constant functions a point is a physical cover,
/// its gradient of deformation the mean over the cover's star weighted by λ_i, ∇N̄_a = ∫ λ_i ∇N_a / ∫ λ_i (Dohrmann et
/// al. 2000; Liu et al. 2009): elements with gradients of their own lock when they flow at constant volume. Small
/// pieces of triangles at the rim of a body are no part of that and have points of their own. With other functions
/// points are those of integration of the elements.
class YieldPoints {
 public:
  YieldPoints(const Continuum& continuum, const CoverBasis& basis);

  bool is_empty() const { return points_.empty(); }
  int point_count() const { return static_cast<int>(points_.size()); }
  /// Functions of points whose law has a tangent that is not symmetric.
  std::set<int> functions_of_whole_tangents() const;
  /// The functions of each point couple.
  void add_groups(FunctionGroups& groups) const;

  /// Memories before any displacement: the elastic strain of the initial stress.
  YieldStates start() const;

  /// Puts into `states` the memories that an element had as the element `was` of `before`, of the same triangle.
  void carry(int element, const YieldPoints& before, int was, const YieldStates& from, YieldStates& states) const;

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

  /// Of every point of a material √area, and an element it belongs to.
  struct Extent {
    double size = 0;
    int element = 0;
  };
  std::vector<Extent> extents(std::size_t material) const;

 protected:
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

  std::vector<Share> shares(int element, Point at_start) const;

  CoverBasis basis_;
  Plane plane_;
  bool averages_ = false;
  std::vector<std::shared_ptr<const YieldLaw>> laws_;  // one a material
  std::vector<Eigen::Matrix3d> elastic_;               // its modulus in the plane
  std::vector<YieldPoint> points_;
  std::vector<bool> has_own_;                         // of elements where averaged: points that no cover shares
  std::vector<std::vector<std::size_t>> of_element_;  // its points, in the order of its functions where averaged

 private:
  void add_averaged(const Continuum& continuum, const CoverBasis& basis);
  void add_own(const Continuum& continuum, const CoverBasis& basis, int element);
  void add_of_elements(const Continuum& continuum, const CoverBasis& basis);
};

}  // namespace keyblock
