// Counts agreements of joint materials over shared edges under both conventions.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/shi/edge_convention.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <utility>

namespace keyblock::formats {
namespace {

constexpr double kVertexTolerance = 1e-5;  // over the half size of the scene

double half_size(const std::vector<BlockPolygon>& blocks) {
  Point low{std::numeric_limits<double>::max(), std::numeric_limits<double>::max()};
  Point high{std::numeric_limits<double>::lowest(), std::numeric_limits<double>::lowest()};
  for (const BlockPolygon& block : blocks)
    for (const BlockVertex& vertex : block.outer) {
      low = {std::min(low.x, vertex.position.x), std::min(low.y, vertex.position.y)};
      high = {std::max(high.x, vertex.position.x), std::max(high.y, vertex.position.y)};
    }
  return std::max(high.x - low.x, high.y - low.y) / 2;
}

/// Gives points within a tolerance of each other one number, by a grid of cells of that size. Cell numbers stay
/// doubles: a scene may be too wide for integers.
class PointNumbers {
 public:
  explicit PointNumbers(double tolerance) : tolerance_(tolerance > 0 ? tolerance : 1) {}

  std::size_t number(Point point) {
    const double column = std::floor(point.x / tolerance_);
    const double row = std::floor(point.y / tolerance_);
    for (const double dx : {-1, 0, 1})
      for (const double dy : {-1, 0, 1}) {
        const auto found = cells_.find({column + dx, row + dy});
        if (found != cells_.end() && distance(points_[found->second], point) <= tolerance_) return found->second;
      }
    cells_[{column, row}] = points_.size();
    points_.push_back(point);
    return points_.size() - 1;
  }

 private:
  double tolerance_;
  std::vector<Point> points_;
  std::map<std::pair<double, double>, std::size_t> cells_;
};

struct EdgeMaterials {
  int arriving = 0;
  int leaving = 0;
};

using Edges = std::map<std::pair<std::size_t, std::size_t>, EdgeMaterials>;

Edges edges_of(const std::vector<BlockPolygon>& blocks) {
  PointNumbers numbers(kVertexTolerance * half_size(blocks));
  Edges edges;
  for (const BlockPolygon& block : blocks)
    for (std::size_t i = 0; i < block.outer.size(); ++i) {
      const BlockVertex& start = block.outer[i];
      const BlockVertex& end = block.outer[(i + 1) % block.outer.size()];
      edges[{numbers.number(start.position), numbers.number(end.position)}] = {end.joint_material,
                                                                               start.joint_material};
    }
  return edges;
}

}  // namespace

EdgeConvention convention_of(const std::vector<BlockPolygon>& blocks) {
  const Edges edges = edges_of(blocks);
  int arriving = 0;
  int leaving = 0;
  for (const auto& [ends, materials] : edges) {
    const auto other = edges.find({ends.second, ends.first});
    if (ends.first >= ends.second || other == edges.end()) continue;
    arriving += materials.arriving == other->second.arriving ? 1 : 0;
    leaving += materials.leaving == other->second.leaving ? 1 : 0;
  }
  return leaving > arriving ? EdgeConvention::leaving : EdgeConvention::arriving;
}

std::vector<BlockPolygon> with_arriving_edges(std::vector<BlockPolygon> blocks) {
  for (BlockPolygon& block : blocks) {
    const BlockLoop loop = block.outer;
    for (std::size_t i = 0; i < loop.size(); ++i)
      block.outer[(i + 1) % loop.size()].joint_material = loop[i].joint_material;
  }
  return blocks;
}

}  // namespace keyblock::formats
