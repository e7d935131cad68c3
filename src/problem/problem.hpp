// A whole problem, geometry and analysis together, and every complaint about it at once.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "base/error.hpp"
#include "problem/analysis.hpp"
#include "problem/blocks.hpp"
#include "problem/cover.hpp"
#include "problem/cover_plan.hpp"
#include "problem/drawing.hpp"
#include "problem/output_plan.hpp"
#include "problem/run_choices.hpp"
#include "problem/stage.hpp"

namespace keyblock {

/// What the files of a case say together. A geometry or an analysis alone is a problem too, though none to
/// run.
struct Problem {
  std::variant<std::monostate, Drawing, Blocks, Cover> geometry;
  std::optional<Analysis> analysis;
  Units units = {};                                ///< as a case file names them
  std::optional<CoverPlan> covers = std::nullopt;  ///< of a case file: its bodies are to stand on covers
  RunChoices choices = {};                         ///< of a case file
  OutputPlan outputs = {};                         ///< of a case file
  std::vector<Stage> stages = {};                  ///< of a case file; none: one scene from start to end
  std::optional<TimeCurve> motion =
      std::nullopt;           ///< of the ground, a multiple of gravity; once checked, in the analysis
  bool has_own_case = false;  ///< a case file of Keyblock is among its files: it is no old program's
  Place place = {};           ///< the first of its files, for complaints about what is missing
};

/// A problem made sound, and what was said about it: warnings for what was mended, errors for what cannot be.
struct Checked {
  Problem problem;
  Warnings warnings;
  std::vector<InputError> errors;
};

/// Brings material numbers into their range (as the old analysis programs do, but not silently), gives bolts
/// their properties, accelerates blocks by a motion of the ground, and complains about what is odd or cannot be. One
/// warning a kind and number, at its first place.
Checked check(Problem problem);

}  // namespace keyblock
