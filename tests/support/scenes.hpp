// Builds small scenes for tests: rectangles, one material, one joint.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "legacy/step/advance.hpp"
#include "legacy/step/start_state.hpp"
#include "model/setup/from_blocks.hpp"
#include "settings/profile.hpp"

namespace keyblock::support {

inline BlockPolygon rectangle(Point low, Point high) {
  return {0, {{low, 0}, {{high.x, low.y}, 0}, {high, 0}, {{low.x, high.y}, 0}}, {}};
}

/// Dynamic, constant step, g = 9.81, rho 2500, E 5e9, nu 0.25, penalty E, friction 0.
inline Analysis plain_analysis(double dt, int steps) {
  Analysis analysis;
  analysis.dialect = AnalysisDialect::ddaml;
  analysis.velocity_carry_over = 1;
  analysis.step_count = steps;
  analysis.time_step = dt;
  analysis.allowed_displacement_ratio = 0.5;
  analysis.penalty_factor = 1;
  analysis.gravity = 9.81;
  BlockMaterial rock;
  rock.density = 2500;
  rock.unit_weight = 24525;
  rock.youngs_modulus = 5e9;
  rock.poissons_ratio = 0.25;
  analysis.block_materials = {rock};
  analysis.joint_materials = {JointMaterial{}};
  return analysis;
}

inline ShiScene legacy_scene(const Blocks& blocks, const Analysis& analysis) {
  return shi_scene({model_from_blocks(blocks, analysis), profile_settings("legacy", analysis)});
}

/// Advances once; a failed step throws.
inline StepReport step_once(const ShiScene& scene, Stepping& stepping) {
  return std::get<StepReport>(advance(scene, stepping));
}

}  // namespace keyblock::support
