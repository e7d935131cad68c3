// Defines the quantities that expected.csv may request, by name, and their values at an instant.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <optional>
#include <string>

#include "result/frame.hpp"
#include "result/step_report.hpp"

namespace keyblock::study {

/// Owner of a quantity: a block, a measured point, a prescribed displacement, a crack tip, or the whole scene.
enum class Owner { block, point, support, tip, scene };

/// Returns the owner of a quantity; empty for an unknown name.
std::optional<Owner> owner_of(const std::string& quantity);

/// Run up to an instant: initial and current state, and maxima so far.
class RunSoFar {
 public:
  /// Adds the next accepted step.
  void add(const StepReport& step);
  /// Adds the next frame, beginning with the start; every step should have one.
  void add(const Frame& frame);

  /// Adds the result of a strength reduction.
  void add_factor_of_safety(double factor) { factor_of_safety_ = factor; }

  const Frame& start() const { return start_; }
  const Frame& now() const { return now_; }
  /// Returns the fraction of steps that needed no shorter one and left no contact undecided; 1 before the first.
  double converged_share() const;
  /// Returns the greatest height of the centre of mass so far.
  double greatest_height() const { return greatest_height_; }
  /// Returns the greatest |A/A0 - 1| of any block so far.
  double greatest_area_change() const { return greatest_area_change_; }
  /// Returns the factor; NaN if none was requested or found.
  double factor_of_safety() const { return factor_of_safety_; }

 private:
  Frame start_;
  Frame now_;
  bool has_begun_ = false;
  int steps_ = 0;
  int converged_ = 0;
  double greatest_height_ = 0;
  double greatest_area_change_ = 0;
  double factor_of_safety_ = std::numeric_limits<double>::quiet_NaN();
};

/// Returns the current value of a quantity; `number` (from 1) selects the block, measured point, support or tip. It
/// must exist.
double quantity_of(const RunSoFar& run, const std::string& quantity, std::optional<int> number);

}  // namespace keyblock::study
