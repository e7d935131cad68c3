// Reads the plan of a run off its model and settings.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/requirements.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace keyblock {
namespace {

bool has_weight(const Model& model, const Settings& settings) {
  if (settings.quirks.weight_of_first_material) return settings.gravity != 0;
  return std::ranges::any_of(model.block_materials, [](const BlockMaterial& m) { return m.unit_weight != 0; });
}

std::size_t loaded_points(const Model& model) {
  return static_cast<std::size_t>(
      std::ranges::count_if(model.loading_points, [](const CarriedPoint& p) { return !p.curve.times.empty(); }));
}

}  // namespace

std::string_view name_of(TermKind term) {
  switch (term) {
    case TermKind::inertia:
      return "inertia";
    case TermKind::elastic:
      return "elastic";
    case TermKind::initial_stress:
      return "initial_stress";
    case TermKind::body_force:
      return "body_force";
    case TermKind::point_load:
      return "point_load";
    case TermKind::fixed_point:
      return "fixed_point";
    case TermKind::contact:
      return "contact";
  }
  return "";
}

bool Requirements::has(TermKind term) const {
  return std::ranges::any_of(terms, [term](const RequiredTerm& t) { return t.term == term; });
}

Requirements requirements(const Model& model, const Settings& settings) {
  Requirements needs;
  for (const Element& element : model.elements) needs.unknowns += element.basis->unknown_count();
  needs.basis = fmt::format("affine, 6 unknowns each, for all {} blocks (Shi's block)", model.elements.size());
  needs.terms.push_back({TermKind::inertia, settings.velocity_carry_over == 0
                                                ? "static: mass steadies the step, velocity is zeroed each step"
                                                : "dynamic: velocity is carried from step to step"});
  needs.terms.push_back({TermKind::elastic, "blocks deform"});
  needs.terms.push_back({TermKind::initial_stress, "blocks carry stress from step to step"});
  if (has_weight(model, settings)) needs.terms.push_back({TermKind::body_force, "blocks have weight"});
  if (const auto count = loaded_points(model))
    needs.terms.push_back({TermKind::point_load, fmt::format("{} loading points carry a load", count)});
  if (!model.fixed_points.empty())
    needs.terms.push_back({TermKind::fixed_point, fmt::format("{} fixed points", model.fixed_points.size())});
  if (model.elements.size() > 1)
    needs.terms.push_back({TermKind::contact, fmt::format("{} blocks may touch", model.elements.size())});
  return needs;
}

}  // namespace keyblock
