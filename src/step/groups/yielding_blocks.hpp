// Blocks that may yield in one step: their equations linearised about an estimate, their memories at its end.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "step/bodies/block_yield.hpp"
#include "step/bodies/step_equations.hpp"
#include "step/groups/body_group.hpp"

namespace keyblock {

/// The step of those that may yield; the steps of all others are known. Blocks do not depend on each other and are
/// shared by threads.
class YieldingBlocks final : public EstimatedStep {
 public:
  /// All of it is that of the group and of the start of the step, and outlives this.
  YieldingBlocks(const Bodies& bodies, const std::vector<std::optional<BlockYield>>& yields, const BodiesMotion& start,
                 const StepRule& rule, double dt)
      : bodies_(bodies), yields_(yields), start_(start), rule_(rule), dt_(dt), blocks_(bodies.size()) {}

  /// Keeps A and r of the elastic step of a block; nothing of one that stays elastic.
  void put_elastic(ElementIndex e, const StepEquations& equations);

  bool linearise(const UnknownsTable& estimate, FreeStep& step) override;
  /// Increments are not numbers where the law found no stress.
  void evaluate(const UnknownsTable& estimate, FreeStep& step) override;
  void put_end(const UnknownsTable& increments, UnknownsTable& v, UnknownsTable& a,
               PointMemories& points) const override;

 private:
  struct Block {
    const BlockYield* yield = nullptr;
    double share = 0;     // of a change of inelastic strain
    UnknownBlock matrix;  // A of the elastic step
    Unknowns right;       // what moves it, but for what flows in this step
  };

  template <class Each>
  void for_each_block(const Each& each) const;
  Unknowns end(ElementIndex e, const UnknownsTable& increments) const { return start_.q[e] + increments[e]; }
  const YieldState& before(ElementIndex e) const { return start_.points.blocks[static_cast<std::size_t>(e.value)]; }

  const Bodies& bodies_;
  const std::vector<std::optional<BlockYield>>& yields_;
  const BodiesMotion& start_;
  StepRule rule_;
  double dt_;
  std::vector<Block> blocks_;  // one an element
};

}  // namespace keyblock
