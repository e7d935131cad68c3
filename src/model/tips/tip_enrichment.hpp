// Chooses the covers near crack tips that carry near-tip functions, the combinations of these functions, and the covers
// with gradients of their own.
// Theory: docs/theory/10-fracture.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <map>
#include <vector>

#include "model/tips/tip_shape.hpp"
#include "problem/cover_plan.hpp"
#include "problem/manifold.hpp"

namespace keyblock {

/// Cover that carries the functions of a tip.
struct TipCover {
  int cover = 0;
  int tip = 0;              ///< in the manifold's list
  Eigen::Matrix4Xd mix;     ///< columns: combinations that are orthonormal in ∫ ∇·∇ over the cover
  int first_function = -1;  ///< number of the first function
};

/// Enriches covers near tips. Covers whose node is nearer to a tip than R carry its functions. Those nearer than R +
/// 1.5 sides have gradients of their own instead of derived ones. θ continues from element to element across shared
/// sides, from straight ahead of the tip, so it shows on which side of a kinked crack an element lies. A cover is left
/// out if elements around it are not connected with the tip near it. It is left out, too, if θ jumps between two of
/// them, as behind the other end of a short crack.
class TipEnrichment {
 public:
  /// `plan.radius` 0: R is three times the longest side at the tip.
  TipEnrichment(const Manifold& manifold, const TipFunctionPlan& plan);

  bool has_own_gradient(int cover) const { return own_gradient_[static_cast<std::size_t>(cover)] != 0; }
  void give_own_gradient(int cover) { own_gradient_[static_cast<std::size_t>(cover)] = 1; }
  bool carries_functions(int cover) const { return !of_cover_[static_cast<std::size_t>(cover)].empty(); }
  /// Numbers the functions from `next` on; returns the first free number.
  int number_functions(int next);
  /// Returns the shape of an element without its first place, or an empty one if it has no functions. Appends the
  /// numbers of its functions to `numbers`.
  TipShape shape(int element, std::vector<int>& numbers) const;

 private:
  using Middles = std::map<int, double>;  // θ in the middle of elements

  void add_tip(int tip, const TipFunctionPlan& plan);
  double side_at(const std::vector<int>& at_tip) const;
  std::vector<int> elements_at(Point tip) const;
  double angle_of(int element, const TipAxes& axes) const;
  bool holds_inside(int element, Point tip) const;
  int seed(const std::vector<int>& at_tip, const TipAxes& axes, double side) const;
  /// Returns θ of the elements that can be reached from the seed through near elements.
  Middles middles(int seed, const TipAxes& axes, const std::vector<char>& is_near) const;
  template <class Visit>
  void visit_neighbours(int element, Visit visit) const;
  /// Returns, per cover, true if θ differs between two of its elements.
  std::vector<char> torn(const Middles& middles, const TipAxes& axes) const;
  Eigen::Matrix4Xd orthonormal(int cover, const TipAxes& axes, const Middles& middles) const;

  const Manifold& manifold_;
  std::vector<TipAxes> axes_;
  std::vector<Middles> middles_;  // per tip
  std::vector<char> own_gradient_;
  std::vector<TipCover> tip_covers_;
  std::vector<std::vector<std::size_t>> of_cover_;  // in tip_covers_
};

}  // namespace keyblock
