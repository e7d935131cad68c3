// Lists the unknowns and equation terms that a scene needs, with the reason for each. Terms absent from the list cost
// no time in the run.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "model/model.hpp"
#include "settings/settings.hpp"

namespace keyblock {

enum class TermKind {
  inertia,
  statics,
  elastic,
  plastic,
  initial_stress,
  damping,
  body_force,
  body_acceleration,
  point_load,
  edge_load,
  fixed_point,
  edge_support,
  bolt,
  contact,
  friction,
  bond,
  impact,
  start
};

std::string_view name_of(TermKind term);

struct RequiredTerm {
  TermKind term;
  std::string reason;
};

struct Requirements {
  int unknowns = 0;
  std::string basis;  ///< one sentence: which basis, for how many elements
  std::vector<RequiredTerm> terms;

  bool has(TermKind term) const;
};

/// Returns the plan of a run, in the order of the theory. `why_enforcement` gives the reason for the enforcement of
/// contact conditions, if the user did not set it.
Requirements requirements(const Model& model, const Settings& settings, const std::string& why_enforcement = {});

/// Returns the plan of a run whose steps are linear static solves.
Requirements linear_requirements(const Model& model, const Settings& settings);

}  // namespace keyblock
