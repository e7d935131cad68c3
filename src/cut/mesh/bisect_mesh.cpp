// Marks, closes and halves triangles iteratively; see bisect_mesh.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cut/mesh/bisect_mesh.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <unordered_map>
#include <vector>

#include "geometry/polygon.hpp"

namespace keyblock {
namespace {

using Triangle = std::array<int, 3>;

// Sides of regular meshes are equal except for round-off.
constexpr double kEqualSides = 1e-9;
constexpr int kUncut = -1;  // edge to be halved that has no node yet

const Point& node(const TriangleMesh& mesh, int n) {
  return mesh.nodes[static_cast<std::size_t>(n)];
}

/// Returns the key of a side, equal for both directions.
std::uint64_t key(int a, int b) {
  const auto [low, high] = std::minmax(a, b);
  return static_cast<std::uint64_t>(low) << 32U | static_cast<std::uint32_t>(high);
}

Triangle turned(const Triangle& t, int k) {
  const auto at = [&](int i) { return t[static_cast<std::size_t>((i + k) % 3)]; };
  return {at(0), at(1), at(2)};
}

double longest_side(const TriangleMesh& mesh, const Triangle& t) {
  return std::max({distance(node(mesh, t[0]), node(mesh, t[1])), distance(node(mesh, t[1]), node(mesh, t[2])),
                   distance(node(mesh, t[2]), node(mesh, t[0]))});
}

Triangle with_longest_side_first(const TriangleMesh& mesh, const Triangle& t, Point rows) {
  const double longest = longest_side(mesh, t);
  Triangle best = t;
  double along = -1;
  for (int k = 0; k < 3; ++k) {
    const Triangle candidate = turned(t, k);
    const Point side = node(mesh, candidate[1]) - node(mesh, candidate[0]);
    if (length(side) < (1 - kEqualSides) * longest) continue;
    const double agreement = std::abs(dot(side, rows)) / length(side);
    if (agreement <= along + kEqualSides) continue;
    along = agreement;
    best = candidate;
  }
  return best;
}

/// Bisects a mesh; the first side of a triangle is the one to be halved next.
class Bisection {
 public:
  explicit Bisection(TriangleMesh& mesh) : mesh_(mesh) {}

  /// `longest_of`: longest side that a triangle may have.
  template <class Longest>
  bool mark_large(Longest longest_of) {
    cut_.clear();
    for (const Triangle& t : mesh_.triangles)
      if (longest_side(mesh_, t) > longest_of(t)) cut_.emplace(key(t[0], t[1]), kUncut);
    return !cut_.empty();
  }

  /// Marks the first side of each triangle that has any side to be halved.
  void close() {
    for (bool changes = true; changes;) {
      changes = false;
      for (const Triangle& t : mesh_.triangles)
        if (!is_cut(t[0], t[1]) && (is_cut(t[1], t[2]) || is_cut(t[2], t[0])))
          changes = cut_.emplace(key(t[0], t[1]), kUncut).second || changes;
    }
  }

  void halve_all() {
    const std::vector<Triangle> before = std::move(mesh_.triangles);
    mesh_.triangles.clear();
    mesh_.triangles.reserve(2 * before.size());
    for (const Triangle& t : before) halve(t);
    if (static_cast<double>(mesh_.triangles.size()) > kMostTriangles)
      throw std::invalid_argument("a mesh refined to more than 4e6 triangles");
  }

 private:
  bool is_cut(int a, int b) const { return cut_.contains(key(a, b)); }

  int middle_of(int a, int b) {
    int& middle = cut_.find(key(a, b))->second;
    if (middle == kUncut) {
      middle = static_cast<int>(mesh_.nodes.size());
      mesh_.nodes.push_back(0.5 * (node(mesh_, a) + node(mesh_, b)));
    }
    return middle;
  }

  void halve(const Triangle& t) {
    if (!is_cut(t[0], t[1])) {
      mesh_.triangles.push_back(t);
      return;
    }
    const int middle = middle_of(t[0], t[1]);
    halve({t[2], t[0], middle});
    halve({t[1], t[2], middle});
  }

  TriangleMesh& mesh_;
  std::unordered_map<std::uint64_t, int> cut_;  // sides to be halved, and the nodes in their middles
};

template <class Longest>
int halve_while_large(TriangleMesh& mesh, Point rows, Longest longest_of) {
  const auto before = static_cast<int>(mesh.nodes.size());
  for (Triangle& t : mesh.triangles) t = with_longest_side_first(mesh, t, rows);
  for (Bisection bisection(mesh); bisection.mark_large(longest_of);) {
    bisection.close();
    bisection.halve_all();
  }
  return static_cast<int>(mesh.nodes.size()) - before;
}

constexpr double kLeastAngle = 15 * std::numbers::pi / 180;

double least_angle(const std::array<Point, 3>& p) {
  double least = std::numbers::pi;
  for (std::size_t k = 0; k < 3; ++k) {
    const Point a = p[(k + 1) % 3] - p[k], b = p[(k + 2) % 3] - p[k];
    least = std::min(least, std::atan2(cross(a, b), dot(a, b)));
  }
  return least;
}

/// Returns the triangles of each node.
std::vector<std::vector<int>> stars(const TriangleMesh& mesh) {
  std::vector<std::vector<int>> of_node(mesh.nodes.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (const int n : mesh.triangles[t]) of_node[static_cast<std::size_t>(n)].push_back(static_cast<int>(t));
  return of_node;
}

/// Returns the nodes on the edge of the mesh, up to which bodies may reach.
std::vector<char> rim_of(const TriangleMesh& mesh) {
  std::unordered_map<std::uint64_t, int> sides;
  for (const Triangle& t : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k) ++sides[key(t[k], t[(k + 1) % 3])];
  std::vector<char> is_rim(mesh.nodes.size(), 0);
  for (const Triangle& t : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k)
      if (sides[key(t[k], t[(k + 1) % 3])] == 1)
        is_rim[static_cast<std::size_t>(t[k])] = is_rim[static_cast<std::size_t>(t[(k + 1) % 3])] = 1;
  return is_rim;
}

double least_angle_with(const TriangleMesh& mesh, const std::vector<int>& star, int moved, Point to) {
  double least = std::numbers::pi;
  for (const int t : star) {
    std::array<Point, 3> p;
    for (std::size_t k = 0; k < 3; ++k) {
      const int n = mesh.triangles[static_cast<std::size_t>(t)][k];
      p[k] = n == moved ? to : node(mesh, n);
    }
    least = std::min(least, least_angle(p));
  }
  return least;
}

constexpr std::size_t kCandidates = 4;  // nodes nearest to a point

}  // namespace

int bisect(TriangleMesh& mesh, const MeshSize& size, Point rows) {
  return halve_while_large(mesh, rows, [&](const Triangle& t) {
    return size.at((1.0 / 3) * (node(mesh, t[0]) + node(mesh, t[1]) + node(mesh, t[2])));
  });
}

int bisect_at(TriangleMesh& mesh, std::span<const Point> points, double side, Point rows) {
  return halve_while_large(mesh, rows, [&](const Triangle& t) {
    const std::array<Point, 3> corners{node(mesh, t[0]), node(mesh, t[1]), node(mesh, t[2])};
    const bool holds_one =
        std::ranges::any_of(points, [&](Point p) { return keyblock::side(corners, p) != Side::outside; });
    return holds_one ? (1 + kEqualSides) * side : std::numeric_limits<double>::infinity();
  });
}

int place_nodes(TriangleMesh& mesh, std::span<const Point> points) {
  if (points.empty()) return 0;
  const std::vector<std::vector<int>> of_node = stars(mesh);
  std::vector<int> nearest(mesh.nodes.size());
  std::vector<char> is_taken = rim_of(mesh);
  int placed = 0;
  for (const Point to : points) {
    for (std::size_t n = 0; n < nearest.size(); ++n) nearest[n] = static_cast<int>(n);
    const std::size_t count = std::min(kCandidates, nearest.size());
    std::partial_sort(nearest.begin(), nearest.begin() + static_cast<std::ptrdiff_t>(count), nearest.end(),
                      [&](int a, int b) { return distance(node(mesh, a), to) < distance(node(mesh, b), to); });
    int best = -1;
    double widest = kLeastAngle;
    for (std::size_t i = 0; i < count; ++i) {
      const auto n = static_cast<std::size_t>(nearest[i]);
      if (is_taken[n]) continue;
      const double angle = least_angle_with(mesh, of_node[n], nearest[i], to);
      if (angle <= widest) continue;
      widest = angle;
      best = nearest[i];
    }
    if (best < 0) continue;
    mesh.nodes[static_cast<std::size_t>(best)] = to;
    is_taken[static_cast<std::size_t>(best)] = 1;
    ++placed;
  }
  return placed;
}

}  // namespace keyblock
