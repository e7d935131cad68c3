// Holds the integration points of elastoplastic or cracked rock on covers, and their memories.
// Theory: docs/theory/09-plasticity.md.
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

/// Memories of all points of YieldPoints.
using YieldStates = std::vector<YieldState>;

/// Points of elements whose material has a strength or cracks that close.
///
/// With constant functions a point is a physical cover. Its deformation gradient is the mean over the cover's star
/// weighted by λ_i, ∇N̄_a = ∫ λ_i ∇N_a / ∫ λ_i (Dohrmann et al. 2000; Liu et al. 2009). Elements with gradients of
/// their own lock in flow at constant volume. Small pieces of triangles at the edge of a body take no part in that and
/// have points of their own. With other functions points are the integration points of the elements.
class YieldPoints {
 public:
  YieldPoints(const Continuum& continuum, const CoverBasis& basis);

  bool is_empty() const { return points_.empty(); }
  /// Returns the functions of points whose law has an unsymmetric tangent.
  std::set<int> functions_of_whole_tangents() const;
  /// Adds the functions that each point couples.
  void add_groups(FunctionGroups& groups) const;

  /// Returns the memories before any displacement: the elastic strain of the initial stress.
  YieldStates start() const;

  /// Copies to `states` the memories that an element had as the element `was` of `before`, which has the same triangle.
  void carry(int element, const YieldPoints& before, int was, const YieldStates& from, YieldStates& states) const;

  /// Memory of rock at a point of an element, with its `area`.
  struct Remembered {
    Point at;
    double area = 0;
    YieldState memory;
  };
  /// Returns, for every point, the means of plastic strain and κ over remembered points, weighted by the point's
  /// function, and the region of most of them (`MeanMemory`). The memories may come from any earlier mesh.
  YieldStates gathered(std::span<const std::vector<Remembered>> of_elements) const;
  /// Returns the mean at X, weighted as `stress` is (`MeanMemory`); an empty memory if the element cannot yield.
  YieldState memory(const YieldStates& states, int element, Point at_start) const;

  /// Returns the memory in the axes of the plane, for an element rotated by `angle` [rad].
  PlasticState plastic_state(const YieldStates& states, int element, Point at_start, double angle) const;
  /// Adds the areas of all points that may yield.
  void add_totals(const YieldStates& states, PlasticTotals& totals) const;

  /// √area of a point of a material, and an element of the point.
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
    int element = 0;      // an element of its body
  };
  /// Point of an element, with its weight in the average at X.
  struct Share {
    std::size_t point = 0;
    double weight = 0;
  };

  std::vector<Share> shares(int element, Point at_start) const;

  CoverBasis basis_;
  Plane plane_;
  bool averages_ = false;
  std::vector<std::shared_ptr<const YieldLaw>> laws_;  // one per material
  std::vector<Eigen::Matrix3d> elastic_;               // its modulus in the plane
  std::vector<YieldPoint> points_;
  std::vector<bool> has_own_;                         // per element if averaged: it has points that no cover shares
  std::vector<std::vector<std::size_t>> of_element_;  // its points, in the order of its functions if averaged

 private:
  void add_averaged(const Continuum& continuum, const CoverBasis& basis);
  void add_own(const Continuum& continuum, const CoverBasis& basis, int element);
  void add_of_elements(const Continuum& continuum, const CoverBasis& basis);
};

}  // namespace keyblock
