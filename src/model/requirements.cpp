// Reads the plan of a run off its model and settings.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/requirements.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "model/body_load.hpp"
#include "model/choose_basis.hpp"

namespace keyblock {
namespace {

bool has_weight(const Model& model, const Settings& settings) {
  return std::ranges::any_of(model.block_materials,
                             [&](const BlockMaterial& m) { return !weight_per_area(m, settings).isZero(0); });
}

std::size_t loaded_points(const Model& model) {
  return static_cast<std::size_t>(
      std::ranges::count_if(model.loading_points, [](const CarriedPoint& p) { return !p.curve.times.empty(); }));
}

std::size_t elements_with(const Model& model, int unknowns) {
  return static_cast<std::size_t>(std::ranges::count_if(
      model.elements, [&](const Element& element) { return element.basis->unknown_count() == unknowns; }));
}

std::size_t deforming_elements(const Model& model) {
  return elements_with(model, affine_basis().unknown_count());
}

std::string bases(const Model& model) {
  const std::size_t count = model.elements.size();
  if (deforming_elements(model) == count)
    return fmt::format("affine, 6 unknowns each, for all {} blocks (Shi's block)", count);
  return fmt::format("affine, 6 unknowns each, for {} blocks; rigid, 3, for {}; fixed, none, for {} held blocks",
                     deforming_elements(model), elements_with(model, rigid_basis().unknown_count()),
                     elements_with(model, 0));
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
    case TermKind::body_acceleration:
      return "body_acceleration";
    case TermKind::point_load:
      return "point_load";
    case TermKind::fixed_point:
      return "fixed_point";
    case TermKind::bolt:
      return "bolt";
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
  needs.basis = bases(model);
  needs.terms.push_back({TermKind::inertia, settings.velocity_carry_over == 0
                                                ? "static: mass steadies the step, velocity is zeroed each step"
                                                : "dynamic: velocity is carried from step to step"});
  if (deforming_elements(model) > 0) {
    needs.terms.push_back({TermKind::elastic, "blocks deform"});
    needs.terms.push_back({TermKind::initial_stress, "blocks carry stress from step to step"});
  }
  if (has_weight(model, settings)) needs.terms.push_back({TermKind::body_force, "blocks have weight"});
  if (has_body_acceleration(settings))
    needs.terms.push_back({TermKind::body_acceleration, "a given acceleration acts on the mass of blocks"});
  if (const auto count = loaded_points(model))
    needs.terms.push_back({TermKind::point_load, fmt::format("{} loading points carry a load", count)});
  if (has_held_moving_element(model))
    needs.terms.push_back({TermKind::fixed_point, fmt::format("{} fixed points", model.fixed_points.size())});
  if (!model.bolts.empty()) needs.terms.push_back({TermKind::bolt, fmt::format("{} bolts", model.bolts.size())});
  if (model.elements.size() > 1)
    needs.terms.push_back({TermKind::contact, fmt::format("{} blocks may touch", model.elements.size())});
  return needs;
}

}  // namespace keyblock
