// Fields transferred to bodies on other covers: polynomials of their order exactly, momentum of any.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/groups/carry_covers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include "geometry/polygon.hpp"
#include "tests/support/continuum_scenes.hpp"
#include "tests/support/covers_alone.hpp"

namespace keyblock::carry_covers_test {
namespace {

constexpr double kDensity = 2500;
// Quadratic functions depend on each other, so that little mass fixes those of the smallest elements.
constexpr double kOfVelocity = 1e-6;
const std::vector<Point> kSquare = rectangle_corners({-1, -1}, {1, 1});
const MeshSetting kCoarse{0.7, 0.3}, kFine{0.45, -0.2, {0.11, 0.05}};

/// A square on covers of a mesh rotated against it.
struct Covers {
  Scene scene;
  CoverScene bodies;

  Covers(const MeshSetting& mesh, CoverFunctions functions)
      : scene(support::scene_of_covers(continuum_of(mesh, functions))), bodies(scene.model, scene.settings) {}

  static Continuum continuum_of(const MeshSetting& mesh, CoverFunctions functions) {
    Continuum continuum;
    continuum.manifold = cut_body({kSquare}, mesh);
    continuum.materials = {elastic_material(1e6, 0.25)};
    continuum.materials[0].density = kDensity;
    continuum.functions = functions;
    return continuum;
  }

  const Manifold& manifold() const { return bodies.continuum().manifold; }
  std::vector<std::vector<Point>> polygon(int e) const {
    return manifold().polygon(manifold().elements[static_cast<std::size_t>(e)]);
  }
  std::vector<Point> outline(int e) const { return polygon(e).front(); }
  int count() const { return bodies.basis().element_count(); }
  Eigen::VectorXd zeros() const { return Eigen::VectorXd::Zero(2 * bodies.basis().function_count()); }
};

/// Displacement with its gradient, and velocity.
struct Field {
  std::function<Point(Point)> moved;
  std::function<Eigen::Matrix2d(Point)> gradient;
  std::function<Point(Point)> velocity;
};

/// Polynomials of an order up to three.
Field polynomial(int order) {
  const double square = order > 1 ? 0.03 : 0, cube = order > 2 ? 0.02 : 0;
  const auto moved = [=](Point p) {
    return Point{0.1 + 0.05 * p.x - 0.2 * p.y + square * p.x * p.y + cube * p.x * p.x * p.y,
                 -0.3 + 0.2 * p.x + 0.02 * p.y - square * p.x * p.x + cube * p.y * p.y * p.y};
  };
  const auto gradient = [=](Point p) {
    Eigen::Matrix2d g;
    g << 0.05 + square * p.y + 2 * cube * p.x * p.y, -0.2 + square * p.x + cube * p.x * p.x,  //
        0.2 - 2 * square * p.x, 0.02 + 3 * cube * p.y * p.y;
    return g;
  };
  const auto velocity = [=](Point p) {
    return Point{1 - 3 * p.y + 10 * square * p.y * p.y - 10 * cube * p.x * p.x * p.x,
                 2 + 2 * p.x + p.y + 10 * square * p.x * p.y + 10 * cube * p.y * p.x * p.x};
  };
  return {moved, gradient, velocity};
}

/// The part that no polynomial holds.
Field waves() {
  return {[](Point p) {
            return Point{0.05 * std::sin(3 * p.x + p.y), 0.04 * std::cos(4 * p.y)};
          },
          [](Point p) {
            Eigen::Matrix2d g;
            g << 0.15 * std::cos(3 * p.x + p.y), 0.05 * std::cos(3 * p.x + p.y), 0, -0.16 * std::sin(4 * p.y);
            return g;
          },
          [](Point p) {
            return Point{std::exp(p.x) - 3 * p.y, std::sin(5 * p.x * p.y) + 2 * p.x};
          }};
}

/// The field by points over these elements.
std::vector<std::vector<FieldPoint>> points_of(const Field& field, const Covers& covers, const std::vector<int>& of) {
  std::vector<std::vector<FieldPoint>> fields;
  for (const int e : of) {
    std::vector<FieldPoint>& points = fields.emplace_back();
    const ElementShape shape = covers.bodies.basis().shape(e);
    for (const AreaPoint& p : area_rule(covers.manifold(), e, shape, 2 * shape.degree))
      points.push_back({p.at, p.weight, p.at + field.moved(p.at), field.velocity(p.at),
                        Eigen::Matrix2d::Identity() + field.gradient(p.at)});
  }
  return fields;
}

ChangedPart everything(const Covers& covers) {
  return changed_part(covers.bodies, std::vector<char>(static_cast<std::size_t>(covers.count()), 0));
}

Point value_at(const Covers& covers, int e, Point at, const Eigen::VectorXd& unknowns) {
  const ElementShape shape = covers.bodies.basis().shape(e);
  Eigen::VectorXd own(2 * shape.function_count());
  for (int a = 0; a < shape.function_count(); ++a)
    own.segment<2>(2 * a) = unknowns.segment<2>(2 * shape.functions[static_cast<std::size_t>(a)]);
  const Eigen::Vector2d u = shape.displacement(at) * own;
  return {u[0], u[1]};
}

/// The largest difference from the field at the corners of all elements: of displacement and of velocity.
std::pair<double, double> errors(const Covers& covers, const CarriedCovers& carried, const Field& field) {
  double of_d = 0, of_v = 0;
  for (int e = 0; e < covers.count(); ++e)
    for (const Point corner : covers.outline(e)) {
      of_d = std::max(of_d, distance(value_at(covers, e, corner, carried.d), field.moved(corner)));
      of_v = std::max(of_v, distance(value_at(covers, e, corner, carried.v), field.velocity(corner)));
    }
  return {of_d, of_v};
}

/// Momentum, and angular momentum about the origin.
Eigen::Vector3d momenta(const Covers& covers, const CarriedCovers& carried) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const WholeBody& body : covers.bodies.whole(carried.d, covers.bodies.momentum(carried.v))) {
    sum += body.resultant;
    sum[2] += cross(body.centre, {body.resultant[0], body.resultant[1]});
  }
  return sum;
}

Eigen::Vector3d momenta(const std::vector<std::vector<FieldPoint>>& fields) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const std::vector<FieldPoint>& field : fields)
    for (const FieldPoint& p : field)
      sum += kDensity * p.area * Eigen::Vector3d(p.velocity.x, p.velocity.y, cross(p.place, p.velocity));
  return sum;
}

int order_of(CoverFunctions functions) {
  if (functions == CoverFunctions::quadratic) return 3;
  return functions == CoverFunctions::linear ? 2 : 1;
}

}  // namespace

TEST(CarryCovers, a_polynomial_of_the_order_of_the_covers_is_carried_exactly) {
  for (const CoverFunctions functions : kAllCoverFunctions) {
    const Covers covers(kFine, functions);
    const Field field = polynomial(order_of(functions));
    const ChangedPart part = everything(covers);
    const auto fields = points_of(field, covers, part.elements);
    const CarriedCovers carried = carried_covers({covers.zeros(), covers.zeros()}, part, fields, covers.bodies);
    const auto [of_d, of_v] = errors(covers, carried, field);
    EXPECT_LT(of_d, 1e-9) << name_of(functions);
    EXPECT_LT(of_v, kOfVelocity) << name_of(functions);
  }
}

// Onto one mesh, from there to another and back, without loss.
TEST(CarryCovers, a_polynomial_survives_the_way_from_mesh_to_mesh) {
  for (const CoverFunctions functions : kAllCoverFunctions) {
    const Field field = polynomial(order_of(functions));
    auto was = std::make_unique<Covers>(kCoarse, functions);
    CarriedCovers carried = carried_covers({was->zeros(), was->zeros()}, everything(*was),
                                           points_of(field, *was, everything(*was).elements), was->bodies);
    for (const MeshSetting& mesh : {kFine, kCoarse}) {
      auto is = std::make_unique<Covers>(mesh, functions);
      const ChangedPart part = everything(*is);
      std::vector<std::vector<FieldPoint>> fields;
      const std::vector<BoxedElements> elements = boxed_elements(was->bodies);
      for (const int e : part.elements)
        fields.push_back(
            field_over(was->bodies, elements[0], is->polygon(e), is->bodies.basis().degree(), carried.d, carried.v));
      carried = carried_covers({is->zeros(), is->zeros()}, part, fields, is->bodies);
      was = std::move(is);
      const auto [of_d, of_v] = errors(*was, carried, field);
      EXPECT_LT(of_d, 1e-8) << name_of(functions);
      EXPECT_LT(of_v, kOfVelocity) << name_of(functions);
    }
  }
}

TEST(CarryCovers, momentum_and_angular_momentum_of_any_field_are_kept) {
  for (const CoverFunctions functions : kAllCoverFunctions) {
    const Covers covers(kCoarse, functions);
    const ChangedPart part = everything(covers);
    const auto fields = points_of(waves(), covers, part.elements);
    const CarriedCovers carried = carried_covers({covers.zeros(), covers.zeros()}, part, fields, covers.bodies);
    const Eigen::Vector3d was = momenta(fields), is = momenta(covers, carried);
    EXPECT_GT(was.norm(), 1000);
    EXPECT_LT((is - was).norm(), 1e-12 * was.norm()) << name_of(functions);
    EXPECT_GT(errors(covers, carried, waves()).second, 1e-3) << "this field is not in their span";
  }
}

// Elements about the centre are new and have no memory; the rest keeps its unknowns.
TEST(CarryCovers, what_is_kept_stays_to_the_bit_and_what_is_new_is_filled_in) {
  const Covers covers(MeshSetting{0.15, 0.3}, CoverFunctions::constant);
  const Manifold& manifold = covers.manifold();
  const Field field = polynomial(1);
  std::vector<char> kept;
  for (int e = 0; e < covers.count(); ++e) kept.push_back(length(centroid(covers.outline(e))) > 0.2 ? 1 : 0);
  CarriedCovers start{covers.zeros(), covers.zeros()};
  for (std::size_t c = 0; c < manifold.covers.size(); ++c) {
    const PhysicalCover& cover = manifold.covers[c];
    const Point node = manifold.mesh.nodes[static_cast<std::size_t>(cover.node)];
    const bool is_new = std::ranges::none_of(manifold.elements_of(cover),
                                             [&](int e) { return kept[static_cast<std::size_t>(e)] == 1; });
    const Point d = is_new ? Point{} : field.moved(node), v = is_new ? Point{} : field.velocity(node);
    start.d.segment<2>(static_cast<Eigen::Index>(2 * c)) << d.x, d.y;
    start.v.segment<2>(static_cast<Eigen::Index>(2 * c)) << v.x, v.y;
  }
  EXPECT_GT(errors(covers, start, field).first, 0.1);
  const ChangedPart part = changed_part(covers.bodies, kept);
  const auto fields = points_of(field, covers, part.elements);
  const CarriedCovers carried = carried_covers(start, part, fields, covers.bodies);
  const auto [of_d, of_v] = errors(covers, carried, field);
  EXPECT_LT(of_d, 1e-10);
  EXPECT_LT(of_v, 1e-10);
  int same = 0;
  for (std::size_t f = 0; f < part.place.size(); ++f) {
    if (part.place[f] >= 0) continue;
    ++same;
    const auto row = static_cast<Eigen::Index>(2 * f);
    EXPECT_EQ(carried.d.segment<2>(row), start.d.segment<2>(row));
  }
  EXPECT_GT(same, 20);
}

TEST(CarryCovers, the_part_that_changes_lies_about_what_is_new) {
  const Covers covers(MeshSetting{0.15, 0.3}, CoverFunctions::constant);
  const auto count = static_cast<std::size_t>(covers.count());
  EXPECT_EQ(everything(covers).elements.size(), count);
  const ChangedPart none = changed_part(covers.bodies, std::vector<char>(count, 1));
  EXPECT_TRUE(none.elements.empty());
  EXPECT_EQ(none.function_count, 0);
  std::vector<char> kept(count, 1);
  kept[count / 2] = 0;
  const ChangedPart part = changed_part(covers.bodies, kept);
  const Point middle = centroid(covers.outline(static_cast<int>(count / 2)));
  std::set<int> places;
  for (const int place : part.place)
    if (place >= 0) places.insert(place);
  EXPECT_EQ(places.size(), static_cast<std::size_t>(part.function_count));
  EXPECT_EQ(*places.rbegin(), part.function_count - 1);
  EXPECT_TRUE(std::ranges::is_sorted(part.elements));
  EXPECT_EQ(std::ranges::count(part.changed, 1), 1);
  for (int e = 0; e < covers.count(); ++e) {
    const bool is_in = std::ranges::find(part.elements, e) != part.elements.end();
    const double away = distance(centroid(covers.outline(e)), middle);
    EXPECT_TRUE(is_in || away > 2 * 0.15) << "two rings, each of a triangle";
    EXPECT_TRUE(!is_in || away < 5 * 0.15);
  }
}

TEST(CarryCovers, where_nothing_changed_nothing_is_carried) {
  const Covers covers(kCoarse, CoverFunctions::linear);
  const ChangedPart none = changed_part(covers.bodies, std::vector<char>(static_cast<std::size_t>(covers.count()), 1));
  const Eigen::VectorXd d = Eigen::VectorXd::LinSpaced(covers.zeros().size(), 0, 1);
  const CarriedCovers carried = carried_covers({d, -d}, none, {}, covers.bodies);
  EXPECT_EQ(carried.d, d);
  EXPECT_EQ(carried.v, -d);
}

// A region across many elements, with a hole, partly outside the body.
TEST(CarryCovers, a_field_over_a_region_covers_what_lies_in_the_body) {
  const Covers covers(kFine, CoverFunctions::constant);
  const Field field = polynomial(1);
  const ChangedPart part = everything(covers);
  const CarriedCovers carried =
      carried_covers({covers.zeros(), covers.zeros()}, part, points_of(field, covers, part.elements), covers.bodies);
  std::vector<Point> hole = rectangle_corners({-0.2, -0.3}, {0.1, 0.2});
  std::ranges::reverse(hole);
  const std::vector<std::vector<Point>> region{rectangle_corners({-0.6, -0.7}, {1.5, 0.9}), hole};
  const auto points = field_over(covers.bodies, boxed_elements(covers.bodies)[0], region, 1, carried.d, carried.v);
  double area = 0, moment = 0;
  for (const FieldPoint& p : points) {
    area += p.area;
    moment += p.area * p.start.x * p.start.x;
    EXPECT_LT(distance(p.place, p.start + field.moved(p.start)), 1e-9);
    EXPECT_LT(distance(p.velocity, field.velocity(p.start)), 1e-9);
    EXPECT_LT((p.gradient - Eigen::Matrix2d::Identity() - field.gradient(p.start)).norm(), 1e-8);
  }
  EXPECT_NEAR(area, 1.6 * 1.6 - 0.3 * 0.5, 1e-12);
  EXPECT_NEAR(moment, 1.6 * (1 + 0.216) / 3 - 0.5 * (0.001 + 0.008) / 3, 1e-12);
}

TEST(CarryCovers, boxes_are_found_as_by_looking_at_all) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> at(0, 10), size(0, 1.5);
  const auto box = [&] {
    Box made;
    const Point low{at(random), at(random)};
    made.add(low);
    made.add(low + Point{size(random), size(random)});
    return made;
  };
  std::vector<BoxedElement> all;
  for (int i = 0; i < 100; ++i) all.push_back({box(), i});
  const BoxedElements boxed(all);
  std::size_t found = 0;
  for (int i = 0; i < 200; ++i) {
    const Box wanted = box();
    std::vector<int> expected;
    for (const BoxedElement& one : all)
      if (one.box.low.x < wanted.high.x && wanted.low.x < one.box.high.x && one.box.low.y < wanted.high.y &&
          wanted.low.y < one.box.high.y)
        expected.push_back(one.element);
    EXPECT_EQ(boxed.overlapping(wanted), expected);
    found += expected.size();
  }
  EXPECT_GT(found, 100U);
  EXPECT_TRUE(BoxedElements().overlapping(box()).empty());
}

}  // namespace keyblock::carry_covers_test
