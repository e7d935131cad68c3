// Chooses the parts of a body around a crack tip over which integrals of stress intensity are taken.
// Theory: docs/theory/10-fracture.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "problem/manifold.hpp"

namespace keyblock {

enum class DomainKind {
  circle,          ///< between two radii around the tip
  element_levels,  ///< levels of elements around the one ahead of the crack, two if it runs along a side
  node_levels,     ///< levels of elements around the cover nearest to the tip
};

struct DomainChoice {
  DomainKind kind = DomainKind::circle;
  double inner = 0;  ///< radii of a circle [length]; 0 ≤ inner < outer
  double outer = 0;
  int levels = 0;  ///< at least 1
};

/// Returns the choice in words, for tables: "circle 0.1 to 0.3", "2 levels about the tip element".
std::string name_of(const DomainChoice& choice);

/// Weight q that is 1 at the tip and 0 at the edge of the domain. In a circle it is 1 - t³ (10 - 15 t + 6 t²), t = (r -
/// inner) / (outer - inner). In levels it is linear in each element between values of covers, and 1 except in the last
/// level. Keeps a reference to the manifold.
class CrackDomain {
 public:
  CrackDomain(const Manifold& manifold, const CrackTip& tip, const DomainChoice& choice);

  /// Returns the obstacle in a domain that is not one piece of rock with a straight crack in it; otherwise nothing.
  std::optional<std::string> obstacle() const;
  /// Returns the elements in which q is not 0, ascending.
  const std::vector<int>& elements() const { return elements_; }
  double weight(int element, Point x) const;
  Point gradient(int element, Point x) const;
  /// Returns the greatest distance from the tip at which q may differ from 0.
  double reach() const { return reach_; }

 private:
  void take_circle();
  void take_levels(std::vector<char> has_tip);
  std::vector<char> elements_at_tip() const;
  std::vector<char> elements_at_nearest_cover() const;

  const Manifold& manifold_;
  CrackTip tip_;
  DomainChoice choice_;
  std::vector<int> elements_;
  std::vector<char> is_one_;  // per cover: q is 1, in levels
  double reach_ = 0;
};

}  // namespace keyblock
