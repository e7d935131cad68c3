// Refines Delaunay triangulations by CGAL; see unstructured_mesh.hpp. No other file uses CGAL, which takes ten seconds
// to compile. Its exact numbers are Boost's, so that nothing is linked.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cut/mesh/unstructured_mesh.hpp"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_mesh_face_base_2.h>
#include <CGAL/Delaunay_mesher_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <map>
#include <tuple>
#include <vector>

#include "geometry/predicates.hpp"
#include "geometry/segment.hpp"

namespace keyblock {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using FaceBase = CGAL::Delaunay_mesh_face_base_2<Kernel>;
using Structure = CGAL::Triangulation_data_structure_2<CGAL::Triangulation_vertex_base_2<Kernel>, FaceBase>;
using Triangulation = CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure, CGAL::Exact_predicates_tag>;

/// Square of the sine of the smallest angle down to which refinement is sure to end.
constexpr double kLeastSquaredSine = 0.125;

Point to_point(const Kernel::Point_2& p) {
  return {p.x(), p.y()};
}
Kernel::Point_2 from_point(Point p) {
  return {p.x, p.y};
}

/// Implements CGAL's concept of a criterion: a side too long must go, an angle too small should.
class Wanted {
 public:
  struct Quality {
    double length = 0;  ///< longest side over the allowed one, squared
    double sine = 1;    ///< sine of the smallest angle, squared

    /// Orders triangles by the urgency of refinement.
    bool operator<(const Quality& other) const {
      if (length > 1 || other.length > 1) return length > other.length;
      return sine < other.sine;
    }
  };

  class Is_bad {
   public:
    explicit Is_bad(const MeshSize& size) : size_(&size) {}

    CGAL::Mesh_2::Face_badness operator()(const Quality& quality) const {
      if (quality.length > 1) return CGAL::Mesh_2::IMPERATIVELY_BAD;
      return quality.sine < kLeastSquaredSine ? CGAL::Mesh_2::BAD : CGAL::Mesh_2::NOT_BAD;
    }

    CGAL::Mesh_2::Face_badness operator()(const Triangulation::Face_handle& face, Quality& quality) const {
      const std::array<Point, 3> p = {to_point(face->vertex(0)->point()), to_point(face->vertex(1)->point()),
                                      to_point(face->vertex(2)->point())};
      std::array<double, 3> squares{};
      for (std::size_t k = 0; k < 3; ++k) {
        const Point side = p[(k + 1) % 3] - p[k];
        squares[k] = dot(side, side);
      }
      std::sort(squares.begin(), squares.end());
      const double wanted = size_->at((1.0 / 3) * (p[0] + p[1] + p[2]));
      const double twice_area = cross(p[1] - p[0], p[2] - p[0]);
      quality.length = squares[2] / (wanted * wanted);
      quality.sine = twice_area * twice_area / (squares[2] * squares[1]);
      return (*this)(quality);
    }

   private:
    const MeshSize* size_;
  };

  explicit Wanted(const MeshSize& size) : size_(&size) {}
  Is_bad is_bad_object() const { return Is_bad(*size_); }

 private:
  const MeshSize* size_;
};

TriangleMesh numbered(const Triangulation& triangulation) {
  std::vector<Triangulation::Vertex_handle> vertices;
  for (auto v = triangulation.finite_vertices_begin(); v != triangulation.finite_vertices_end(); ++v)
    vertices.push_back(v);
  std::sort(vertices.begin(), vertices.end(), [](const auto& a, const auto& b) {
    return std::tuple(a->point().y(), a->point().x()) < std::tuple(b->point().y(), b->point().x());
  });
  TriangleMesh mesh;
  std::map<Triangulation::Vertex_handle, int> number;
  for (const auto& v : vertices) {
    number[v] = static_cast<int>(mesh.nodes.size());
    mesh.nodes.push_back(to_point(v->point()));
  }
  for (auto f = triangulation.finite_faces_begin(); f != triangulation.finite_faces_end(); ++f)
    mesh.triangles.push_back({number[f->vertex(0)], number[f->vertex(1)], number[f->vertex(2)]});
  for (auto& t : mesh.triangles) std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  std::sort(mesh.triangles.begin(), mesh.triangles.end());
  return mesh;
}

/// Distance to a line or another point, per allowed side, below which a point gets no node of its own. Triangles in
/// between would have no area that coordinates resolve, or none that a balance of forces of all bodies resolves.
/// Elastoplastic rock was inverted there in its elastic range.
constexpr double kOwnNode = 0.1;

/// Returns the refined points that become nodes: those within the box that lie exactly on lines, or away from them.
std::vector<Point> nodes_at_points(const Box& box, const MeshSize& size, std::span<const Segment> along) {
  std::vector<Point> nodes;
  std::multimap<double, Point> by_x;
  for (const RefinedPoint& point : size.refined()) {
    const Point p = point.at;
    const double least = kOwnNode * point.side;
    if (!box.holds(p)) continue;
    const auto is_beside = [&](const Segment& s) {
      return p != s.start && p != s.end && distance(s, p) < least &&
             (orientation(s.start, s.end, p) != 0 || std::min(distance(s.start, p), distance(s.end, p)) < least);
    };
    const auto is_near = [&](const auto& other) { return distance(other.second, p) < least; };
    if (std::ranges::any_of(along, is_beside)) continue;
    if (std::any_of(by_x.lower_bound(p.x - least), by_x.upper_bound(p.x + least), is_near)) continue;
    nodes.push_back(p);
    by_x.emplace(p.x, p);
  }
  return nodes;
}

}  // namespace

TriangleMesh unstructured_mesh(const Box& box, const MeshSize& size, std::span<const Segment> along) {
  const Point margin{size.side() / 2, size.side() / 2};
  const Point low = box.low - margin;
  const Point high = box.high + margin;
  const std::array<Point, 4> corners = {low, Point{high.x, low.y}, high, Point{low.x, high.y}};
  Triangulation triangulation;
  for (std::size_t k = 0; k < 4; ++k)
    triangulation.insert_constraint(from_point(corners[k]), from_point(corners[(k + 1) % 4]));
  for (const Segment& s : along) triangulation.insert_constraint(from_point(s.start), from_point(s.end));
  for (const Point p : nodes_at_points(box, size, along)) triangulation.insert(from_point(p));
  CGAL::Delaunay_mesher_2<Triangulation, Wanted> mesher(triangulation, Wanted(size));
  mesher.refine_mesh();
  return numbered(triangulation);
}

}  // namespace keyblock
