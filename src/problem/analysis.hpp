// Holds the contents of an analysis file: controls of the run, materials of blocks and joints, loads in time.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <vector>

#include "base/error.hpp"
#include "problem/rare.hpp"
#include "problem/time_curve.hpp"
#include "problem/yield.hpp"

namespace keyblock {

/// Stress components in the plane and across it, tension positive.
struct Stress {
  double xx = 0;
  double yy = 0;
  double xy = 0;
  double zz = 0;  ///< follows from the law unless a material gives it; see start_stress

  bool operator==(const Stress&) const = default;
};

/// Velocity of the centroid of a block, and its rotation rate [rad / time].
struct Velocity {
  double x = 0;
  double y = 0;
  double rotation = 0;

  bool operator==(const Velocity&) const = default;
};

/// Block material, for unit thickness.
struct BlockMaterial {
  double density = 0;                      ///< mass / area, > 0
  double unit_weight = 0;                  ///< force / area, positive downward
  double youngs_modulus = 0;               ///< stress, > 0
  double poissons_ratio = 0;               ///< 0 … < 0.5 (0.5 allowed in plane stress)
  double damping = 0;                      ///< DDAML `Damping`
  Stress initial_stress;                   ///< at y = 0; its zz if `gives_zz`
  Stress stress_gradient;                  ///< change of the initial stress per unit of y (native tokens 8-10)
  Velocity initial_velocity;               ///< native tokens 11-13; DDAML `Ivelocity`
  std::array<double, 3> initial_strain{};  ///< DDAML `Istrain`
  double horizontal_force = 0;             ///< force / area in x; manifold files only
  Place place;
  bool gives_zz = false;  ///< else the law computes zz from the stress in the plane; case files only
  std::shared_ptr<const Strength> strength = {};  ///< null: the material stays elastic; case files only
  Rare<CrackClosure> crack_closure = {};          ///< empty: no cracks; case files only
  Rare<Toughness> toughness = {};                 ///< empty: cracks in it do not grow; case files only

  /// Returns true if it has stress before any displacement, anywhere.
  bool is_stressed() const { return initial_stress != Stress{} || stress_gradient != Stress{}; }

  /// Returns true if its stress is not a linear function of strain alone: it may yield, or has cracks that close.
  bool is_nonlinear() const { return strength || crack_closure; }
};

/// Joint material (Coulomb friction, cohesion, tension cut-off).
struct JointMaterial {
  double friction_angle_deg = 0;
  double cohesion = 0;          ///< stress
  double tensile_strength = 0;  ///< stress
  Place place;

  double friction_tangent() const { return std::tan(friction_angle_deg * std::numbers::pi / 180); }

  /// Returns true if it can bond faces.
  bool has_strength() const { return cohesion > 0 || tensile_strength > 0; }
};

/// DDAML `Boltproperties`.
struct BoltProperties {
  double stiffness = 0;
  double strength = 0;
  double pretension = 0;
};

/// Constants of the open–close iteration that a DDAML file can set; defaults are those of Shi's programs
/// (legacy-formats 3.4).
struct OpenCloseConstants {
  double closing_ratio = 2e-4;             ///< s0: penetration over w0 at which an open contact closes
  double opening_ratio = 2e-7;             ///< f0: separation over w0 at which a closed contact opens
  double allowed_penetration = 4e-4;       ///< g3: target penetration over w0 of the automatic penalty
  double angle_overlap_deg = 3;            ///< h1: angle within which two edges count as parallel
  double normal_to_shear_stiffness = 2.5;  ///< h2
};

enum class AnalysisDialect { berkeley, shi, ddaml, manifold };
enum class Rotation { first_order, exact };

/// Contents of an analysis file. Quantities in the file's own consistent unit set, indices from 0.
struct Analysis {
  AnalysisDialect dialect = AnalysisDialect::berkeley;
  double velocity_carry_over = 0;         ///< k01: 0 static (velocity zeroed each step), 1 dynamic
  int step_count = 0;                     ///< n5, ≥ 1
  double allowed_displacement_ratio = 0;  ///< g2: displacement per step over w0, > 0
  double time_step = 0;                   ///< g1: step, or its upper limit with the automatic step, > 0
  bool automatic_time_step = false;
  bool automatic_penalty = false;
  std::optional<double> contact_penalty;  ///< g0 of Shi's files, force / length; absent: penalty_factor × largest E
  double penalty_factor = 50;             ///< pfactor
  bool plane_strain = false;
  Rotation rotation = Rotation::first_order;
  std::optional<double> gravity;  ///< DDAML `Gravaccel`, length / time²; absent: from the unit weights
  int open_close_limit = 8;       ///< open–close iterations
  OpenCloseConstants open_close;
  double contact_damping = 0;             ///< DDAML `ContactDamping`
  std::optional<double> over_relaxation;  ///< SOR factor of Shi's files
  std::optional<int> save_interval;       ///< DDAML `Saveinterval`, steps
  std::vector<BlockMaterial> block_materials;
  std::vector<JointMaterial> joint_materials;
  std::vector<BoltProperties> bolt_properties;
  std::vector<TimeCurve> fixed_point_motions;  ///< Shi's dialect: one per fixed point, may be empty
  std::vector<TimeCurve> point_loads;  ///< one per loading point, in order; fewer than points: the rest carry no load
  TimeCurve body_acceleration;         ///< of a side file, acts on all blocks; empty: none
  Place place;                         ///< file
  Place time_step_place = {};          ///< place of the time step in the file
};

}  // namespace keyblock
