// The choices of the dynamics beside Shi's: weights of the step, contact law, start, damping.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "problem/cover_plan.hpp"
#include "settings/per_material.hpp"

namespace keyblock {

/// Which step is made: Shi's, as the old programs do, or midpoint kinematics with contact as complementarity.
enum class Dynamics { shi, standard };

/// How contact forces come about: as multipliers of gaps that do not close, as springs of finite stiffness, or as such
/// springs whose forces are raised until nothing overlaps. automatic: multipliers or springs, as the blocks touch at
/// the start.
enum class Enforcement { lagrange, penalty, augmented, automatic };

/// Where the springs of two faces stand: at the ends of the stretch they share, or at Lobatto's three points.
enum class SpringPoints { ends, lobatto };

/// What stops blocks that meet fast: a jump of velocities with restitution, or the contact springs, which must then be
/// soft against the step (a twentieth of the contact time at most).
enum class ImpactLaw { jump, springs };

/// compatible: of blocks, contact forces and strains in equilibrium with the first accelerations; in scenes with bodies
/// on covers, the static equilibrium under the loads of t = 0 of what something bears. sudden: loads on unstressed
/// bodies. automatic: sudden in scenes with bodies on covers, compatible elsewhere.
enum class StartRule { compatible, sudden, automatic };

/// Which sums of increment, velocity and acceleration make a step: the two weights, or those of the named methods.
enum class Integrator { weighted, newmark, generalized_alpha };

/// critical: stiffness damping that keeps strain modes from fluttering under steady sliding; none: for wave studies.
enum class StrainDamping { critical, none };

/// dynamic: steps in time; equilibrium: each step is one of static equilibrium under the loads of its time.
enum class MotionRule { dynamic, equilibrium };

/// How load steps of rock on covers that nothing touches go on: by equal shares of the loads, or by steps of equal
/// length along the path of equilibria, on which the loads may fall.
enum class LoadControl { share, arc_length };

/// What stress answers large strain on covers: D times the Green strain, which softens under strong pressure, or times
/// the logarithmic strain ½ ln C, which does not.
enum class ElasticLaw { st_venant_kirchhoff, logarithmic };

struct StandardChoices {
  MotionRule motion = MotionRule::dynamic;
  int load_steps = 1;  ///< equilibria from no load to that of the start: one a step, or several where steps are fewer
  LoadControl load_control = LoadControl::share;
  double path_step =
      1;  ///< length of a step along the path over that of elastic rock under an equal share of the loads
  PerMaterial<Enforcement> enforcement = Enforcement::automatic;          ///< by joint material
  CoverFunctions cover_functions = CoverFunctions::derived;               ///< of the elements of a cover file
  PerMaterial<ElasticLaw> elastic_law = ElasticLaw::st_venant_kirchhoff;  ///< by block material
  StartRule start = StartRule::automatic;
  StrainDamping strain_damping = StrainDamping::critical;
  Integrator integrator = Integrator::weighted;
  double velocity_weight = 0.5;  ///< of the velocity at the end of the step in its displacement; 1/2 is second order
  double force_weight = 0.5;     ///< of the elastic force at the end of the step; Shi 1, average acceleration 1/2
  double newmark_beta = 0.25;    ///< 1/4 and 1/2: average acceleration; 1/2 and 1: Shi
  double newmark_gamma = 0.5;
  double rho_infinity = 0.8;       ///< what generalised α leaves of the highest frequencies in a step
  double step_tolerance = 1e-4;    ///< error of a step over block size that its size is chosen for
  double least_step_share = 1e-4;  ///< of the time step, below which it is not cut
  double force_tolerance =
      1e-6;  ///< of contact forces over the heaviest load, where more than fifty touches are settled together
  SpringPoints spring_points = SpringPoints::ends;
  double corner_rounding = 1e-3;  ///< overlap by which corners still pass each other, over half the narrower width
  ImpactLaw impact = ImpactLaw::jump;
  PerMaterial<double> restitution = 0;  ///< rebound over approach speed of an impact; by joint material
};

}  // namespace keyblock
