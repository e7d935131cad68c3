// The faces that bodies and joints cut from a triangular mesh, each with its body and its triangle.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "cut/covers/overlay.hpp"
#include "cut/lines/faces.hpp"

namespace keyblock {

struct CoverFace {
  Face face;
  int body = -1;
  int triangle = -1;
};

struct CoverFaces {
  Arrangement arrangement;
  std::vector<MeshSide> sides;
  std::vector<EdgeOrigin> origins;     ///< of each edge
  std::vector<CoverFace> faces;        ///< of bodies only, triangle by triangle
  std::vector<int> face_of_half_edge;  ///< -1: no body there
};

/// Pieces of slits that end inside a triangle are left out, for they part nothing. Where a piece runs along a side of
/// the mesh within round-off, but not on it, there would be a face without thickness between them: that part of the
/// side is left out. Throws std::invalid_argument where a body reaches beyond the mesh.
CoverFaces cover_faces(const BodyGraph& graph, const TriangleMesh& mesh);

}  // namespace keyblock
