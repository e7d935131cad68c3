// Steps elastoplastic blocks: linearises their equations about an estimate and computes the memories at the end.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "step/bodies/block_yield.hpp"
#include "step/bodies/step_equations.hpp"
#include "step/groups/body_group.hpp"

namespace keyblock {

/// Step of the elastoplastic blocks; the steps of all others are known. Blocks are independent and run on several
/// threads.
class YieldingBlocks final : public EstimatedStep {
 public:
  /// Keeps references to all arguments but `dt`; they must outlive the object.
  YieldingBlocks(const Bodies& bodies, const std::vector<std::optional<BlockYield>>& yields, const BodiesMotion& start,
                 const StepRule& rule, double dt)
      : bodies_(bodies), yields_(yields), start_(start), rule_(rule), dt_(dt), blocks_(bodies.size()) {}

  /// Keeps A and r of the elastic step of a block; does nothing for a block that stays elastic.
  void put_elastic(ElementIndex e, const StepEquations& equations);

  bool linearise(const UnknownsTable& estimate, FreeStep& step) override;
  /// Writes NaN increments if the law found no stress.
  void evaluate(const UnknownsTable& estimate, FreeStep& step) override;
  void put_end(const UnknownsTable& increments, UnknownsTable& v, UnknownsTable& a,
               PointMemories& points) const override;

 private:
  struct Block {
    const BlockYield* yield = nullptr;
    double share = 0;     // InelasticShare::total of a change of inelastic strain
    UnknownBlock matrix;  // A of the elastic step
    Unknowns right;       // right-hand side without the flow of this step
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
  std::vector<Block> blocks_;  // one per element
};

}  // namespace keyblock
