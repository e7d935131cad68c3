// Bodies on covers as a case file says them: cut, held and loaded, and solved load step by load step (statics).
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "problem/problem.hpp"
#include "result/field_frame.hpp"
#include "result/frame.hpp"
#include "settings/settings_table.hpp"
#include "step/bodies/linear_static.hpp"

namespace keyblock {

/// What a run takes.
struct CoverCounts {
  CoverFunctions functions = CoverFunctions::derived;
  int bodies = 0;
  int elements = 0;
  int covers = 0;
  int unknowns = 0;
  int load_steps = 0;
  int solves = 0;  ///< load steps before which something is dug out, and the first
};

/// A load step solved.
struct SolvedStep {
  int step = 0;
  double time = 0;
  FieldFrame field;
  Frame frame;  ///< its elements those of the manifold; points with displacement and stress
  ForceBalance balance;
  CoverCounts counts;
  double residual = 0;
  int refinements = 0;
  double factor_entries = 0;
  double seconds = 0;  ///< of processor time: cutting, assembly, solution
};

class CoverCase {
 public:
  /// Cuts the bodies of the start. Settings of the case file and overrides that say nothing of linear statics are
  /// warned of. Throws InputError where something is missing or cannot be: no geometry or analysis, dynamics, a chain
  /// away from all boundaries, a point away from all bodies.
  CoverCase(const Problem& problem, const std::string& profile, const std::vector<Override>& overrides);
  ~CoverCase();

  const Warnings& warnings() const;
  const CoverCounts& counts() const;  ///< of the start

  /// The bodies before any load step, undisplaced.
  const SolvedStep& start() const;

  /// Solves the load steps in turn and hands out each; where nothing was dug out the solution of the step before is
  /// handed out again. Throws NotPositiveDefinite that says which body can still move.
  void run(const std::function<void(const SolvedStep&)>& on_step) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace keyblock
