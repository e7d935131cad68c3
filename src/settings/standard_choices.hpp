// Holds the choices of the standard dynamics: weights of the step, contact law, initial state, damping.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "problem/cover_plan.hpp"
#include "settings/per_material.hpp"

namespace keyblock {

/// Kind of step: Shi's, as in his programs, or midpoint kinematics with contact as complementarity.
enum class Dynamics { shi, standard };

/// Enforcement of contact conditions: multipliers of gaps that do not close, springs of finite stiffness, or such
/// springs whose forces are raised until no overlap is left. automatic: multipliers or springs, by the contacts at the
/// start.
enum class Enforcement { lagrange, penalty, augmented, automatic };

/// Places of the springs of two faces: at the ends of their shared part, or at Lobatto's three points.
enum class SpringPoints { ends, lobatto };

/// Law that stops blocks in a fast impact: a jump of velocities with restitution, or the contact springs. Springs must
/// then be soft compared with the step (a twentieth of the contact time at most).
enum class ImpactLaw { jump, springs };

/// Rule for the initial state.
///
/// compatible: for blocks, contact forces and strains in equilibrium with the first accelerations; in scenes with NMM
/// bodies, static equilibrium of supported bodies under the loads of t = 0. sudden: loads on unstressed bodies.
enum class StartRule { compatible, sudden };

/// Combination of increment, velocity and acceleration in a step: by the two weights, or by the named methods.
enum class Integrator { weighted, newmark, generalized_alpha };

/// critical: stiffness damping that keeps strain modes from oscillating under steady sliding; none: for wave studies.
enum class StrainDamping { critical, none };

/// dynamic: time steps; equilibrium: each step is a static equilibrium under the loads of its time.
enum class MotionRule { dynamic, equilibrium };

/// Load control of contact-free rock on covers: equal load increments, or steps of equal length along the equilibrium
/// path, on which the loads may fall.
enum class LoadControl { share, arc_length };

/// Stress under large strain on covers: D times the Green strain, which softens under strong compression, or times the
/// logarithmic strain ½ ln C, which does not.
enum class ElasticLaw { st_venant_kirchhoff, logarithmic };

struct StandardChoices {
  MotionRule motion = MotionRule::dynamic;
  int load_steps = 1;  ///< equilibria from no load to the initial loads: one per step, or several if steps are fewer
  LoadControl load_control = LoadControl::share;
  double path_step =
      1;  ///< length of a step along the path, over the length for elastic rock under an equal load increment
  PerMaterial<Enforcement> enforcement = Enforcement::automatic;          ///< by joint material
  CoverFunctions cover_functions = CoverFunctions::derived;               ///< for the elements of a cover file
  PerMaterial<ElasticLaw> elastic_law = ElasticLaw::st_venant_kirchhoff;  ///< by block material
  StartRule start = StartRule::compatible;
  StrainDamping strain_damping = StrainDamping::critical;
  Integrator integrator = Integrator::weighted;
  double velocity_weight = 0.5;  ///< of the velocity at the end of the step in its displacement; 1/2 is second order
  double force_weight = 0.5;     ///< of the elastic force at the end of the step; Shi 1, average acceleration 1/2
  double newmark_beta = 0.25;    ///< 1/4 and 1/2: average acceleration; 1/2 and 1: Shi
  double newmark_gamma = 0.5;
  double rho_infinity = 0.8;       ///< share of the highest frequencies that generalised α keeps per step
  double step_tolerance = 1e-4;    ///< target error of a step, per block size, by which its size is chosen
  double least_step_share = 1e-4;  ///< per time step: parts are not cut below it
  double force_tolerance =
      1e-8;  ///< of contact forces over the heaviest load, if more than fifty contacts are solved together
  SpringPoints spring_points = SpringPoints::ends;
  double corner_rounding = 1e-3;  ///< overlap up to which corners pass each other, over half the narrower width
  ImpactLaw impact = ImpactLaw::jump;
  PerMaterial<double> restitution = 0;  ///< rebound over approach speed of an impact; by joint material
};

}  // namespace keyblock
