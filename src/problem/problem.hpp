// Joins geometry and analysis to a whole problem.
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
#include "problem/load_list.hpp"
#include "problem/output_plan.hpp"
#include "problem/run_choices.hpp"
#include "problem/stage.hpp"

namespace keyblock {

/// Contents of all files of a case. A geometry or an analysis alone is a problem too, but cannot run.
struct Problem {
  std::variant<std::monostate, Drawing, Blocks, Cover> geometry;
  std::optional<Analysis> analysis;
  Units units = {};                                ///< as named in a case file
  std::optional<CoverPlan> covers = std::nullopt;  ///< from a case file: its bodies are NMM bodies
  LoadList loads = {};                             ///< from a case file; after the check also in `covers`, if given
  RunChoices choices = {};                         ///< from a case file
  OutputPlan outputs = {};                         ///< from a case file
  std::vector<Stage> stages = {};                  ///< from a case file; empty: one scene from start to end
  std::optional<TimeCurve> motion =
      std::nullopt;           ///< of the ground, a multiple of gravity; after the check it is in the analysis
  bool has_own_case = false;  ///< a case file of Keyblock is among its files, so it is no old program's
  Place place = {};           ///< the first of its files, for errors about missing parts
};

}  // namespace keyblock
