// Creates the groups of DDA blocks and, if the model has any, of NMM bodies.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/groups/make_groups.hpp"

#include <algorithm>

#include "step/groups/cover_group.hpp"

namespace keyblock {

namespace {

std::shared_ptr<const CoverScene> covers_of(const Model& model, const Settings& settings,
                                            const std::shared_ptr<const Groundwork>& before) {
  auto found = std::dynamic_pointer_cast<const CoverScene>(before);
  return found && found->is_of(model, settings) ? found : std::make_shared<const CoverScene>(model, settings);
}

}  // namespace

MadeGroups groups_of(const Model& model, const Settings& settings, Reference& reference,
                     const std::shared_ptr<const Groundwork>& before) {
  Bodies bodies = bodies_of(model, reference, settings);
  std::vector<bool> on_covers;
  for (const Element& element : model.elements) on_covers.push_back(element.is_on_covers());
  std::vector<BodyGroups::Group> groups;
  std::shared_ptr<const CoverScene> covers;
  if (std::ranges::find(on_covers, true) != on_covers.end()) {
    covers = covers_of(model, settings, before);
    reference.covers = covers->kinematics();
    for (ElementIndex e : indices(bodies))
      if (model.elements[e].is_on_covers()) bodies[e].size = covers->body_at_start(e).size;
    groups.push_back(std::make_shared<const CoverGroup>(covers));
  }
  std::vector<std::optional<BlockYield>> yields;
  for (ElementIndex e : indices(bodies)) yields.push_back(block_yield(model, reference, settings, e));
  if (std::ranges::none_of(yields, [](const auto& yield) { return yield.has_value(); })) yields.clear();
  auto blocks = std::make_shared<const BlockGroup>(std::move(bodies), std::move(on_covers), std::move(yields));
  groups.insert(groups.begin(), blocks);
  return {BodyGroups(std::move(groups)), std::move(blocks), std::move(covers)};
}

}  // namespace keyblock
