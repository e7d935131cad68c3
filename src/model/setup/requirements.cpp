// Decides, in one function per term, if a scene needs the term, and returns the reason.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/setup/requirements.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <set>

#include "base/counted.hpp"
#include "model/body_load.hpp"
#include "model/continuum.hpp"
#include "model/material_choices.hpp"
#include "model/setup/choose_basis.hpp"
#include "model/shared_covers.hpp"

namespace keyblock {
namespace {

using Reason = std::optional<std::string>;

std::size_t elements_with(const Model& model, int unknowns) {
  return static_cast<std::size_t>(std::ranges::count_if(
      model.elements, [&](const Element& element) { return element.basis->unknown_count() == unknowns; }));
}

/// Counts elements on covers, for profile `standard`; the legacy step gives them unknowns of their own.
std::size_t on_covers(const Model& model) {
  return model.continuum ? static_cast<std::size_t>(std::ranges::count_if(model.elements, &Element::is_on_covers)) : 0;
}

/// Returns two unknowns per function of each cover.
int unknowns_on_covers(const Model& model) {
  if (!model.continuum) return 0;
  if (model.continuum->tip_functions.are_asked()) return 2 * basis_of(*model.continuum).function_count();
  const auto covers = static_cast<int>(model.continuum->manifold.covers.size());
  switch (model.continuum->functions) {
    case CoverFunctions::constant:
    case CoverFunctions::derived:
      return 2 * covers;
    case CoverFunctions::linear:
      return 6 * covers;
    case CoverFunctions::quadratic:
      return 12 * covers;
  }
  return 0;
}

std::ptrdiff_t covers_in_use(const Model& model) {
  return std::ranges::count(carrying_nodes(model), true);
}

bool deforms(const Model& model) {
  return elements_with(model, affine_basis().unknown_count()) > 0 || on_covers(model) > 0;
}

bool is_standard(const Settings& settings) {
  return settings.dynamics == Dynamics::standard;
}

bool can_touch(const Model& model) {
  return model.elements.size() > 1 && std::ranges::any_of(model.elements, &Element::can_move);
}

/// Returns the numbers of the materials of blocks that can move.
std::set<int> moving_materials(const Model& model) {
  std::set<int> materials;
  for (const Element& element : model.elements)
    if (element.can_move()) materials.insert(element.material);
  return materials;
}

std::set<int> joints_in_use(const Model& model) {
  std::set<int> joints;
  for (const Vertex& vertex : model.vertices) joints.insert(vertex.joint_material);
  return joints;
}

/// Counts the joint materials in use for which `holds` is true.
template <class Predicate>
std::size_t joints_with(const Model& model, Predicate holds) {
  return static_cast<std::size_t>(std::ranges::count_if(joints_in_use(model), [&](int joint) {
    const auto number = static_cast<std::size_t>(joint);
    return number < model.joint_materials.size() && std::invoke(holds, model.joint_materials[number]);
  }));
}

bool is_in_time(const Settings& settings) {
  return !is_standard(settings) || settings.standard.motion == MotionRule::dynamic;
}

bool is_equilibrium(const Settings& settings) {
  return is_standard(settings) && settings.standard.motion == MotionRule::equilibrium;
}

Reason inertia(const Model& model, const Settings& settings) {
  if (!is_in_time(settings)) return std::nullopt;
  if (is_static(settings, model)) return "static: mass steadies the step, velocity is zeroed each step";
  const bool differs = std::ranges::any_of(moving_materials(model), [&](int material) {
    return settings.velocity_carry_over.of(material) != settings.velocity_carry_over.common;
  });
  return differs ? "velocity is carried from step to step, with a share per material"
                 : "dynamic: velocity is carried from step to step";
}

Reason statics(const Model&, const Settings& settings) {
  if (is_in_time(settings)) return std::nullopt;
  const std::string loading = settings.standard.load_steps > 1
                                  ? fmt::format("; {} equilibria up to the first loads", settings.standard.load_steps)
                                  : "";
  return (is_equilibrium(settings)
              ? "each step is an equilibrium under the loads of its time"
              : "each step is an equilibrium, found by a motion stopped at peaks of kinetic energy") +
         loading;
}

Reason elastic(const Model& model, const Settings&) {
  if (!deforms(model)) return std::nullopt;
  return "blocks deform";
}

Reason plastic(const Model& model, const Settings& settings) {
  if (!is_standard(settings)) return std::nullopt;
  const auto yields = std::ranges::count_if(moving_materials(model), [&](int material) {
    return model.block_materials[static_cast<std::size_t>(material)].strength != nullptr;
  });
  const auto cracked = std::ranges::count_if(moving_materials(model), [&](int material) {
    return model.block_materials[static_cast<std::size_t>(material)].crack_closure.has_value();
  });
  if (yields == 0 && cracked == 0) return std::nullopt;
  const auto rock_of = [](std::ptrdiff_t count, const char* does) {
    return fmt::format("rock of {} {}", counted(static_cast<std::size_t>(count), "material"), does);
  };
  const char* closing = "has cracks that close";
  if (yields == 0) return rock_of(cracked, closing);
  return rock_of(yields, "is elastoplastic") + (cracked > 0 ? ", " + rock_of(cracked, closing) : "");
}

Reason initial_stress(const Model& model, const Settings& settings) {
  if (!deforms(model)) return std::nullopt;
  if (!is_standard(settings)) return "blocks carry stress from step to step";
  const bool is_stressed = std::ranges::any_of(moving_materials(model), [&](int material) {
    return model.block_materials[static_cast<std::size_t>(material)].is_stressed();
  });
  return is_stressed ? Reason("blocks are stressed at the start") : std::nullopt;
}

Reason damping(const Model& model, const Settings& settings) {
  if (is_equilibrium(settings)) return std::nullopt;
  const std::set<int> materials = moving_materials(model);
  const auto some = [&](auto holds) { return std::ranges::any_of(materials, holds); };
  std::string reason;
  const auto add = [&](const char* words) { reason += fmt::format("{}{}", reason.empty() ? "" : "; ", words); };
  if (some([&](int m) { return settings.mass_damping.of(m) != 0; })) add("mass_damping of materials");
  if (!deforms(model)) return reason.empty() ? std::nullopt : Reason(reason);
  if (some([&](int m) { return settings.stiffness_damping.of(m).value_or(0) != 0; }))
    add("stiffness_damping of materials");
  const bool by_rule = is_standard(settings) && settings.standard.strain_damping == StrainDamping::critical;
  const auto is_of_blocks = [&](int m) {
    return std::ranges::any_of(model.elements,
                               [&](const Element& e) { return e.material == m && e.can_move() && !e.is_on_covers(); });
  };
  if (by_rule && some([&](int m) { return !settings.stiffness_damping.of(m) && is_of_blocks(m); }))
    add("strain modes of blocks are damped critically, or they flutter in steady sliding (strain_damping = none leaves "
        "it out)");
  return reason.empty() ? std::nullopt : Reason(reason);
}

Reason body_force(const Model& model, const Settings& settings) {
  const bool has_weight = std::ranges::any_of(moving_materials(model), [&](int material) {
    return !weight_per_area(model.block_materials[static_cast<std::size_t>(material)], settings).isZero(0);
  });
  return has_weight ? Reason("blocks have weight") : std::nullopt;
}

Reason body_acceleration(const Model&, const Settings& settings) {
  if (!has_body_acceleration(settings)) return std::nullopt;
  return settings.body_acceleration.curve.times.empty()
             ? "a constant acceleration is given to the mass of blocks"
             : fmt::format("a table of {} accelerations acts on the mass of blocks",
                           settings.body_acceleration.curve.times.size());
}

Reason point_load(const Model& model, const Settings&) {
  const auto count = static_cast<std::size_t>(
      std::ranges::count_if(model.loading_points, [](const CarriedPoint& p) { return !p.curve.times.empty(); }));
  if (count == 0) return std::nullopt;
  return fmt::format("{} {} a load", counted(count, "loading point"), count == 1 ? "carries" : "carry");
}

/// Returns the number of different elements of a list.
template <class Part>
std::size_t elements_of(const std::vector<Part>& parts) {
  std::set<int> elements;
  for (const Part& part : parts) elements.insert(part.element.value);
  return elements.size();
}

Reason edge_load(const Model& model, const Settings&) {
  if (model.edge_loads.empty()) return std::nullopt;
  return fmt::format("tractions act on edges of {}", counted(elements_of(model.edge_loads), "block"));
}

Reason edge_support(const Model& model, const Settings&) {
  if (model.support_rows.empty()) return std::nullopt;
  return fmt::format("edges of {} are held", counted(elements_of(model.support_rows), "block"));
}

Reason fixed_point(const Model& model, const Settings&) {
  if (!has_held_moving_element(model)) return std::nullopt;
  return counted(model.fixed_points.size(), "fixed point");
}

Reason bolt(const Model& model, const Settings&) {
  if (model.bolts.empty()) return std::nullopt;
  return counted(model.bolts.size(), "bolt");
}

std::string enforcements(const Model& model, const Settings& settings) {
  constexpr std::array<const char*, 4> kWords{"multipliers", "springs of the contact stiffness",
                                              "springs of the contact stiffness until no overlap is left",
                                              "multipliers or springs"};
  std::string words;
  for (Enforcement enforcement :
       {Enforcement::lagrange, Enforcement::penalty, Enforcement::augmented, Enforcement::automatic}) {
    if (!has_enforcement(settings, model, enforcement)) continue;
    words += fmt::format("{}{}", words.empty() ? "" : " and ", kWords[static_cast<std::size_t>(enforcement)]);
  }
  return words;
}

Reason contact(const Model& model, const Settings& settings) {
  if (!is_standard(settings))
    return model.elements.size() > 1 ? Reason(fmt::format("{} blocks may be in contact", model.elements.size()))
                                     : std::nullopt;
  if (!can_touch(model)) return std::nullopt;
  return fmt::format("{} blocks may be in contact, forces by {}", model.elements.size(), enforcements(model, settings));
}

Reason friction(const Model& model, const Settings& settings) {
  if (!is_standard(settings) || !can_touch(model)) return std::nullopt;
  const std::size_t rough = joints_with(model, [](const JointMaterial& j) { return j.friction_angle_deg > 0; });
  if (rough == 0) return std::nullopt;
  return fmt::format("{} of {} in use {} rough", rough, counted(joints_in_use(model).size(), "joint material"),
                     rough == 1 ? "is" : "are");
}

Reason bond(const Model& model, const Settings& settings) {
  if (!is_standard(settings) || !can_touch(model)) return std::nullopt;
  const std::size_t strong = joints_with(model, &JointMaterial::has_strength);
  if (strong == 0) return std::nullopt;
  return fmt::format("{} of {} in use hold{} cohesion or tension until the first slip or opening", strong,
                     counted(joints_in_use(model).size(), "joint material"), strong == 1 ? "s" : "");
}

Reason impact(const Model& model, const Settings& settings) {
  if (!is_standard(settings) || !can_touch(model) || !is_in_time(settings)) return std::nullopt;
  if (is_static(settings, model)) return std::nullopt;
  if (settings.standard.impact == ImpactLaw::springs) return "blocks that meet fast are stopped by the contact springs";
  double least = settings.standard.restitution.common;
  double greatest = least;
  for (int joint : joints_in_use(model)) {
    least = std::min(least, restitution_of(settings, joint));
    greatest = std::max(greatest, restitution_of(settings, joint));
  }
  const std::string range = least == greatest ? fmt::format("{}", least) : fmt::format("{} to {}", least, greatest);
  if (!model.continuum) return fmt::format("blocks that meet fast jump apart, restitution {}", range);
  const bool has_blocks = std::ranges::any_of(
      model.elements, [](const Element& element) { return element.can_move() && !element.is_on_covers(); });
  if (!has_blocks) return "NMM bodies rebound by their own elasticity";
  return fmt::format("blocks that meet fast jump apart, restitution {}; NMM bodies rebound by their own elasticity",
                     range);
}

Reason start(const Model& model, const Settings& settings) {
  if (!is_standard(settings) || !is_in_time(settings)) return std::nullopt;
  if (settings.standard.start == StartRule::sudden) return "sudden: unstressed bodies are suddenly loaded";
  if (model.continuum) return "compatible: supported bodies are in static equilibrium under the loads of t = 0";
  if (initial_stress(model, settings)) return "by the stress of the file";
  return "compatible: contact forces and strains fit the first accelerations";
}

struct TermRow {
  TermKind term;
  std::string_view name;
  Reason (*reason)(const Model& model, const Settings& settings);
};

// In the order of the theory.
constexpr std::array<TermRow, 18> kRows{{
    {TermKind::inertia, "inertia", inertia},
    {TermKind::statics, "statics", statics},
    {TermKind::elastic, "elastic", elastic},
    {TermKind::plastic, "plastic", plastic},
    {TermKind::initial_stress, "initial_stress", initial_stress},
    {TermKind::damping, "damping", damping},
    {TermKind::body_force, "body_force", body_force},
    {TermKind::body_acceleration, "body_acceleration", body_acceleration},
    {TermKind::point_load, "point_load", point_load},
    {TermKind::edge_load, "edge_load", edge_load},
    {TermKind::fixed_point, "fixed_point", fixed_point},
    {TermKind::edge_support, "edge_support", edge_support},
    {TermKind::bolt, "bolt", bolt},
    {TermKind::contact, "contact", contact},
    {TermKind::friction, "friction", friction},
    {TermKind::bond, "bond", bond},
    {TermKind::impact, "impact", impact},
    {TermKind::start, "start", start},
}};

std::string bases(const Model& model, const Settings& settings) {
  const std::size_t count = model.elements.size();
  const std::size_t affine = elements_with(model, affine_basis().unknown_count());
  const std::size_t rigid = elements_with(model, rigid_basis().unknown_count());
  if (!is_standard(settings) && affine == count && model.nodes.empty())
    return fmt::format("affine, 6 unknowns each, for all {} blocks (Shi's block)", count);
  if (!model.nodes.empty() && affine == count)
    return fmt::format("first-order, 2 unknowns each, of {} covers that {} elements share", covers_in_use(model),
                       count);
  std::string words;
  const auto add = [&](std::size_t of, const std::string& what, const char* noun) {
    if (of > 0) words += fmt::format("{}{} for {}", words.empty() ? "" : "; ", what, counted(of, noun));
  };
  const std::string chosen = settings.basis.own.empty() ? "" : " (chosen by block material)";
  add(affine, "affine, 6 unknowns each," + chosen, "block");
  add(rigid, "rigid, 3 unknowns each," + chosen, "block");
  const std::size_t covered = on_covers(model);
  if (covered > 0)
    words += fmt::format("{}{} functions, {} unknowns on {} physical covers, for {}", words.empty() ? "" : "; ",
                         name_of(model.continuum->functions), unknowns_on_covers(model),
                         model.continuum->manifold.covers.size(), counted(covered, "element"));
  add(count - affine - rigid - covered, "fixed, none,", "block");
  return words;
}

}  // namespace

std::string_view name_of(TermKind term) {
  const auto found = std::ranges::find(kRows, term, &TermRow::term);
  return found == kRows.end() ? std::string_view() : found->name;
}

bool Requirements::has(TermKind term) const {
  return std::ranges::any_of(terms, [term](const RequiredTerm& t) { return t.term == term; });
}

Requirements requirements(const Model& model, const Settings& settings, const std::string& why_enforcement) {
  Requirements needs;
  needs.unknowns = model.continuum ? unknowns_on_covers(model) : static_cast<int>(2 * covers_in_use(model));
  for (const Element& element : model.elements)
    if (!element.is_on_covers()) needs.unknowns += element.basis->unknown_count();
  needs.basis = bases(model, settings);
  for (const auto& [term, name, reason_for] : kRows) {
    Reason reason = reason_for(model, settings);
    if (!reason) continue;
    if (term == TermKind::contact && !why_enforcement.empty()) *reason += " (" + why_enforcement + ")";
    needs.terms.push_back({term, *reason});
  }
  return needs;
}

Requirements linear_requirements(const Model& model, const Settings& settings) {
  Requirements needs;
  needs.unknowns = unknowns_on_covers(model);
  needs.basis = bases(model, settings);
  const auto bodies = model.continuum->manifold.body_materials.size();
  const std::string whose = bodies == 1 ? "1 body" : fmt::format("{} bodies", bodies);
  const bool yields = plastic(model, settings).has_value();
  const bool faces = model.continuum->faces_touch;
  needs.terms.push_back(
      {TermKind::statics,
       yields ? fmt::format("load steps of {}, each from the one before, without contact", whose)
              : fmt::format("load steps are linear static solutions of {}: {} touch{}, displacements are small", whose,
                            faces ? "only faces of cracks" : "nothing", faces ? "" : "es")});
  for (const auto& [term, name, reason_for] : kRows)
    if (term == TermKind::elastic || term == TermKind::plastic || term == TermKind::initial_stress ||
        term == TermKind::body_force)
      if (const Reason reason = reason_for(model, settings)) needs.terms.push_back({term, *reason});
  return needs;
}

}  // namespace keyblock
