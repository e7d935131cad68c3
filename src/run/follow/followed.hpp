// What is followed in time as a case asks for it: points, blocks, contacts, joints and resultants, in long form.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "problem/output_plan.hpp"
#include "problem/run_choices.hpp"
#include "run/follow/drawn_joints.hpp"
#include "step/stepper.hpp"

namespace keyblock {

/// How the table names units; letters where the case does not declare what they take.
struct FollowedUnits {
  explicit FollowedUnits(const Units& units = {});

  std::string length;
  std::string velocity;
  std::string rotation_rate;
  std::string force;
  std::string stress;
  std::string moment;
};

/// Throws InputError, at the place of the plan, for contacts chosen by histories of which none follows any.
void require_choice(const OutputPlan& plan);

class Followed {
 public:
  Followed() = default;

  /// Points are measured points of the scene already (`with_followed_points`). Throws InputError where a block or a
  /// joint is not there, or a point lies in no block.
  Followed(const std::vector<HistoryPlan>& plans, const Scene& first, const DrawnJoints& joints, const Units& units);

  bool is_empty() const { return all_.empty(); }

  /// Lines of the state at hand, `step,time,what,name,quantity,value,unit`: none of what is not there.
  std::string rows(const Stepper& stepper, const DrawnJoints& joints) const;

  /// Whether a contact is one of those of a block, a contact or a joint that is followed.
  bool follows(const ContactFrame& contact) const;

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
