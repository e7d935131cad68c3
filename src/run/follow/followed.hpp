// What is followed in time as a case asks for it: points, blocks, contacts, joints and resultants, in long form.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "problem/output_plan.hpp"
#include "run/follow/drawn_joints.hpp"
#include "step/stepper.hpp"

namespace keyblock {

/// How the table names units; letters where the case declares none.
struct FollowedUnits {
  std::string length = "L";
  std::string time = "T";
  std::string force = "F";
  std::string stress = "F/L²";
  std::string moment = "F L";
};

class Followed {
 public:
  Followed() = default;

  /// Points are measured points of the scene already (`with_followed_points`). Throws InputError where a block or a joint
  /// is not there, or a point lies in no block.
  Followed(const std::vector<HistoryPlan>& plans, const Scene& first, const DrawnJoints& joints, FollowedUnits units);

  bool is_empty() const { return all_.empty(); }

  static std::string header() { return "step,time,what,name,quantity,value,unit\n"; }

  /// Lines of the state at hand: none of what is not there.
  std::string rows(const Stepper& stepper, const DrawnJoints& joints) const;

  /// Whether a contact is one of those of a block, a contact or a joint that is followed; and whether there are any.
  bool follows(const ContactFrame& contact) const;
  bool follows_contacts() const;

 private:
  struct One {
    HistoryPlan plan;
    std::string name;
    int point = -1;  ///< number of the measured point
  };

  std::vector<One> all_;
  FollowedUnits units_;
};

}  // namespace keyblock
