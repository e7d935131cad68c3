// Derives the lengths and angles of contact search and judgement from the scale of the scene.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "model/model.hpp"
#include "settings/settings.hpp"

namespace keyblock {

/// Lengths and angles of legacy-rules 2, 3, 10; lengths in the unit of the input, angles in degrees.
struct ContactRules {
  double scale = 0;             ///< w0
  double search_distance = 0;   ///< d0: largest distance of two features that form a contact
  double search_depth = 0;      ///< largest initial depth of one in the other
  double closing_depth = 0;     ///< an open contact closes at this penetration
  double opening_distance = 0;  ///< a closed contact opens at this separation
  double angle_overlap = 0;     ///< h1, degrees
  double shear_ratio = 0;       ///< normal over shear stiffness
  double start_distance = 0;    ///< in step 1 of a dynamic run, nearer contacts start closed
};

// Shi's choices (legacy-formats 3.4). The search distance is kSearchedDisplacements allowed displacements. The depth is
// at least kSearchedDepthShare of that, and at least kSearchedPenetrations allowed penetrations.
inline constexpr double kSearchedDisplacements = 2.5;
inline constexpr double kSearchedDepthShare = 0.3;
inline constexpr double kSearchedPenetrations = 3;

inline ContactRules contact_rules(const Model& model, const Settings& settings) {
  const OpenCloseConstants& c = settings.open_close;
  const double move = kSearchedDisplacements * model.scale * settings.allowed_displacement_ratio;
  const double depth =
      std::max(kSearchedDepthShare * move, kSearchedPenetrations * c.allowed_penetration * model.scale);
  const double distance = std::max(move, depth);
  return {model.scale,
          distance,
          settings.quirks.search_full_depth ? distance : depth,
          c.closing_ratio * model.scale,
          c.opening_ratio * model.scale,
          c.angle_overlap_deg,
          c.normal_to_shear_stiffness,
          c.closing_ratio * distance};
}

}  // namespace keyblock
