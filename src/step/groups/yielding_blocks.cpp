// Steps elastoplastic blocks one by one, on several threads; see yielding_blocks.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/groups/yielding_blocks.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "base/loop.hpp"
#include "system/block_factor.hpp"

namespace keyblock {

template <class Each>
void YieldingBlocks::for_each_block(const Each& each) const {
  for_each_entry(blocks_.size(), [&](std::size_t i) {
    if (blocks_[i].yield != nullptr) each(ElementIndex{static_cast<int>(i)}, blocks_[i]);
  });
}

void YieldingBlocks::put_elastic(ElementIndex e, const StepEquations& equations) {
  const auto i = static_cast<std::size_t>(e.value);
  if (!yields_[i]) return;
  Block& own = blocks_[i];
  own.yield = &*yields_[i];
  own.share = inelastic_share(bodies_[e], rule_, dt_).total();
  own.matrix = equations.matrix;
  own.right =
      equations.matrix * equations.free + own.yield->inelastic_force(own.yield->inelastic(start_.q[e], before(e)));
}

bool YieldingBlocks::linearise(const UnknownsTable& estimate, FreeStep& step) {
  step.flexibility.inverses.clear();
  std::vector<char> has_factor(blocks_.size(), 1);
  for_each_block([&](ElementIndex e, const Block& block) {
    const Response response = block.yield->respond(end(e, estimate), before(e));
    const UnknownBlock a = block.matrix - block.share * block.yield->lost_stiffness(response) +
                           block.yield->missing_stiffness(start_.q[e], before(e), end(e, estimate), response.after);
    BlockInverse inverse = inverse_of(a, block.yield->rock.law->has_symmetric_tangent());
    has_factor[static_cast<std::size_t>(e.value)] = inverse.exists ? 1 : 0;
    // `judging` stays that of elastic rock: next to the flow of the block, open gaps would appear negligible.
    step.flexibility.blocks[e] = std::move(inverse.inverse);
  });
  step.flexibility.has_symmetric_blocks = std::ranges::all_of(blocks_, [](const Block& block) {
    return block.yield == nullptr || block.yield->rock.law->has_symmetric_tangent();
  });
  return std::ranges::all_of(has_factor, [](char has) { return has != 0; });
}

void YieldingBlocks::evaluate(const UnknownsTable& estimate, FreeStep& step) {
  for_each_block([&](ElementIndex e, const Block& block) {
    const Response response = block.yield->respond(end(e, estimate), before(e));
    if (!response.is_found) {
      step.increments[e].setConstant(estimate[e].size(), std::numeric_limits<double>::quiet_NaN());
      return;
    }
    const Unknowns flowed = block.yield->inelastic_force(block.yield->inelastic(end(e, estimate), response.after) -
                                                         block.yield->inelastic(start_.q[e], before(e)));
    const Unknowns missing = block.yield->missing_force(start_.q[e], before(e), end(e, estimate), response.after);
    const Unknowns residual = block.matrix * estimate[e] - block.right - block.share * flowed + missing;
    step.increments[e] = estimate[e] - step.flexibility.blocks[e] * residual;
  });
}

void YieldingBlocks::put_end(const UnknownsTable& increments, UnknownsTable&, UnknownsTable&,
                             PointMemories& points) const {
  for_each_block([&](ElementIndex e, const Block& block) {
    points.blocks[static_cast<std::size_t>(e.value)] = block.yield->respond(end(e, increments), before(e)).after;
  });
}

}  // namespace keyblock
