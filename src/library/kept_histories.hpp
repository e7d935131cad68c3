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
  explicit KeptHistories(const PlannedCase& planned);

  /// Adds the state at the start, or after a step.
  void add(const Stepper& stepper);

  std::vector<std::string> names() const;
  bool has(std::string_view name) const;
  std::vector<std::pair<std::string, std::string>> quantities(std::string_view name) const;
  Column<double> values(std::string_view name, std::string_view quantity) const;

 private:
  struct Quantity {
    std::string name;
    std::string unit;
    std::vector<double> rows;  ///< time and value in turn
  };
  struct History {
    std::string name;
    std::vector<Quantity> quantities;
  };

  const History& at(std::string_view name) const;

  DrawnJoints joints_;
  Followed followed_;
  int last_;
  std::vector<History> all_;
};

}  // namespace keyblock::api
