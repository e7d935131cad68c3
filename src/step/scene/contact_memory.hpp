// Holds the data that contacts keep from step to step: forces, stretch of springs, and unbroken bonds.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "base/archive.hpp"
#include "contact/find/touch.hpp"

namespace keyblock {

struct ContactMemory {
  double normal = 0;             ///< force of the last step, pressure positive
  double tangential = 0;         ///< force of the last step
  double stretch = 0;            ///< of the tangential spring (penalty), from the slip of its point while it stuck
  double normal_compliance = 0;  ///< of the spring; 0 of a multiplier
  double tangential_compliance = 0;
  double normal_at_end = 0;  ///< spring force at the end of the step; differs from `normal` if that acts at mid-step
  /// Compression of the normal spring at the end of the step, by the gap. It exceeds that of the force if the surfaces
  /// came to rest within the step. Neither the excess nor the slip during that time stores energy.
  double compression = 0;
  /// Time in which later steps remove the excess, at least: the step in which it arose. In a shorter part of a step it
  /// would throw the bodies apart.
  double removed_in = 0;

  /// Returns the part of a gap at the start of a step of `dt` that the step counts (5.7a). Of an overlap these are the
  /// compression by the force and the part of the excess to be removed. An excess up to that compression counts whole:
  /// springs that vibrate have it in every step.
  double counted(double gap, double dt) const {
    if (dt >= removed_in) return gap;
    const double by_force = normal * normal_compliance;
    return std::max(gap, -by_force - std::max(by_force, (compression - by_force) * (dt / removed_in)));
  }

  /// Returns the energy of the springs.
  double energy() const {
    return (normal_compliance * normal_at_end * normal_at_end + tangential_compliance * tangential * tangential) / 2;
  }
};

struct ClosedContact {
  Touch touch;
  ContactMemory memory;
};

/// Closed contacts by name. The reference line may pass from one of two facing edges to the other. The contact at the
/// same end of the stretch then inherits the memory: gap and slip keep their signs.
class ClosedContacts {
 public:
  ClosedContacts() = default;
  /// Takes contacts in any order. The last entry of a contact counts. For one facing, the contact that comes last by
  /// name counts.
  explicit ClosedContacts(std::vector<ClosedContact> contacts);

  /// Returns null for a contact that was open.
  const ContactMemory* of(const Touch& touch) const;

  /// Returns the contacts whose `vertex` is this one.
  std::span<const ClosedContact> at(VertexIndex vertex) const;

  std::size_t size() const { return by_touch_.size(); }
  const std::vector<ClosedContact>& all() const { return by_touch_; }

 private:
  friend void describe(Archive& archive, ClosedContacts& contacts, VertexIndex vertices);

  std::vector<ClosedContact> by_touch_;         ///< sorted
  std::vector<std::uint32_t> by_facing_;        ///< places in `by_touch_` of contacts with a facing, sorted by it
  std::vector<std::uint32_t> first_of_vertex_;  ///< in `by_touch_`, by vertex
  std::vector<std::uint32_t> first_of_facing_;  ///< in `by_facing_`, by the lower edge
};

/// Saves or restores the contacts; every index is below `vertices`.
void describe(Archive& archive, ClosedContacts& contacts, VertexIndex vertices);

/// Memory of bolts and fixed points.
struct ConstraintMemory {
  std::vector<double> bolt_forces;  ///< tension positive; 0 for a broken bolt
  std::vector<bool> broken;         ///< per bolt
  Eigen::VectorXd point_forces;     ///< on the element, 2i in x and 2i + 1 in y
};

/// Returns bolts at their pretension and points without force.
ConstraintMemory constraint_start(const std::vector<Bolt>& bolts, std::size_t points);

/// One end of the stretch along which two edges are bonded.
struct Bond {
  double gap = 0;     ///< initial gap, kept as long as the bond pulls
  double length = 0;  ///< length of the stretch assigned to this end
};

using Bonds = std::map<Facing, Bond>;

}  // namespace keyblock
