// Holds the named choices of a run. A profile is a preset of them; each can be set on its own.
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

/// Control of the step size. error: by the error of the step, only in Dynamics::standard.
enum class StepControl { constant, shi, error };
enum class PenaltyControl { constant, adaptive };
enum class Plane { stress, strain };
enum class Bookkeeping { off, on };

/// Rules of the Berkeley program that look like mistakes (marked Q in the rules of one old step). Each names its
/// paragraph. All except the last are on in profile `legacy`, to reproduce old results; each can be turned off alone.
struct BerkeleyQuirks {
  bool moments_about_origin = true;        ///< 7: area moments about the origin of coordinates; far scenes lose digits
  bool search_full_depth = true;           ///< 2: penetration side searched to d0 instead of d9
  bool edge_direction_offset = true;       ///< 3: 1e-7 added to |dx| before the direction of an edge is taken
  bool stale_contact_list = true;          ///< 3: a step that finds no contact keeps the last list
  bool contact_length_last_vertex = true;  ///< 5: other end of a shared edge mistaken after a repeated vertex
  bool plane_strain_factor = true;         ///< 7.2: stiffness has 1/(1-nu) for 1/(1+nu)
  bool velocity_from_coming_step = true;   ///< 7.4: velocity from the step size about to be used, again at each redo
  bool start_velocity_slots = true;        ///< 7.5: native tokens 8-10 are stress gradient and start velocity both
  bool ddaml_slots = false;                ///< the engine's slots hold values of a DDAML file; set by the file
  bool weight_of_first_material = true;    ///< formats 3.2: one gravity for all, from material 1 or `Gravaccel`
  bool cut_step_stays = true;              ///< 11.2: a step cut by the displacement ratio stays cut with constant steps
  bool fixed_pass_bound = true;            ///< 11.1: always 8 iterations; another limit accepts unfinished steps
  /// 13: cumulative time instead of the displacement ratio. Off: it came into the Berkeley program in 2008, and no file
  /// of Shi's own time was run with it. Dynamic runs with the automatic step come to a halt under it.
  bool step_rule_by_time = false;

  /// Returns the rules as they were meant.
  static BerkeleyQuirks none();
  /// Returns the quirks without mistakes in Shi's step, which another step does not make; those in the meaning of files
  /// stay.
  BerkeleyQuirks without_those_of_the_step() const;
};

/// Acceleration of all blocks in addition to gravity, as in a frame fixed to shaken ground. The parts are summed.
struct BodyAcceleration {
  Point constant;
  TimeCurve curve;   ///< length / time², linear between rows
  std::string file;  ///< source of `curve`; empty: none
};

/// Unknowns of a block that may move: three if rigid, six if affine.
enum class BlockBasis { rigid, affine };

/// Limits beyond which the results of a run are unreliable (exit code 1, or 4 if the run cannot continue).
struct TrustLimits {
  double penetration = 0.1;  ///< overlap depth of elements over the size of the smaller
  double crushing =
      0.58;              ///< least area of an element at the end over that at the start; there the elastic law softens
  double energy = 0.01;  ///< kinetic, strain and gravity energy without a source, over the largest stored
};

/// All decisions of a run except the scene itself. Units are those of the input.
struct Settings {
  NodeMerging node_merging = NodeMerging::in_order_found;
  NearPieces near_pieces = NearPieces::deleted;
  Slivers slivers = Slivers::kept;
  int step_count = 0;
  double time_step = 0;  ///< g1
  StepControl step_control = StepControl::constant;
  PerMaterial<double> velocity_carry_over = 1;  ///< 0 static, 1 dynamic; by block material
  PerMaterial<double> mass_damping = 0;         ///< a of the damping matrix a M + b K, 1 / time; by block material
  /// b of the damping matrix [time], by block material. If it is not given, profile `standard` damps strain modes by
  /// `strain_damping`.
  PerMaterial<std::optional<double>> stiffness_damping;
  Rotation rotation = Rotation::first_order;
  Plane plane = Plane::stress;
  PerMaterial<BlockBasis> basis = BlockBasis::affine;  ///< by block material
  Point gravity;                                       ///< acceleration, y up
  double file_gravity = 0;                             ///< downward, as in the file: the gravity of its unit weights
  BodyAcceleration body_acceleration;
  double joint_strength_factor = 1;  ///< applied to tan φ, cohesion and tensile strength of all joint materials
  double contact_penalty = 0;        ///< starting normal stiffness, force / length
  PenaltyControl penalty_control = PenaltyControl::constant;
  double fixed_point_factor = 100;        ///< stiffness of fixed points over the starting contact penalty
  double allowed_displacement_ratio = 0;  ///< g2
  int pass_limit = 8;
  int redo_limit = 200;  ///< repeated attempts at one step before the run ends
  OpenCloseConstants open_close;
  LinearMethod linear_method = LinearMethod::automatic;  ///< for the linear solves of Dynamics::shi
  BerkeleyQuirks quirks;
  Dynamics dynamics = Dynamics::shi;
  Bookkeeping ledger = Bookkeeping::on;  ///< energy balance and momentum, step by step
  TrustLimits trust;
  StandardChoices standard;  ///< read by Dynamics::standard only
};

/// Returns true if each step is a static equilibrium.
inline bool is_statics(const Settings& settings) {
  return settings.dynamics == Dynamics::standard && settings.standard.motion == MotionRule::equilibrium;
}

}  // namespace keyblock
