// What is followed in time as a case asks for it: points, blocks, contacts, joints and resultants, in long form.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "base/archive.hpp"
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
  std::string rows(const Stepper& stepper, const DrawnJoints& joints);

  /// About the length of `rows`, bytes.
  double bytes_of_row() const;

  /// Of pairs that lie farther apart before any load than the smaller of the two is large.
  Warnings of_distant_pairs() const;

  /// Of contacts, joints and lines that bore nothing in any of the rows: zeros that might pass for an answer.
  Warnings of_nothing() const;

  /// What the rows so far have shown.
  void describe(Archive& archive);

  /// Whether a contact is one of those of a block, a contact or a joint that is followed.
  bool follows(const ContactFrame& contact) const;

 private:
  struct One {
    HistoryPlan plan;
    std::string name;
    int point = -1;           ///< number of the measured point
    double apart = -1;        ///< least distance of the two blocks before any load; below 0 where it is not known
    bool is_distant = false;  ///< farther than the smaller of them is large
    double nearest = -1;      ///< least gap that was seen; below 0 where no contact was
    bool has_borne = false;   ///< something was closed, or crossed the line
    bool has_rows = false;
  };

  static void look_at_pair(One& one, const Model& model);

  std::vector<One> all_;
  FollowedUnits units_;
};

}  // namespace keyblock
