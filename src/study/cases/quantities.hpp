// What can be asked of a run in expected.csv: the quantities by name, and their values at an instant.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <optional>
#include <string>

#include "result/frame.hpp"
#include "result/step_report.hpp"

namespace keyblock::study {

/// Whose quantity it is: that of a block, of a measured point, of a prescribed displacement, of a crack tip, or of the
/// whole scene.
enum class Owner { block, point, support, tip, scene };

/// The owner of a quantity that expected.csv may ask for; nothing for a name that is none.
std::optional<Owner> owner_of(const std::string& quantity);

/// A run up to an instant: where everything is, where it began, and what was seen on the way.
class RunSoFar {
 public:
  /// Takes in the next accepted step.
  void add(const StepReport& step);
  /// Takes in the next frame, the first of them the start; every step should have one.
  void add(const Frame& frame);

  /// Takes in what a strength reduction found.
  void add_factor_of_safety(double factor) { factor_of_safety_ = factor; }

  const Frame& start() const { return start_; }
  const Frame& now() const { return now_; }
  /// Share of the steps that needed no shorter one and left no contact undecided; 1 before the first.
  double converged_share() const;
  /// Greatest height of the centre of mass until now.
  double greatest_height() const { return greatest_height_; }
  /// Greatest |A/A0 - 1| of any block until now.
  double greatest_area_change() const { return greatest_area_change_; }
  /// NaN where none was asked for or found.
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

/// The value of a quantity now; `number` (from 1) says which block, measured point, support or tip. It must exist.
double quantity_of(const RunSoFar& run, const std::string& quantity, std::optional<int> number);

}  // namespace keyblock::study
