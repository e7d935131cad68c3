// Copies unchanged unknowns and projects the rest; see carry_covers.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/groups/carry_covers.hpp"

#include <algorithm>
#include <utility>

#include "geometry/common_rule.hpp"
#include "system/cholmod/sparse_factor.hpp"
#include "system/sparse_system.hpp"

namespace keyblock {
namespace {

// Rings of elements around changed ones whose displacements may change. Tested on a rotated and bent plate with a new
// mesh at the tip of its crack. Its energy loss is 1.4 times (constant functions), 1.1 times (derived) and 0.9 times
// (linear) the loss if all may change; without rings 1.6, 1.1 and 0.9 times.
constexpr int kRings = 2;

Box box_of(std::span<const std::vector<Point>> loops) {
  Box box;
  for (const std::vector<Point>& loop : loops)
    for (const Point& p : loop) box.add(p);
  return box;
}

bool overlap(const Box& a, const Box& b) {
  return a.low.x < b.high.x && b.low.x < a.high.x && a.low.y < b.high.y && b.low.y < a.high.y;
}

Point vector_at(const Eigen::VectorXd& field, int function) {
  return {field[2 * static_cast<Eigen::Index>(function)], field[2 * static_cast<Eigen::Index>(function) + 1]};
}

Point value_of(const ElementShape& shape, const Eigen::RowVectorXd& values, const Eigen::VectorXd& field) {
  Point sum;
  for (int a = 0; a < shape.function_count(); ++a)
    sum = sum + values(a) * vector_at(field, shape.functions[static_cast<std::size_t>(a)]);
  return sum;
}

/// Returns v with M v = ∫ ρ Tᵀ (velocity of points - v of `start`), over the changed elements.
Eigen::VectorXd lacking_velocity(const Eigen::VectorXd& start, const ChangedPart& part,
                                 std::span<const std::vector<FieldPoint>> fields, const CoverScene& after) {
  Eigen::VectorXd loads = Eigen::VectorXd::Zero(start.size());
  for (std::size_t i = 0; i < part.elements.size(); ++i) {
    if (part.changed[i] == 0) continue;
    const ElementShape shape = after.basis().shape(part.elements[i]);
    const double density = after.continuum().material(part.elements[i]).density;
    for (const FieldPoint& point : fields[i]) {
      const Eigen::RowVectorXd values = shape.values(point.start);
      const Point lacks = point.velocity - value_of(shape, values, start);
      const double mass = density * point.area;
      for (int a = 0; a < shape.function_count(); ++a)
        loads.segment<2>(2 * shape.functions[static_cast<std::size_t>(a)]) +=
            mass * values(a) * Eigen::Vector2d(lacks.x, lacks.y);
    }
  }
  return after.mass_inverse()->times(loads).col(0);
}

/// Fits displacements to those of points in the energy of elastic rock as strained there. Among the functions of a part
/// that may change it minimises ½ ∫ E : C : E + ½ w ∫ |δ|², δ the missing displacement. E = sym(Fᵀ ∇δ) has the gradient
/// F of the points. If all functions may change, strain energy falls only by the part that they cannot represent
/// (Galerkin's orthogonality). A projection by mass does not ensure that. `w` fixes the rigid motion, which the
/// functions contain, and decides nothing else.
class Displacements {
 public:
  Displacements(const CoverScene& after, const ChangedPart& part, const Eigen::VectorXd& start)
      : after_(after), part_(part), start_(start), system_(system_of(after, part)) {
    Box box;
    double modulus = 0;
    const Manifold& manifold = after.continuum().manifold;
    for (int e = 0; e < after.basis().element_count(); ++e) {
      for (const ElementCorner& corner : manifold.loop(manifold.elements[static_cast<std::size_t>(e)].outer))
        box.add(corner.position);
      modulus = std::max(modulus, after.continuum().modulus(e)(0, 0));
    }
    weight_ = modulus / dot(box.size(), box.size());
  }

  Eigen::VectorXd nearest(std::span<const std::vector<FieldPoint>> fields) {
    for (std::size_t i = 0; i < fields.size(); ++i) add(i, fields[i]);
    SparseFactor factor(system_.lower(), Definiteness::semidefinite);
    factor.factorise(system_.lower());
    const Eigen::VectorXd more = factor.solve(system_.load()).col(0);
    Eigen::VectorXd all = start_;
    for (std::size_t f = 0; f < part_.place.size(); ++f)
      if (part_.place[f] >= 0) all.segment<2>(2 * static_cast<Eigen::Index>(f)) += more.segment<2>(2 * part_.place[f]);
    return all;
  }

 private:
  static SparseSystem system_of(const CoverScene& after, const ChangedPart& part) {
    FunctionGroups groups;
    for (const int e : part.elements) {
      std::vector<int> places;
      for (const int f : after.basis().shape(e).functions)
        if (const int place = part.place[static_cast<std::size_t>(f)]; place >= 0) places.push_back(place);
      groups.add(places);
    }
    return {part.function_count, groups};
  }

  void add(std::size_t i, const std::vector<FieldPoint>& field) {
    const int e = part_.elements[i];
    const ElementShape shape = after_.basis().shape(e);
    const Eigen::Matrix3d modulus = after_.continuum().modulus(e);
    std::vector<int> places, columns;
    for (int a = 0; a < shape.function_count(); ++a)
      if (const int place = place_of(shape, a); place >= 0) places.push_back(place), columns.push_back(a);
    const auto n = static_cast<Eigen::Index>(2 * columns.size());
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n, n);
    Eigen::VectorXd load = Eigen::VectorXd::Zero(n);
    Eigen::MatrixXd strain(3, n), moves = Eigen::MatrixXd::Zero(2, n);
    for (const FieldPoint& point : field) {
      const Eigen::Matrix2d& f = point.gradient;
      const Eigen::RowVectorXd values = shape.values(point.start);
      const Eigen::Matrix2Xd g = shape.gradients(point.start);
      for (std::size_t k = 0; k < columns.size(); ++k)
        for (int j = 0; j < 2; ++j) {
          const auto column = static_cast<Eigen::Index>(2 * k) + j;
          const int a = columns[k];
          strain.col(column) << f(j, 0) * g(0, a), f(j, 1) * g(1, a), f(j, 0) * g(1, a) + f(j, 1) * g(0, a);
          moves(j, column) = values(a);
        }
      const Eigen::Matrix2d lacks = f.transpose() * (f - Eigen::Matrix2d::Identity() - start_gradient(shape, g));
      const Point u = point.place - point.start - value_of(shape, values, start_);
      matrix += point.area * (strain.transpose() * modulus * strain + weight_ * moves.transpose() * moves);
      load += point.area *
              (strain.transpose() * modulus * Eigen::Vector3d(lacks(0, 0), lacks(1, 1), lacks(0, 1) + lacks(1, 0)) +
               weight_ * moves.transpose() * Eigen::Vector2d(u.x, u.y));
    }
    system_.add_matrix(places, matrix);
    system_.add_load(places, load);
  }

  int place_of(const ElementShape& shape, int a) const {
    return part_.place[static_cast<std::size_t>(shape.functions[static_cast<std::size_t>(a)])];
  }

  Eigen::Matrix2d start_gradient(const ElementShape& shape, const Eigen::Matrix2Xd& gradients) const {
    Eigen::Matrix2d sum = Eigen::Matrix2d::Zero();
    for (int a = 0; a < shape.function_count(); ++a)
      sum += start_.segment<2>(2 * shape.functions[static_cast<std::size_t>(a)]) * gradients.col(a).transpose();
    return sum;
  }

  const CoverScene& after_;
  const ChangedPart& part_;
  const Eigen::VectorXd& start_;
  SparseSystem system_;
  double weight_ = 0;
};

/// Adds rotations so that every body keeps its angular momentum: that of `start`, or of the points in changed parts. It
/// is linear in the places and in the velocities, so that each part counts separately.
Eigen::VectorXd turned_as(const CarriedCovers& start, const ChangedPart& part,
                          std::span<const std::vector<FieldPoint>> fields, const CoverScene& after,
                          const Eigen::VectorXd& d, Eigen::VectorXd v) {
  const std::vector<WholeBody> bodies = after.whole(d, after.momentum(v));
  const std::vector<WholeBody> starts = after.whole(start.d, after.momentum(start.v));
  std::vector<double> missing;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const Point momentum{starts[b].resultant[0], starts[b].resultant[1]};
    missing.push_back(starts[b].resultant[2] + cross(starts[b].centre - bodies[b].centre, momentum) -
                      bodies[b].resultant[2]);
  }
  for (std::size_t i = 0; i < part.elements.size(); ++i) {
    if (part.changed[i] == 0) continue;
    const auto e = static_cast<std::size_t>(part.elements[i]);
    const auto body = static_cast<std::size_t>(after.continuum().manifold.elements[e].body);
    const ElementShape shape = after.basis().shape(part.elements[i]);
    const double density = after.continuum().material(part.elements[i]).density;
    for (const FieldPoint& point : fields[i]) {
      const Eigen::RowVectorXd values = shape.values(point.start);
      const Point arm = point.start + value_of(shape, values, start.d) - bodies[body].centre;
      missing[body] +=
          density * point.area *
          (cross(point.place - bodies[body].centre, point.velocity) - cross(arm, value_of(shape, values, start.v)));
    }
  }
  for (std::size_t b = 0; b < bodies.size(); ++b)
    v += missing[b] / bodies[b].inertia * after.turning(static_cast<int>(b), d, bodies[b].centre);
  return v;
}

}  // namespace

ChangedPart changed_part(const CoverScene& after, const std::vector<char>& kept) {
  const CoverBasis& basis = after.basis();
  ChangedPart part;
  std::vector<char> may_change(static_cast<std::size_t>(basis.function_count()), 0);
  const auto has_any = [&](int e) {
    return std::ranges::any_of(basis.shape(e).functions,
                               [&](int f) { return may_change[static_cast<std::size_t>(f)] != 0; });
  };
  std::vector<int> ring;
  for (int e = 0; e < basis.element_count(); ++e)
    if (kept[static_cast<std::size_t>(e)] == 0) ring.push_back(e);
  for (int r = 0; r <= kRings; ++r) {
    for (const int e : ring)
      for (const int f : basis.shape(e).functions) may_change[static_cast<std::size_t>(f)] = 1;
    ring.clear();
    for (int e = 0; e < basis.element_count(); ++e)
      if (has_any(e)) ring.push_back(e);
  }
  part.elements = std::move(ring);
  for (const int e : part.elements) part.changed.push_back(kept[static_cast<std::size_t>(e)] == 0 ? 1 : 0);
  for (const char changes : may_change) part.place.push_back(changes != 0 ? part.function_count++ : -1);
  return part;
}

CarriedCovers carried_covers(CarriedCovers start, const ChangedPart& part,
                             std::span<const std::vector<FieldPoint>> fields, const CoverScene& after) {
  if (part.elements.empty()) return start;
  CarriedCovers carried;
  carried.d = Displacements(after, part, start.d).nearest(fields);
  carried.v = start.v + lacking_velocity(start.v, part, fields, after);
  carried.v = turned_as(start, part, fields, after, carried.d, std::move(carried.v));
  return carried;
}

BoxedElements::BoxedElements(std::vector<BoxedElement> elements) : from_left_(std::move(elements)) {
  std::ranges::stable_sort(from_left_, {}, [](const BoxedElement& boxed) { return boxed.box.low.x; });
  for (const BoxedElement& boxed : from_left_) widest_ = std::max(widest_, boxed.box.size().x);
}

std::vector<int> BoxedElements::overlapping(const Box& box) const {
  std::vector<int> found;
  const auto first = std::ranges::lower_bound(from_left_, box.low.x - widest_, {},
                                              [](const BoxedElement& boxed) { return boxed.box.low.x; });
  for (auto boxed = first; boxed != from_left_.end() && boxed->box.low.x < box.high.x; ++boxed)
    if (overlap(box, boxed->box)) found.push_back(boxed->element);
  std::ranges::sort(found);
  return found;
}

std::vector<BoxedElements> boxed_elements(const CoverScene& bodies) {
  const Manifold& manifold = bodies.continuum().manifold;
  std::vector<std::vector<BoxedElement>> all(manifold.body_materials.size());
  for (std::size_t e = 0; e < manifold.elements.size(); ++e) {
    BoxedElement& boxed =
        all[static_cast<std::size_t>(manifold.elements[e].body)].emplace_back(BoxedElement{{}, static_cast<int>(e)});
    for (const ElementCorner& corner : manifold.loop(manifold.elements[e].outer)) boxed.box.add(corner.position);
  }
  std::vector<BoxedElements> of_bodies;
  for (std::vector<BoxedElement>& elements : all) of_bodies.emplace_back(std::move(elements));
  return of_bodies;
}

std::vector<FieldPoint> field_over(const CoverScene& bodies, const BoxedElements& elements,
                                   std::span<const std::vector<Point>> region, int degree, const Eigen::VectorXd& d,
                                   const Eigen::VectorXd& v) {
  const Manifold& manifold = bodies.continuum().manifold;
  const int own = bodies.basis().degree();
  std::vector<FieldPoint> field;
  for (const int e : elements.overlapping(box_of(region))) {
    const auto loops = manifold.polygon(manifold.elements[static_cast<std::size_t>(e)]);
    const ElementShape shape = bodies.basis().shape(e);
    for (const AreaPoint& point : common_rule(region, loops, own + std::max(own, degree))) {
      const Eigen::RowVectorXd values = shape.values(point.at);
      const Eigen::Matrix2Xd gradients = shape.gradients(point.at);
      FieldPoint& of = field.emplace_back(FieldPoint{point.at, point.weight, point.at, {}});
      for (int a = 0; a < shape.function_count(); ++a) {
        const int f = 2 * shape.functions[static_cast<std::size_t>(a)];
        of.place = of.place + values(a) * Point{d[f], d[f + 1]};
        of.velocity = of.velocity + values(a) * Point{v[f], v[f + 1]};
        of.gradient += d.segment<2>(f) * gradients.col(a).transpose();
      }
    }
  }
  return field;
}

}  // namespace keyblock
