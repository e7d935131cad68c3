// The parts of a body about a crack tip that integrals of its stress intensity are taken over.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "problem/manifold.hpp"

namespace keyblock {

enum class DomainKind {
  circle,          ///< between two radii about the tip
  element_levels,  ///< levels of elements around the one that the crack would go on in, two where it runs along a side
  node_levels,     ///< levels of elements around the cover nearest to the tip
};

struct DomainChoice {
  DomainKind kind = DomainKind::circle;
  double inner = 0;  ///< radii of a circle, length; 0 ≤ inner < outer
  double outer = 0;
  int levels = 0;  ///< at least 1
};

/// In words, for tables: "circle 0.1 to 0.3", "2 levels about the tip element".
std::string name_of(const DomainChoice& choice);

/// A weight q that is 1 at the tip and 0 at the rim: of a circle 1 - t³ (10 - 15 t + 6 t²), t = (r - inner) / (outer -
/// inner); of levels linear in each element between values of covers, 1 but for the last level. Views the manifold.
class CrackDomain {
 public:
  CrackDomain(const Manifold& manifold, const CrackTip& tip, const DomainChoice& choice);

  /// Where it is not of one piece of rock with a straight crack in it: what is in the way; else nothing.
  std::optional<std::string> obstacle() const;
  /// Elements in which q is not 0, ascending.
  const std::vector<int>& elements() const { return elements_; }
  double weight(int element, Point x) const;
  Point gradient(int element, Point x) const;
  /// The farthest point from the tip at which q may differ from 0.
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
  std::vector<char> is_one_;  // q of each cover, of levels
  double reach_ = 0;
};

}  // namespace keyblock
