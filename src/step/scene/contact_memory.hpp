// What contacts remember from step to step: forces, the stretch of their springs, and bonds that still hold.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "base/archive.hpp"
#include "contact/find/touch.hpp"

namespace keyblock {

struct ContactMemory {
  double normal = 0;      ///< force of the last step, pressure positive
  double tangential = 0;  ///< force of the last step
  double stretch = 0;     ///< of the tangential spring (penalty), by the way that its point has slipped while it stuck
  double normal_compliance = 0;  ///< of the spring, 0 of a multiplier
  double tangential_compliance = 0;
  double normal_at_end = 0;  ///< force of the spring at the end of the step: not `normal` where that acts at its middle
  /// Of the normal spring at the end of the step, by the gap: more than the force makes of it where the surfaces came
  /// to rest within the step. The next step pushes that out; no energy is held by it, nor by what a point slipped while
  /// it came to rest.
  double compression = 0;

  /// Held by the springs.
  double energy() const {
    return (normal_compliance * normal_at_end * normal_at_end + tangential_compliance * tangential * tangential) / 2;
  }
};

struct ClosedContact {
  Touch touch;
  ContactMemory memory;
};

/// Closed contacts by the name of their touch. Where the line of reference has passed from one of two facing edges to
/// the other, the touch at the same end of the stretch inherits: gap and slip keep their signs.
class ClosedContacts {
 public:
  ClosedContacts() = default;
  /// In any order. Of several on one touch the last one counts, of several on one facing that of the last touch by
  /// name.
  explicit ClosedContacts(std::vector<ClosedContact> contacts);

  /// None for a contact that was open.
  const ContactMemory* of(const Touch& touch) const;

  /// Those of the touches whose `vertex` is this one.
  std::span<const ClosedContact> at(VertexIndex vertex) const;

  std::size_t size() const { return by_touch_.size(); }
  const std::vector<ClosedContact>& all() const { return by_touch_; }

 private:
  friend void describe(Archive& archive, ClosedContacts& contacts, VertexIndex vertices);

  std::vector<ClosedContact> by_touch_;         ///< sorted
  std::vector<std::uint32_t> by_facing_;        ///< places above of those that have a facing, sorted by it
  std::vector<std::uint32_t> first_of_vertex_;  ///< in `by_touch_`, by vertex
  std::vector<std::uint32_t> first_of_facing_;  ///< in `by_facing_`, by the lower edge
};

/// Saves or restores; every index lies below `vertices`.
void describe(Archive& archive, ClosedContacts& contacts, VertexIndex vertices);

/// Bolts and held points.
struct ConstraintMemory {
  std::vector<double> bolt_forces;  ///< tension positive; 0 of a broken one
  std::vector<bool> broken;         ///< bolts
  Eigen::VectorXd point_forces;     ///< on the element, 2i in x and 2i + 1 in y
};

/// One end of the stretch along which two edges are bonded.
struct Bond {
  double gap = 0;     ///< at the start, kept as long as the bond pulls
  double length = 0;  ///< of the stretch that this end stands for
};

using Bonds = std::map<Facing, Bond>;

}  // namespace keyblock
