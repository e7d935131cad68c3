// Follows the chain of scenes.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/scene/scene.hpp"

#include <algorithm>

#include "model/continuum.hpp"

namespace keyblock {

double last_change_of_loads(const Scene& scene) {
  const Model& model = scene.model;
  double last = scene.settings.body_acceleration.curve.last_change();
  const auto count = [&](double time) { last = std::max(last, time); };
  for (const CarriedPoint& point : model.loading_points) count(point.curve.last_change());
  for (const CarriedPoint& point : model.fixed_points) count(point.curve.last_change());
  for (const EdgeLoad& load : model.edge_loads) count(load.last_change);
  for (const SupportRow& row : model.support_rows) count(row.factor.last_change());
  if (model.continuum)
    for (const ChangingTraction& traction : model.continuum->changing_tractions) count(traction.last_change);
  return last;
}

std::vector<double> bends_of_loads(const Model& model, const Settings& settings) {
  std::vector<double> bends = settings.body_acceleration.curve.times;
  const auto add = [&](const std::vector<double>& times) { bends.insert(bends.end(), times.begin(), times.end()); };
  for (const CarriedPoint& point : model.loading_points) add(point.curve.times);
  for (const EdgeLoad& load : model.edge_loads) add(load.bends);
  if (model.continuum)
    for (const ChangingTraction& traction : model.continuum->changing_tractions) add(traction.bends);
  std::ranges::sort(bends);
  bends.erase(std::ranges::unique(bends).begin(), bends.end());
  return bends;
}

bool may_yield(const Scene& scene) {
  return scene.model.continuum &&
         std::ranges::any_of(scene.model.continuum->materials,
                             [](const BlockMaterial& material) { return material.is_nonlinear(); });
}

std::vector<const Scene*> scenes_of(const Scene& first) {
  std::vector<const Scene*> scenes{&first};
  while (scenes.back()->next) scenes.push_back(&scenes.back()->next->scene);
  return scenes;
}

}  // namespace keyblock
