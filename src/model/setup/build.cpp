// Appends elements and loops to a model; see build.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/setup/build.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace keyblock {
namespace {

int nearest_existing(int index, std::size_t count) {
  return count == 0 ? 0 : std::clamp(index, 0, static_cast<int>(count) - 1);
}

}  // namespace

void begin_element(Model& model, int material, const Basis& basis, CoverList covers) {
  const VertexIndex first = model.vertices.end_index();
  model.elements.push_back(
      {nearest_existing(material, model.block_materials.size()), &basis, first, first, {}, std::move(covers)});
}

void add_loop(Model& model, const std::vector<Corner>& corners) {
  const ElementIndex element{model.elements.end_index().value - 1};
  const int first = model.vertices.end_index().value;
  const int size = static_cast<int>(corners.size());
  for (int i = 0; i < size; ++i) {
    const Corner& corner = corners[static_cast<std::size_t>(i)];
    const VertexIndex next{first + (i + 1) % size};
    const VertexIndex previous{first + (i + size - 1) % size};
    const int joint = nearest_existing(corner.joint_material, model.joint_materials.size());
    model.vertices.push_back({element, next, previous, joint, corner.is_inner, next, previous});
    model.start_vertices.push_back(corner.position);
  }
  model.elements[element].loop_sizes.push_back(size);
  model.elements[element].end_vertex = model.vertices.end_index();
}

double scale_of(const std::vector<Point>& vertices) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  Point low{kFar, kFar};
  Point high{-kFar, -kFar};
  for (Point p : vertices) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  return std::max(high.x - low.x, high.y - low.y) / 2;
}

}  // namespace keyblock
