// Generates rows of triangles; see background_mesh.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cut/mesh/background_mesh.hpp"

#include <algorithm>
#include <cmath>

namespace keyblock {
namespace {

double ratio(MeshShape shape) {
  return shape == MeshShape::equilateral ? 2 / std::sqrt(3.0) : 1.3;
}

/// Rows j and places i of the nodes needed for the triangles over a box, in the mesh's own directions.
class Rows {
 public:
  Rows(const Box& box, const RegularMesh& mesh) : mesh_(mesh), along_{std::cos(mesh.angle), std::sin(mesh.angle)} {
    Box turned;
    for (const Point p : {box.low, Point{box.high.x, box.low.y}, box.high, Point{box.low.x, box.high.y}}) {
      const Point d = p - mesh.through;
      turned.add({dot(along_, d), cross(along_, d)});
    }
    // A box edge on a row, to round-off, must not get outside.
    constexpr double kSlack = 1e-6;
    first_row = static_cast<int>(std::floor(turned.low.y / mesh.dy - kSlack));
    last_row = static_cast<int>(std::ceil(turned.high.y / mesh.dy + kSlack));
    left_ = static_cast<int>(std::floor(turned.low.x / mesh.dx - kSlack));
    count = static_cast<int>(std::ceil(turned.high.x / mesh.dx + kSlack)) - left_ + 2;
  }

  /// Returns the k-th node of a row; nodes of every second row are half a step farther left.
  Point node(int row, int k) const {
    const double x = mesh_.dx * (left_ + k - (is_odd(row) ? 0.5 : 0.0));
    const double y = mesh_.dy * row;
    return mesh_.through + Point{along_.x * x - along_.y * y, along_.y * x + along_.x * y};
  }

  static bool is_odd(int row) { return row % 2 != 0; }

  int first_row = 0;
  int last_row = 0;
  int count = 0;  ///< nodes per row

 private:
  const RegularMesh& mesh_;
  Point along_;
  int left_ = 0;
};

}  // namespace

double mesh_scale(const Box& box) {
  return std::max(box.size().y / 2, box.size().x / 2 / 1.3);
}

RegularMesh centred_mesh(const Box& box, int half_rows, MeshShape shape) {
  RegularMesh mesh;
  mesh.dy = 1.1 * mesh_scale(box) / half_rows;
  mesh.dx = ratio(shape) * mesh.dy;
  mesh.through = box.middle();
  if (half_rows % 2 != 0) mesh.through.x += mesh.dx / 2;
  return mesh;
}

RegularMesh aligned_mesh(const Box& box, int half_rows, MeshShape shape) {
  RegularMesh mesh;
  mesh.dy = box.size().y / (2 * half_rows);
  mesh.dx = ratio(shape) * mesh.dy;
  mesh.through = box.low;
  return mesh;
}

TriangleMesh regular_triangles(const Box& box, const RegularMesh& mesh) {
  const Rows rows(box, mesh);
  TriangleMesh result;
  for (int row = rows.first_row; row <= rows.last_row; ++row) {
    for (int k = 0; k < rows.count; ++k) result.nodes.push_back(rows.node(row, k));
  }
  for (int row = rows.first_row; row < rows.last_row; ++row) {
    const int below = (row - rows.first_row) * rows.count;
    const int above = below + rows.count;
    const int shift = Rows::is_odd(row) ? 0 : 1;  // above node k of an even row are nodes k and k + 1
    for (int k = 0; k + 1 < rows.count; ++k) {
      const int left = below + k;
      const int top = above + k;
      if (shift == 1) {
        result.triangles.push_back({top, left, top + 1});
        result.triangles.push_back({left, left + 1, top + 1});
      } else {
        result.triangles.push_back({left, left + 1, top});
        result.triangles.push_back({top, left + 1, top + 1});
      }
    }
  }
  return result;
}

}  // namespace keyblock
