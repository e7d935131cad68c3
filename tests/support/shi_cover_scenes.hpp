// Builds small scenes of elements on covers for tests: a drawing cut by a mesh, stepped by Shi's rules.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>

#include "cut/bodies/cut_blocks.hpp"
#include "cut/covers/cut_cover.hpp"
#include "cut/covers/to_cover.hpp"
#include "cut/mesh/background_mesh.hpp"
#include "legacy/step/advance.hpp"
#include "legacy/step/hanging.hpp"
#include "model/setup/from_manifold.hpp"
#include "settings/profile.hpp"

namespace keyblock::support {

inline Manifold shi_cut(const BodyCut& bodies, int half_rows) {
  Box box;
  for (const BlockPolygon& block : bodies.blocks.blocks.blocks)
    for (const BlockVertex& corner : block.outer) box.add(corner.position);
  return cut_cover(bodies.graph, regular_triangles(box, centred_mesh(box, half_rows, MeshShape::equilateral)));
}

inline ShiScene shi_cover_scene(const Manifold& manifold, const ElementPoints& points, const Analysis& analysis) {
  return shi_scene(
      {with_affine_elements(model_from_manifold(manifold, points, analysis)), profile_settings("legacy", analysis)});
}

inline ShiScene shi_cover_scene(const Drawing& drawing, int half_rows, const Analysis& analysis) {
  const BodyCut bodies = cut_bodies(drawing);
  const Manifold manifold = shi_cut(bodies, half_rows);
  return shi_cover_scene(manifold, points_in_elements(manifold, bodies.blocks.blocks), analysis);
}

}  // namespace keyblock::support
