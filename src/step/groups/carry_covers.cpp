// Products of polynomials over the elements that are left.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/groups/carry_covers.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "geometry/common_rule.hpp"
#include "system/sparse_factor.hpp"
#include "system/sparse_system.hpp"
#include "terms/cover_inertia.hpp"

namespace keyblock {
namespace {

/// x and y of a vector field as coefficients of the monomials of an element's frame, one column each.
using FieldPolynomial = Eigen::MatrixX2d;

FieldPolynomial field_of(const ElementShape& shape, const Eigen::VectorXd& d) {
  Eigen::MatrixX2d own(shape.function_count(), 2);
  for (int a = 0; a < shape.function_count(); ++a)
    own.row(a) = d.segment<2>(2 * shape.functions[static_cast<std::size_t>(a)]).transpose();
  return shape.monomial * own;
}

/// Of the place itself.
FieldPolynomial place_of(const ElementShape& shape) {
  FieldPolynomial place = FieldPolynomial::Zero(monomial_count(shape.degree), 2);
  place.row(monomial(0, 0)) << shape.frame.origin.x, shape.frame.origin.y;
  place(monomial(1, 0), 0) = shape.frame.size;
  place(monomial(0, 1), 1) = shape.frame.size;
  return place;
}

class Carrying {
 public:
  Carrying(const CoverScene& before, std::span<const int> parents, const CoverScene& after)
      : before_(before), parents_(parents), after_(after) {
    const Continuum& continuum = after.continuum();
    for (int e = 0; e < after.basis().element_count(); ++e) {
      const ElementShape shape = after.basis().shape(e);
      const auto loops = continuum.manifold.polygon(continuum.manifold.elements[static_cast<std::size_t>(e)]);
      masses_.push_back(monomial_mass(shape.degree, polygon_moments(loops, shape.frame, 2 * shape.degree),
                                      continuum.material(e).density));
    }
  }

  Eigen::VectorXd projected(const Eigen::VectorXd& field) const {
    Eigen::VectorXd result = copied(field);
    Eigen::VectorXd left = Eigen::VectorXd::Zero(result.size());
    for (int e = 0; e < after_.basis().element_count(); ++e) {
      if (is_kept(e, field, result)) continue;
      const ElementShape shape = after_.basis().shape(e);
      const FieldPolynomial missing = before(e, field) - field_of(shape, result);
      const Eigen::MatrixX2d force = shape.monomial.transpose() * (mass(e) * missing);
      for (int a = 0; a < shape.function_count(); ++a)
        left.segment<2>(2 * shape.functions[static_cast<std::size_t>(a)]) += force.row(a).transpose();
    }
    return result + after_.mass_inverse()->times(left).col(0);
  }

  /// What the velocity after lacks of the angular momentum that what is left had before.
  Eigen::VectorXd with_angular_momentum(const Eigen::VectorXd& d_before, const Eigen::VectorXd& v_before,
                                        const Eigen::VectorXd& d, Eigen::VectorXd v) const {
    const std::vector<WholeBody> bodies = after_.whole(d, after_.momentum(v));
    std::vector<double> missing;
    for (const WholeBody& body : bodies) missing.push_back(-body.resultant[2]);
    for (int e = 0; e < after_.basis().element_count(); ++e) {
      const auto body =
          static_cast<std::size_t>(after_.continuum().manifold.elements[static_cast<std::size_t>(e)].body);
      const ElementShape shape = after_.basis().shape(e);
      FieldPolynomial arm = place_of(shape) + before(e, d_before);
      arm.row(monomial(0, 0)) -= Eigen::RowVector2d(bodies[body].centre.x, bodies[body].centre.y);
      const FieldPolynomial momentum = mass(e) * before(e, v_before);
      missing[body] += arm.col(0).dot(momentum.col(1)) - arm.col(1).dot(momentum.col(0));
    }
    for (std::size_t b = 0; b < bodies.size(); ++b)
      v += missing[b] / bodies[b].inertia * after_.turning(static_cast<int>(b), d, bodies[b].centre);
    return v;
  }

 private:
  const Eigen::MatrixXd& mass(int element) const { return masses_[static_cast<std::size_t>(element)]; }

  FieldPolynomial before(int element, const Eigen::VectorXd& field) const {
    return field_of(before_.basis().shape(parents_[static_cast<std::size_t>(element)]), field);
  }

  /// Whether an element has the polynomials of its parent and copies of its unknowns, so that it misses nothing.
  bool is_kept(int element, const Eigen::VectorXd& field, const Eigen::VectorXd& result) const {
    const ElementShape was = before_.basis().shape(parents_[static_cast<std::size_t>(element)]);
    const ElementShape is = after_.basis().shape(element);
    if (was.function_count() != is.function_count() || was.degree != is.degree) return false;
    if (was.frame.origin != is.frame.origin || was.frame.size != is.frame.size) return false;
    for (std::size_t a = 0; a < is.functions.size(); ++a)
      if (field.segment<2>(2 * was.functions[a]) != result.segment<2>(2 * is.functions[a])) return false;
    return was.monomial == is.monomial;
  }

  /// Function by function of the covers that elements had and have: all of it, but for gradients that are derived from
  /// covers which are gone.
  Eigen::VectorXd copied(const Eigen::VectorXd& field) const {
    const Manifold& was = before_.continuum().manifold;
    const Manifold& is = after_.continuum().manifold;
    const int functions = after_.basis().function_count() / static_cast<int>(is.covers.size());
    Eigen::VectorXd result = Eigen::VectorXd::Zero(2 * after_.basis().function_count());
    for (std::size_t e = 0; e < is.elements.size(); ++e)
      for (std::size_t k = 0; k < 3; ++k) {
        const int from = was.elements[static_cast<std::size_t>(parents_[e])].covers[k] * functions;
        const int to = is.elements[e].covers[k] * functions;
        result.segment(2 * to, 2 * functions) = field.segment(2 * from, 2 * functions);
      }
    return result;
  }

  const CoverScene& before_;
  std::span<const int> parents_;
  const CoverScene& after_;
  std::vector<Eigen::MatrixXd> masses_;  ///< of the monomials of each element
};

Box box_of(std::span<const std::vector<Point>> loops) {
  Box box;
  for (const std::vector<Point>& loop : loops)
    for (const Point& p : loop) box.add(p);
  return box;
}

bool overlap(const Box& a, const Box& b) {
  return a.low.x < b.high.x && b.low.x < a.high.x && a.low.y < b.high.y && b.low.y < a.high.y;
}

/// ∫ ρ N f over every element, f of the points.
Eigen::VectorXd loads_of(std::span<const std::vector<FieldPoint>> fields, const CoverScene& after,
                         Point (*of)(const FieldPoint&)) {
  Eigen::VectorXd loads = Eigen::VectorXd::Zero(2 * after.basis().function_count());
  for (int e = 0; e < after.basis().element_count(); ++e) {
    const ElementShape shape = after.basis().shape(e);
    const double density = after.continuum().material(e).density;
    for (const FieldPoint& point : fields[static_cast<std::size_t>(e)]) {
      const Eigen::RowVectorXd values = density * point.area * shape.values(point.start);
      const Point f = of(point);
      for (int a = 0; a < shape.function_count(); ++a)
        loads.segment<2>(2 * shape.functions[static_cast<std::size_t>(a)]) += values(a) * Eigen::Vector2d(f.x, f.y);
    }
  }
  return loads;
}

/// Displacements nearest to those of points in the energy of elastic rock as it is strained there: of all that the
/// functions hold, the least of ½ ∫ E : C : E + ½ w ∫ |δ|², δ what they lack, E = sym(Fᵀ ∇δ) with the gradient F of the
/// points. Strain energy then falls by what the functions cannot hold and by no more (Galerkin's orthogonality), which
/// a projection by mass does not grant. `w` holds the rigid motion, which is among the functions, and decides nothing
/// else.
class Displacements {
 public:
  explicit Displacements(const CoverScene& after) : after_(after), system_(system_of(after)) {
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
    for (int e = 0; e < after_.basis().element_count(); ++e) add(e, fields[static_cast<std::size_t>(e)]);
    SparseFactor factor(system_.lower(), Definiteness::semidefinite);
    factor.factorise(system_.lower());
    return factor.solve(system_.load()).col(0);
  }

 private:
  static SparseSystem system_of(const CoverScene& after) {
    FunctionGroups groups;
    for (int e = 0; e < after.basis().element_count(); ++e) groups.add(after.basis().shape(e).functions);
    return {after.basis().function_count(), groups};
  }

  void add(int e, const std::vector<FieldPoint>& field) {
    const ElementShape shape = after_.basis().shape(e);
    const Eigen::Matrix3d modulus = after_.continuum().modulus(e);
    const int n = 2 * shape.function_count();
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n, n);
    Eigen::VectorXd load = Eigen::VectorXd::Zero(n);
    Eigen::MatrixXd strain(3, n), moves = Eigen::MatrixXd::Zero(2, n);
    for (const FieldPoint& point : field) {
      const Eigen::Matrix2d& f = point.gradient;
      const Eigen::RowVectorXd values = shape.values(point.start);
      const Eigen::Matrix2Xd g = shape.gradients(point.start);
      for (int a = 0; a < shape.function_count(); ++a)
        for (int i = 0; i < 2; ++i) {
          strain.col(2 * a + i) << f(i, 0) * g(0, a), f(i, 1) * g(1, a), f(i, 0) * g(1, a) + f(i, 1) * g(0, a);
          moves(i, 2 * a + i) = values(a);
        }
      const Eigen::Matrix2d own = f.transpose() * (f - Eigen::Matrix2d::Identity());
      const Point u = point.place - point.start;
      matrix += point.area * (strain.transpose() * modulus * strain + weight_ * moves.transpose() * moves);
      load +=
          point.area * (strain.transpose() * modulus * Eigen::Vector3d(own(0, 0), own(1, 1), own(0, 1) + own(1, 0)) +
                        weight_ * moves.transpose() * Eigen::Vector2d(u.x, u.y));
    }
    system_.add_matrix(shape.functions, matrix);
    system_.add_load(shape.functions, load);
  }

  const CoverScene& after_;
  SparseSystem system_;
  double weight_ = 0;
};

/// Adds turnings that give every body the angular momentum of its points.
Eigen::VectorXd turned_as(std::span<const std::vector<FieldPoint>> fields, const CoverScene& after,
                          const Eigen::VectorXd& d, Eigen::VectorXd v) {
  const std::vector<WholeBody> bodies = after.whole(d, after.momentum(v));
  std::vector<double> missing;
  for (const WholeBody& body : bodies) missing.push_back(-body.resultant[2]);
  for (int e = 0; e < after.basis().element_count(); ++e) {
    const auto body = static_cast<std::size_t>(after.continuum().manifold.elements[static_cast<std::size_t>(e)].body);
    const double density = after.continuum().material(e).density;
    for (const FieldPoint& point : fields[static_cast<std::size_t>(e)])
      missing[body] += density * point.area * cross(point.place - bodies[body].centre, point.velocity);
  }
  for (std::size_t b = 0; b < bodies.size(); ++b)
    v += missing[b] / bodies[b].inertia * after.turning(static_cast<int>(b), d, bodies[b].centre);
  return v;
}

}  // namespace

CarriedCovers carried_covers(std::span<const std::vector<FieldPoint>> fields, const CoverScene& after) {
  CarriedCovers carried;
  const auto projected = [&](Point (*of)(const FieldPoint&)) -> Eigen::VectorXd {
    return after.mass_inverse()->times(loads_of(fields, after, of)).col(0);
  };
  carried.d = Displacements(after).nearest(fields);
  carried.v = projected([](const FieldPoint& point) { return point.velocity; });
  carried.v = turned_as(fields, after, carried.d, std::move(carried.v));
  return carried;
}

std::vector<std::vector<BoxedElement>> boxed_elements(const CoverScene& bodies) {
  const Manifold& manifold = bodies.continuum().manifold;
  std::vector<std::vector<BoxedElement>> all(manifold.body_materials.size());
  for (std::size_t e = 0; e < manifold.elements.size(); ++e)
    all[static_cast<std::size_t>(manifold.elements[e].body)].push_back(
        {box_of(manifold.polygon(manifold.elements[e])), static_cast<int>(e)});
  return all;
}

std::vector<FieldPoint> field_over(const CoverScene& bodies, std::span<const BoxedElement> elements,
                                   std::span<const std::vector<Point>> region, int degree, const Eigen::VectorXd& d,
                                   const Eigen::VectorXd& v) {
  const Manifold& manifold = bodies.continuum().manifold;
  const int own = bodies.basis().degree();
  const Box box = box_of(region);
  std::vector<FieldPoint> field;
  for (const BoxedElement& boxed : elements) {
    if (!overlap(box, boxed.box)) continue;
    const auto loops = manifold.polygon(manifold.elements[static_cast<std::size_t>(boxed.element)]);
    const ElementShape shape = bodies.basis().shape(boxed.element);
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

bool is_same_mesh(const Manifold& a, const Manifold& b) {
  return a.mesh.nodes == b.mesh.nodes && a.mesh.triangles == b.mesh.triangles;
}

CarriedCovers carried_covers(const CoverScene& before, const Eigen::VectorXd& d, const Eigen::VectorXd& v,
                             std::span<const int> parents, const CoverScene& after) {
  const Carrying carrying(before, parents, after);
  CarriedCovers carried;
  carried.d = carrying.projected(d);
  carried.v = carrying.with_angular_momentum(d, v, carried.d, carrying.projected(v));
  return carried;
}

}  // namespace keyblock
