// Draws a strength reduction: displacement over the factor, and the motion of the unstable scene.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geometry/point.hpp"
#include "problem/run_choices.hpp"
#include "result/field_frame.hpp"

namespace keyblock::report {

/// A run at one factor.
struct StrengthPoint {
  enum class Kind { stands, falls, undecided };
  double factor = 1;
  double displacement = 0;  ///< of a stable run; others have no meaningful one
  Kind kind = Kind::stands;
};

struct StrengthChart {
  std::string title;
  std::vector<StrengthPoint> points;
  std::optional<double> stands;  ///< the bracket
  std::optional<double> falls;
  Units units = {};
  std::optional<double> service = {};  ///< factor from which displacements grow, if that is below the bracket
};

/// Returns an SVG document: the largest displacement of stable trials over the factor, and the bracket as a band.
/// Unstable and undecided trials have no displacement: they are crosses in a strip above the axes.
std::string strength_chart(const StrengthChart& chart);

/// A stretch of a joint whose sides move against each other between two states.
struct SlipLine {
  Point from;  ///< where it lay at the start
  Point to;
  double slip = 0;     ///< along the joint, of the side on the left over that on the right
  double opening = 0;  ///< across it
};

/// Returns the slip from `before` to `after` between elements of different bodies that share an edge at the start. Both
/// frames have the same elements. Ends are distinguished to 1e-6 of the extent.
std::vector<SlipLine> slip_lines(const FieldFrame& before, const FieldFrame& after);

/// A bolt as drawn, and its force in the last stable state.
struct StrengthBolt {
  Segment at;
  double force = 0;
  bool is_at_strength = false;  ///< it is broken
};

struct StrengthPicture {
  std::string title;
  FieldFrame standing;
  std::vector<double> plastic_strains;  ///< of its elements
  std::string standing_words;           ///< "stable at 1.39"
  FieldFrame before;  ///< increments count from it: the standing state, or the last of the trial that falls
  std::optional<FieldFrame> falling;  ///< with the same elements
  std::string falling_words;          ///< "unstable at 1.4"
  Units units = {};
  std::vector<StrengthBolt> bolts = {};
};

/// Returns an SVG document of two panels. The first has the last stable state, coloured by plastic strain if there is
/// any, with the forces of bolts. The second has the displacement increments, coloured by their size over the largest,
/// with arrows and slipping joints.
std::string strength_picture(const StrengthPicture& picture);

}  // namespace keyblock::report
