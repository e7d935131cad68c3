// Integrates tractions along edges, and chooses independent rows of support per block.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/bodies/edge_loads.hpp"

#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "geometry/box.hpp"
#include "geometry/quadrature.hpp"
#include "geometry/segment.hpp"
#include "model/continuum.hpp"
#include "model/kinematics.hpp"
#include "run/bodies/cover_plan_parts.hpp"
#include "run/bodies/look_at_plan.hpp"

namespace keyblock {
namespace {

// Expressions may have kinks, such as a water level: they are integrated over this many parts of an edge.
constexpr int kParts = 32;
constexpr int kGaussPoints = 3;  // of each part: exact to degree 4 times the shape function
// Remainder of a row, over its size, below which it follows from rows taken before. Corners round to some 1e-10.
constexpr double kFollows = 1e-6;
// Difference of a prescribed displacement from that of the rows it follows from, over the largest of the block.
constexpr double kAgrees = 1e-6;
// A chain follows an edge if it is no farther off than this fraction of the extent, plus kRounding of the largest
// coordinate. Chains on NMM bodies have the same limits.
constexpr double kAlong = 1e-10;
constexpr double kRounding = 8 * std::numeric_limits<double>::epsilon();

/// Edge of a block, or a part of one, along a chain.
struct BlockSide {
  ElementIndex element;
  Segment edge;

  Point normal() const {
    const Point along = edge.end - edge.start;
    return (1 / length(along)) * Point{along.y, -along.x};
  }
};

std::vector<BlockSide> sides_of(const Model& model) {
  std::vector<BlockSide> sides;
  for (const VertexIndex v : indices(model.vertices)) {
    const Vertex& vertex = model.vertices[v];
    if (model.elements[vertex.element].is_on_covers()) continue;
    const auto at = [&](VertexIndex of) { return model.start_vertices[static_cast<std::size_t>(of.value)]; };
    if (!(at(v) == at(vertex.next))) sides.push_back({vertex.element, {at(v), at(vertex.next)}});
  }
  return sides;
}

Box box_of(const Model& model, ElementIndex e) {
  Box box;
  for (const VertexIndex v : model.elements[e].vertices())
    box.add(model.start_vertices[static_cast<std::size_t>(v.value)]);
  return box;
}

double reach_of(const Model& model) {
  Box box;
  for (const Point& p : model.start_vertices) box.add(p);
  if (model.start_vertices.empty()) return 0;
  const double farthest =
      std::max({std::abs(box.low.x), std::abs(box.low.y), std::abs(box.high.x), std::abs(box.high.y)});
  return kAlong * length(box.size()) + kRounding * farthest;
}

EdgeForces forces_on(const BlockSide& side, const TractionOnEdge& traction, double time) {
  EdgeForces load;
  const double size = length(side.edge.end - side.edge.start);
  const Point normal = side.normal();
  for (int part = 0; part < kParts; ++part)
    for (const GaussPoint& g : gauss_rule(kGaussPoints)) {
      const double s = (part + g.at) / kParts;
      const double weight = g.weight / kParts;
      const Point at = point_at(side.edge, s);
      const Point force = (weight * size) * traction.force(at, normal, time);
      const double push = weight * traction.pressure(at, normal, time);
      load.forces[0] = load.forces[0] + (1 - s) * force;
      load.forces[1] = load.forces[1] + s * force;
      load.pushes[0] += (1 - s) * push;
      load.pushes[1] += s * push;
    }
  return load;
}

EdgeLoad load_on(const BlockSide& side, const TractionPlan& plan, const TractionOnEdge& traction) {
  const EdgeForces first = forces_on(side, traction, 0);
  const TimeCurve factor = curve_of(plan.over_time);
  const bool is_fixed = !plan.uses_time();
  return {side.element, side.edge,
          [=](double time) {
            EdgeForces now = is_fixed ? first : forces_on(side, traction, time);
            if (!factor.times.empty()) now.factor = factor.at(time).x;
            return now;
          },
          is_fixed ? factor.last_change() : std::numeric_limits<double>::infinity(), factor.times};
}

std::vector<Point> directions_of(Held held, Point normal) {
  if (held == Held::normal) return {normal};
  if (held == Held::x) return {{1, 0}};
  if (held == Held::y) return {{0, 1}};
  return {{1, 0}, {0, 1}};
}

/// Possible row of a block, by the unknowns of its basis.
struct Candidate {
  SupportRow row;
  Eigen::VectorXd of_unknowns;  ///< strains and rotation count times the size of the block
  const DisplacementPlan* plan = nullptr;
};

/// Chooses rows of one block by Gram–Schmidt, the largest remainder first: the outermost points of an edge.
class Choice {
 public:
  Choice(const Model& model, std::vector<Candidate> all) : model_(model), all_(std::move(all)) {
    for (const Candidate& one : all_) largest_ = std::max(largest_, std::abs(one.row.value));
  }

  std::vector<SupportRow> rows() {
    std::vector<SupportRow> chosen;
    // One column per table of factors: rows agree at all times if they agree in each.
    Eigen::MatrixXd value =
        Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(all_.size()), static_cast<Eigen::Index>(all_.size()));
    std::vector<Eigen::VectorXd> rest;
    for (std::size_t i = 0; i < all_.size(); ++i) {
      rest.push_back(all_[i].of_unknowns);
      value(static_cast<Eigen::Index>(i), table_of(all_[i])) = all_[i].row.value;
    }
    for (;;) {
      const auto widest = std::ranges::max_element(rest, {}, [](const Eigen::VectorXd& r) { return r.norm(); });
      const double norm = widest->norm();
      if (norm <= kFollows) break;
      const auto taken = widest - rest.begin();
      const Eigen::VectorXd unit = *widest / norm;
      const Eigen::RowVectorXd of_unit = value.row(taken) / norm;
      chosen.push_back(all_[static_cast<std::size_t>(taken)].row);
      for (std::size_t i = 0; i < rest.size(); ++i) {
        const double share = unit.dot(rest[i]);
        rest[i] -= share * unit;
        value.row(static_cast<Eigen::Index>(i)) -= share * of_unit;
      }
      rest[static_cast<std::size_t>(taken)].setZero();
      value.row(taken).setZero();
    }
    for (std::size_t i = 0; i < all_.size(); ++i)
      if (value.row(static_cast<Eigen::Index>(i)).cwiseAbs().maxCoeff() > kAgrees * largest_) refuse(all_[i]);
    return chosen;
  }

 private:
  /// Returns the index of the first candidate with the same table of factors.
  Eigen::Index table_of(const Candidate& one) const {
    const auto is_same = [&](const Candidate& other) { return other.plan->over_time == one.plan->over_time; };
    return std::ranges::find_if(all_, is_same) - all_.begin();
  }

  [[noreturn]] void refuse(const Candidate& one) const {
    throw InputError(one.plan->place,
                     fmt::format("expected displacements that block {} can follow with one "
                                 "strain and one rotation, found others at ({:.9g}, {:.9g}); a mesh (covers) bends",
                                 model_.number_of(one.row.element), one.row.start.x, one.row.start.y));
  }

  const Model& model_;
  std::vector<Candidate> all_;
  double largest_ = 0;
};

/// Finds the sides along a chain and calls `visit` with each.
template <class Visit>
void visit_sides(const std::vector<BlockSide>& sides, const std::vector<Point>& along, double near, Visit visit) {
  const std::vector<Segment> pieces = pieces_of(along);
  for (const BlockSide& side : sides)
    for (const Segment& covered : parts_along(side.edge, pieces, near)) visit(BlockSide{side.element, covered});
}

using Candidates = std::map<int, std::vector<Candidate>>;

void add_candidates(const Model& model, const BlockSide& side, const DisplacementPlan& plan,
                    const PrescribedDisplacement& prescribed, Candidates& candidates) {
  const Basis& basis = *model.elements[side.element].basis;
  const Box box = box_of(model, side.element);
  const TimeCurve factor = curve_of(plan.over_time);
  const Unknowns none = Unknowns::Zero(basis.unknown_count());
  for (const Point at : {side.edge.start, side.edge.end}) {
    const Point value = prescribed.value(at, side.normal());
    for (const Point direction : directions_of(plan.held, side.normal())) {
      const DisplacementOperator by_unknowns = jacobian(basis, none, at - box.middle());
      Eigen::VectorXd row = (Eigen::RowVector2d(direction.x, direction.y) * by_unknowns).transpose();
      row.tail(row.size() - 2) /= length(box.size());
      candidates[side.element.value].push_back(
          {{side.element, at, direction, dot(value, direction), factor}, std::move(row), &plan});
    }
  }
}

}  // namespace

void put_edge_loads(Model& model, const LoadList& loads) {
  model.edge_loads.clear();
  model.support_rows.clear();
  if (loads.empty()) return;
  const double near = reach_of(model);
  const std::vector<BlockSide> sides = sides_of(model);
  for (const TractionPlan& plan : loads.tractions) {
    const TractionOnEdge traction = traction_on_edge(plan);
    visit_sides(sides, plan.along, near,
                [&](const BlockSide& side) { model.edge_loads.push_back(load_on(side, plan, traction)); });
  }
  Candidates candidates;
  for (const DisplacementPlan& plan : loads.displacements) {
    const PrescribedDisplacement prescribed = displacement_of(plan);
    visit_sides(sides, plan.along, near, [&](const BlockSide& side) {
      if (model.elements[side.element].can_move()) add_candidates(model, side, plan, prescribed, candidates);
    });
  }
  for (auto& [element, all] : candidates)
    for (const SupportRow& row : Choice(model, std::move(all)).rows()) model.support_rows.push_back(row);
}

namespace {

template <class Part>
bool acts_on_covers(const Part& part, const Scene& scene) {
  const auto& continuum = scene.model.continuum;
  return continuum && !sides_along(continuum->manifold, part.along).empty();
}

// Statics without contact has no time, and factors of tips take tractions as constant.
void require_time(const TractionPlan& part, const Scene& scene) {
  if (!part.changes_over_time() || !acts_on_covers(part, scene)) return;
  const bool has_tips = scene.growth || !scene.model.continuum->cracks.empty();
  if (!scene.is_untouched && !has_tips) return;
  throw InputError(part.place, fmt::format("expected no over_time and no time t on NMM bodies {}, found one",
                                           has_tips ? "with cracks" : "in statics without contact"));
}

// Covers hold their edges by matrices made once.
void require_time(const DisplacementPlan& part, const Scene& scene) {
  if (part.changes_over_time() && acts_on_covers(part, scene))
    throw InputError(part.place, "expected over_time of displacements only on blocks, found one on an NMM body");
}

}  // namespace

Warnings look_at_loads(const LoadList& loads, const std::vector<const Scene*>& scenes) {
  std::vector<Segment> edges;
  double near = 0;
  for (const Scene* scene : scenes) {
    const Model& model = scene->model;
    for (const BlockSide& side : sides_of(model)) edges.push_back(side.edge);
    near = std::max(near, reach_of(model));
    if (!model.continuum) continue;
    for (const ElementSide& side : boundary_sides(model.continuum->manifold)) edges.push_back(side.edge);
  }
  Warnings warnings;
  const auto look = [&](const auto& part) {
    look_at_chain(part.along, part.place, "edges", edges, near, warnings);
    for (const Scene* scene : scenes) require_time(part, *scene);
  };
  for (const TractionPlan& part : loads.tractions) look(part);
  for (const DisplacementPlan& part : loads.displacements) look(part);
  return warnings;
}

}  // namespace keyblock
