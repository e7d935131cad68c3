// Computes the faces that bodies and joints cut from a triangular mesh, each with its body and its triangle.
// Theory: docs/theory/08-manifold-method.md.
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
  std::vector<EdgeOrigin> origins;     ///< per edge
  std::vector<CoverFace> faces;        ///< in bodies only, triangle by triangle
  std::vector<int> face_of_half_edge;  ///< -1: no body there
};

/// Cuts the mesh by the graph. Pieces of slits that end inside a triangle separate nothing and are left out. A piece
/// may run along a side of the mesh within round-off, but not on it. That part of the side is left out, to avoid a face
/// without thickness. Throws std::invalid_argument if a body reaches beyond the mesh.
CoverFaces cover_faces(const BodyGraph& graph, const TriangleMesh& mesh);

}  // namespace keyblock
