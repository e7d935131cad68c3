// Holds the scene of Dynamics::standard, and the motion that its steps pass to each other.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "contact/find/touch.hpp"
#include "contact/rows/constraints.hpp"
#include "model/material_choices.hpp"
#include "model/scene/scene.hpp"
#include "model/state.hpp"
#include "step/groups/block_group.hpp"
#include "step/scene/contact_memory.hpp"
#include "system/block_factor.hpp"

namespace keyblock {

/// Force on a point of a face in addition to the loads of the model: the remaining pull of the other crack face.
struct FacePull {
  ElementIndex element;
  Point start;  ///< position of the point, undeformed
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
  Table<ElementIndex, double> rounding;  ///< of corners: the overlap up to which two of them pass each other
  std::vector<ElementIndex> with_faces;  ///< elements that can be in contact
  std::vector<HeldPair> held;            ///< supports of elements that have unknowns, besides those of NMM bodies
  Point mass_centre;                     ///< of the movable blocks, at the start
  std::vector<double> load_bends;        ///< bends_of_loads
  double load_share = 1;                 ///< load fraction, below 1 while loads are applied
  ChosenElements unloaded = {};          ///< bodies without load in the search for an initial state; empty: none
  std::vector<FacePull> pulls = {};      ///< not part of the loads, and not scaled with them
  /// Pattern and storage of the factorisations of contact forces, kept from step to step; for one step at a time.
  std::shared_ptr<FactorStore> factors = std::make_shared<FactorStore>();

  const Bodies& bodies() const { return blocks->bodies(); }
  SceneParts parts() const { return {model, reference, settings}; }
  /// Returns the size of the largest movable body.
  double size() const;
  /// Returns true if the equations of a step are linear except for contact.
  bool is_linear() const;
  double normal_stiffness() const { return settings.contact_penalty; }
  double tangential_stiffness() const { return normal_stiffness() / settings.open_close.normal_to_shear_stiffness; }
  bool has_springs() const { return has_enforcement(settings, model, Enforcement::penalty); }
};

/// Returns M⁻¹ of all bodies.
Flexibility mass_flexibility(const StandardScene& scene);

/// Creates the scene and resolves `automatic` enforcement. `groundwork`: Scene::groundwork.
StandardScene standard_scene(Model model, Settings settings, std::shared_ptr<const Groundwork> groundwork = {});
StandardScene standard_scene(Scene scene);

/// Returns one sentence why this scene is not supported; empty if it is. Blocks with holes have no convex pieces.
std::string unsupported(const StandardScene& scene);

struct Motion : BodiesMotion {
  ClosedContacts closed;
  Bonds bonds;
  ConstraintMemory constraints;
  double given_up = 0;  ///< energy that the clean-up of the last step removed from bodies that resolve impacts
};

Motion start_motion(const StandardScene& scene);

/// Adds the stretch of a spinning block, seen from its own rotating frame. D'Alembert's force ρ ω² r over the strain
/// modes u = ε r is ω² M ε with the unit strains εx = εy = 1. A bar of length L that spins about its middle has the
/// mean stress ρ ω² L²/12.
void add_centrifugal_force(const StandardScene& scene, const UnknownsTable& v, UnknownsTable& loads);

/// Returns the loads on the unknowns at `time`, in the configuration q. They are weight, given acceleration, loads
/// of points and edges, and bolts of constant force, all times the load fraction, and the pull of faces.
UnknownsTable loads_at(const StandardScene& scene, const UnknownsTable& q, double time);

/// Returns the mean loads over `length` of time about `middle`, exact for tables: a blow shorter than a step gives its
/// whole impulse. Formulas of time count by the middles of the parts between rows of tables.
UnknownsTable mean_loads(const StandardScene& scene, const UnknownsTable& q, double middle, double length);

/// Returns M v.
UnknownsTable momentum(const StandardScene& scene, const UnknownsTable& v);

/// Returns the largest momentum of a body.
double largest_momentum(const StandardScene& scene, const UnknownsTable& v);

Scales scales_of(const StandardScene& scene, const UnknownsTable& loads, const UnknownsTable& q,
                 const UnknownsTable& v);
/// Returns the scales of a motion under the loads at `time`.
Scales scales_at(const StandardScene& scene, const BodiesMotion& motion, double time);

/// Returns true if some rock is elastoplastic.
bool may_yield(const StandardScene& scene);

/// Returns the approach speed above which a contact is an impact, and below which it belongs to the smooth motion. It
/// is the speed after three steps of free acceleration.
double slow_speed(const StandardScene& scene, const Scales& scales, const UnknownsTable& v, double dt);

}  // namespace keyblock
