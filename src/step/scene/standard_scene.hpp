// What the steps of Dynamics::standard compute on, and what they hand on to each other.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "contact/find/touch.hpp"
#include "model/material_choices.hpp"
#include "model/scene/scene.hpp"
#include "model/state.hpp"
#include "step/groups/block_group.hpp"
#include "step/scene/contact_memory.hpp"
#include "system/block_factor.hpp"

namespace keyblock {

/// A force on a point of a face, beside the loads of the model: what the other face of a crack still pulls it by.
struct FacePull {
  ElementIndex element;
  Point start;  ///< of the point, undeformed
  Point force;  ///< per unit thickness
};

struct StandardScene {
  Model model;
  Settings settings;
  Reference reference;
  BodyGroups groups;
  std::shared_ptr<const BlockGroup> blocks;  ///< one of the groups
  std::shared_ptr<const Groundwork> groundwork;
  Table<ElementIndex, ConvexPieces> pieces;
  Table<ElementIndex, double> rounding;  ///< of corners: the overlap by which two of them still pass each other
  std::vector<ElementIndex> with_faces;  ///< elements that something may touch
  std::vector<CarriedPoint> held;        ///< fixed points of elements that have unknowns
  Point mass_centre;                     ///< of the blocks that can move, at the start
  double load_share = 1;                 ///< of all loads, while they are put on
  ChosenElements unloaded = {};          ///< that no load reaches while a start is sought; empty: none
  std::vector<FacePull> pulls = {};      ///< not of the loads, and not put on with them
  /// Pattern and room of the factors of contact forces, from step to step: one step at a time.
  std::shared_ptr<FactorStore> factors = std::make_shared<FactorStore>();

  const Bodies& bodies() const { return blocks->bodies(); }
  SceneParts parts() const { return {model, reference, settings}; }
  /// Of the largest body that can move.
  double size() const;
  /// Whether the equations of a step are linear but for contact.
  bool is_linear() const;
  double normal_stiffness() const { return settings.contact_penalty; }
  double tangential_stiffness() const { return normal_stiffness() / settings.open_close.normal_to_shear_stiffness; }
  bool has_springs() const { return has_enforcement(settings, model, Enforcement::penalty); }
};

/// M⁻¹ of everything.
Flexibility mass_flexibility(const StandardScene& scene);

/// An enforcement that is `automatic` is decided here. `groundwork`: Scene::groundwork.
StandardScene standard_scene(Model model, Settings settings, std::shared_ptr<const Groundwork> groundwork = {});
StandardScene standard_scene(Scene scene);

/// Why this scene cannot be run so, in one sentence; empty if it can: blocks with holes have no convex pieces.
std::string unsupported(const StandardScene& scene);

struct Motion : BodiesMotion {
  ClosedContacts closed;
  Bonds bonds;
  ConstraintMemory constraints;
  double given_up = 0;              ///< energy that the clean-up of the last step took where bodies resolve impacts
};

Motion start_motion(const StandardScene& scene);

/// Adds what the spin of a block stretches it by, seen from its own turning frame: d'Alembert's force ρ ω² r over the
/// strain modes u = ε r is ω² M ε with the unit strains εx = εy = 1. A bar of length L that spins about its middle has
/// the mean stress ρ ω² L²/12.
void add_centrifugal_force(const StandardScene& scene, const UnknownsTable& v, UnknownsTable& loads);

/// The scene's share of weight, given acceleration, point loads and bolts of constant force, and the pull of faces, on
/// the unknowns, at `time` and in the configuration q.
UnknownsTable loads_at(const StandardScene& scene, const UnknownsTable& q, double time);

/// M v.
UnknownsTable momentum(const StandardScene& scene, const UnknownsTable& v);

/// The largest of a body.
double largest_momentum(const StandardScene& scene, const UnknownsTable& v);

Scales scales_of(const StandardScene& scene, const UnknownsTable& loads, const UnknownsTable& q,
                 const UnknownsTable& v);

/// Whether some of its rock may yield.
bool may_yield(const StandardScene& scene);

/// Approach speed below which a contact is part of the smooth motion, above which it is an impact: what three steps of
/// free acceleration would give.
double slow_speed(const StandardScene& scene, const Scales& scales, const UnknownsTable& v, double dt);

}  // namespace keyblock
