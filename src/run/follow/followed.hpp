// Writes the histories that a case requests in long form: points, blocks, contacts, joints and resultants.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/archive.hpp"
#include "problem/output_plan.hpp"
#include "problem/run_choices.hpp"
#include "run/follow/drawn_joints.hpp"
#include "run/follow/history_values.hpp"
#include "step/stepper.hpp"

namespace keyblock {

/// Names the energy balance where histories are read by name; no history has it.
inline constexpr std::string_view kBalanceName = "ledger";

/// Returns the name of a history in the table: its own, or that of its item.
std::string name_of(const HistoryPlan& plan);
/// Gives a name with its kind, such as "joint 2", to a history without a name whose item is named like an earlier one,
/// such as block 2.
std::vector<HistoryPlan> with_names_apart(std::vector<HistoryPlan> plans);

/// Throws InputError at the place of the plan if contacts are to be chosen by histories, and no history has contacts.
void require_choice(const OutputPlan& plan);

/// Returns lines `step,time,what,name,quantity,value,unit` of histories.csv.
std::string history_lines(const std::vector<FollowedValue>& values, int step, double time);

class Followed {
 public:
  Followed() = default;

  /// Takes histories whose points are measured points of the scene already (`with_followed_points`); one that is
  /// given twice counts once. Throws InputError if a block or joint does not exist, a point lies in no block, two
  /// items have one name, or one has that of the energy balance.
  Followed(const std::vector<HistoryPlan>& plans, const Scene& first, const DrawnJoints& joints, const Units& units);

  bool is_empty() const { return all_.empty(); }

  /// Returns the values of the current state; missing objects have none.
  std::vector<FollowedValue> values(const Stepper& stepper, const DrawnJoints& joints);

  /// Returns the approximate length of the lines of an instant in bytes.
  double bytes_of_row() const;

  /// Warns of pairs of blocks whose initial distance exceeds the size of the smaller one.
  Warnings of_distant_pairs() const;

  /// Warns of contacts, joints and lines without force in all rows, whose zeros might be taken for a result.
  Warnings of_nothing() const;

  /// Saves or restores the record of the rows so far.
  void describe(Archive& archive);

  /// Returns true if a contact belongs to a block, pair or joint of a history.
  bool follows(const ContactFrame& contact) const;

 private:
  struct One {
    HistoryPlan plan;
    std::string name;
    int point = -1;           ///< number of the measured point
    double apart = -1;        ///< initial distance of the two blocks; negative if unknown
    bool is_distant = false;  ///< farther apart than the size of the smaller one
    double nearest = -1;      ///< least gap so far; negative without any contact
    bool has_borne = false;   ///< something was closed, or crossed the line
    bool has_rows = false;
  };

  static void look_at_pair(One& one, const Model& model);

  std::vector<One> all_;
  FollowedUnits units_;
};

}  // namespace keyblock
