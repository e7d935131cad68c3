// Keeps the histories of a run in memory.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <keyblock/keyblock.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "api/plan.hpp"
#include "run/follow/drawn_joints.hpp"
#include "run/follow/followed.hpp"
#include "step/stepper.hpp"

namespace keyblock::api {

/// Histories of the plan, with a row per step as tables have them.
class KeptHistories {
 public:
  /// Keeps a reference to `joints`.
  KeptHistories(const PlannedCase& planned, const DrawnJoints& joints);

  /// Adds the state at the start, or after a step.
  void add(const Stepper& stepper);

  std::vector<std::string> names() const;
  std::vector<std::pair<std::string, std::string>> quantities(std::string_view name) const;
  /// Returns times and values in turn; nan at times at which the quantity is unknown.
  Column<double> values(std::string_view name, std::string_view quantity) const;

 private:
  struct Quantity {
    std::string name;
    std::string unit;
    std::vector<double> values;  ///< one per time; nan, or none at the end, where it is unknown
  };
  struct History {
    std::string name;
    std::vector<Quantity> quantities;
  };

  const History& at(std::string_view name) const;

  const DrawnJoints& joints_;
  Followed followed_;
  int last_;
  std::vector<double> times_;
  std::vector<History> all_;
};

}  // namespace keyblock::api
