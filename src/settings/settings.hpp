// The named choices of a run. A profile is a preset of them; every one can be set on its own.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "problem/analysis.hpp"
#include "problem/blocks.hpp"
#include "problem/drawing.hpp"
#include "settings/per_material.hpp"
#include "settings/standard_choices.hpp"
#include "system/linear_method.hpp"

namespace keyblock {

/// error: by the error of the step, Dynamics::standard alone.
enum class StepControl { constant, shi, error };
enum class PenaltyControl { constant, adaptive };
enum class Plane { stress, strain };
enum class Bookkeeping { off, on };

/// Rules of the Berkeley program that look like mistakes (marked Q in the rules of one old step). Each names
/// the paragraph. On in profile `legacy`, to give the old numbers back, but for the last; each can be left out alone.
struct BerkeleyQuirks {
  bool moments_about_origin = true;        ///< 7: area moments about the origin of coordinates; far scenes lose digits
  bool search_full_depth = true;           ///< 2: penetration side searched to d0 instead of d9
  bool edge_direction_offset = true;       ///< 3: 1e-7 added to |dx| before the direction of an edge is taken
  bool stale_contact_list = true;          ///< 3: a step that finds no contact keeps the last list
  bool contact_length_last_vertex = true;  ///< 5: other end of a shared edge mistaken after a repeated vertex
  bool plane_strain_factor = true;         ///< 7.2: stiffness has 1/(1-nu) for 1/(1+nu)
  bool velocity_from_coming_step = true;   ///< 7.4: velocity from the step size about to be used, again at each redo
  bool start_velocity_slots = true;        ///< 7.5: native tokens 8-10 are stress gradient and start velocity both
  bool ddaml_slots = false;  ///< the engine's slots hold what a DDAML file puts there; of the file, not a choice
  bool weight_of_first_material = true;  ///< formats 3.2: one gravity for all, from material 1 or `Gravaccel`
  bool cut_step_stays = true;            ///< 11.2: a step cut by the displacement ratio stays cut with constant steps
  bool fixed_pass_bound = true;          ///< 11.1: 8 passes whatever the limit; another limit accepts unfinished steps
  /// 13: cumulative time in place of the displacement ratio. Off: it came into the Berkeley program in 2008, dynamic
  /// runs with the automatic step grind to a halt under it, and no file of Shi's own time was run so.
  bool step_rule_by_time = false;

  /// The rules as they were meant.
  static BerkeleyQuirks none();
  /// Without the mistakes in Shi's step, which another step does not make; those in what files mean stay.
  BerkeleyQuirks without_those_of_the_step() const;
};

/// An acceleration of all blocks beside gravity, as of a shaken ground seen from the ground. The parts add up.
struct BodyAcceleration {
  Point constant;
  TimeCurve curve;   ///< length / time², linear between rows
  std::string file;  ///< what `curve` was read from; empty: nothing
};

/// Unknowns of a block that may move, three or six.
enum class BlockBasis { rigid, affine };

/// What a run may show and still be trusted: beyond it, it does not end well (exit code 1, or 4 where it cannot go on).
struct TrustLimits {
  double penetration = 0.1;  ///< depth of elements in one another over the size of the smaller
  double crushing =
      0.58;  ///< least area of an element at the end over that at the start; there the elastic law gives way
  double energy = 0.01;  ///< kinetic, strain and gravity energy that nothing gave, over the largest there was
};

/// Everything a run decides besides the scene itself. Units are those of the input.
struct Settings {
  NodeMerging node_merging = NodeMerging::in_order_found;
  NearPieces near_pieces = NearPieces::deleted;
  Slivers slivers = Slivers::kept;
  int step_count = 0;
  double time_step = 0;  ///< g1
  StepControl step_control = StepControl::constant;
  PerMaterial<double> velocity_carry_over = 1;  ///< 0 static, 1 dynamic; by block material
  PerMaterial<double> mass_damping = 0;         ///< a of the damping matrix a M + b K, 1 / time; by block material
  /// b of it, time, by block material; where it is not given, profile `standard` damps strain modes as strain_damping
  /// says.
  PerMaterial<std::optional<double>> stiffness_damping;
  Rotation rotation = Rotation::first_order;
  Plane plane = Plane::stress;
  PerMaterial<BlockBasis> basis = BlockBasis::affine;  ///< by block material
  Point gravity;                                       ///< acceleration, y up
  double file_gravity = 0;  ///< downward, as the file has it: the one that its unit weights speak of
  BodyAcceleration body_acceleration;
  double joint_strength_factor = 1;  ///< on tan φ, cohesion and tensile strength of all joint materials
  double contact_penalty = 0;        ///< starting normal stiffness, force / length
  PenaltyControl penalty_control = PenaltyControl::constant;
  double fixed_point_factor = 100;        ///< stiffness of fixed points over the starting contact penalty
  double allowed_displacement_ratio = 0;  ///< g2
  int pass_limit = 8;
  int redo_limit = 200;  ///< redone attempts at one step before the run is given up
  OpenCloseConstants open_close;
  LinearMethod linear_method = LinearMethod::automatic;  ///< of the systems of Dynamics::shi
  BerkeleyQuirks quirks;
  Dynamics dynamics = Dynamics::shi;
  Bookkeeping ledger = Bookkeeping::on;  ///< energy and momentum, step by step
  TrustLimits trust;
  StandardChoices standard;  ///< read by Dynamics::standard alone
};

/// Each step is an equilibrium, with no motion in time.
inline bool is_statics(const Settings& settings) {
  return settings.dynamics == Dynamics::standard && settings.standard.motion == MotionRule::equilibrium;
}

}  // namespace keyblock
