// Computes the imbalance as the force that would accelerate a block: M times the balanced acceleration of a motion
// without velocity.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/scene/equilibrium.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <utility>

#include "base/listed.hpp"
#include "base/words/plain_number.hpp"
#include "base/worse.hpp"
#include "contact/rows/constraints.hpp"
#include "step/newton/tolerances.hpp"
#include "step/scene/acceleration.hpp"

namespace keyblock {
namespace {

using namespace tolerances;

// Share of the size of a body: supports nearer to each other leave it free to rotate.
constexpr double kApart = 1e-6;

// A body whose supports leave it no rigid motion cannot leave. If it is soft, its equilibrium may be farther from its
// place than its own size.
bool is_held(const StandardScene& scene, ElementIndex e) {
  if (scene.groups.of(e).is_supported(e)) return true;
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();  // of the squares of all rows, by two translations and a rotation
  for (const HeldPair& pair : scene.held) {
    if (!scene.groups.are_one_body(pair.element, e)) continue;
    for (std::size_t k = 0; k < 2; ++k) {
      const Point arm = (1 / scene.bodies()[e].size) * (pair.starts[k] - scene.reference.centroids[e]);
      const Point d = pair.directions[k];
      const Eigen::Vector3d row(d.x, d.y, cross(arm, d));
      sum += row * row.transpose();
    }
  }
  return sum.determinant() > kApart * kApart * std::pow(sum.trace(), 3);
}

// Returns the distance of each fixed point from its target.
std::vector<double> ways_left(const StandardScene& scene, const Motion& motion, double time) {
  const Eigen::VectorXd all = offsets(scene.model, scene.reference, motion.q, scene.held, time);
  std::vector<double> ways;
  for (Eigen::Index i = 0; i < all.size(); i += 2) ways.push_back(all.segment<2>(i).norm());
  return ways;
}

std::vector<int> numbers_of(const StandardScene& scene, const std::vector<ElementIndex>& blocks) {
  std::vector<int> numbers;
  for (const ElementIndex e : blocks) numbers.push_back(scene.model.number_of(e));
  return numbers;
}

std::string_view noun_of(const StandardScene& scene, const std::vector<ElementIndex>& parts) {
  const auto is_block = [&](ElementIndex e) { return scene.groups.of(e).shared_basis() == nullptr; };
  return std::ranges::any_of(parts, is_block) ? "block" : "element";
}

// Slivers are the most frequent blocks without equilibrium.
ElementIndex smallest_of(const StandardScene& scene, const std::vector<ElementIndex>& blocks) {
  return *std::ranges::min_element(blocks, {}, [&](ElementIndex e) { return scene.reference.moments[e].area; });
}

std::string smallest_in_words(const StandardScene& scene, const std::vector<ElementIndex>& blocks) {
  const ElementIndex smallest = smallest_of(scene, blocks);
  const double area = scene.reference.moments[smallest].area;
  const Point at = scene.reference.centroids[smallest];
  const std::string which =
      blocks.size() > 1 ? fmt::format("the smallest, {}, ", scene.model.number_of(smallest)) : std::string();
  return fmt::format("{}at {}, {}; area {}, {:.3g} % of the mean", which, plain(at.x), plain(at.y), plain(area, 3),
                     100 * area / scene.model.mean_area);
}

// The round-off of contact forces grows with the force of the initial stress. A larger part of it would hide the weight
// of small blocks.
constexpr double kOfStress = 1e-2;

}  // namespace

double largest_load(const StandardScene& scene, const UnknownsTable& loads) {
  double largest = 0;
  for (const auto& group : scene.groups) largest = std::max(largest, group->largest_load(loads));
  return largest;
}

bool is_stressed(const StandardScene& scene, UnknownsTable q) {
  return reference_of_stress(scene, std::move(q)) > 0;
}

double reference_of_stress(const StandardScene& scene, UnknownsTable q) {
  q.set_zero();
  return kOfStress * largest_load(scene, q);
}

double reference_of_stress(const Body& body) {
  return kOfStress * largest_load(body, {});
}

double driving_force(const StandardScene& scene, const Motion& motion, double time, double dt) {
  const std::vector<double> ways = ways_left(scene, motion, time);
  double largest = 0;
  for (std::size_t i = 0; i < ways.size(); ++i) {
    const ElementIndex e = scene.held[i].element;
    if (ways[i] > of_rest::kInPlace * scene.bodies()[e].size)
      largest = std::max(largest, scene.groups.of(e).mass_of(e) * ways[i] / (dt * dt));
  }
  return largest;
}

Balance balance_of(const StandardScene& scene, const Motion& motion, double time, double least_load) {
  Motion still = motion;
  still.v.set_zero();
  const UnknownsTable a = balanced_acceleration(scene, still, time);
  const double load = std::max(least_load, largest_load(scene, loads_at(scene, motion.q, time)));
  Balance balance;
  balance.holds_points = driving_force(scene, motion, time, 1) == 0;
  for (const auto& group : scene.groups)
    group->look_at_forces(a, [&](ElementIndex e, double force) {
      if (!(force <= of_rest::kBalanced * load)) balance.blocks.push_back(e);
      if (load > 0) balance.share = worse(balance.share, force / load);
    });
  return balance;
}

Travel travel_of(const StandardScene& scene, const UnknownsTable& from, const UnknownsTable& to, double far) {
  const auto before = vertices_at(scene.model, scene.reference, from);
  const auto after = vertices_at(scene.model, scene.reference, to);
  Travel travel;
  for (ElementIndex e : indices(scene.bodies())) {
    double way = 0;
    for (VertexIndex v : scene.model.elements[e].vertices()) way = worse(way, distance(before[v], after[v]));
    travel.share = worse(travel.share, way / scene.bodies()[e].size);
    if (!(way <= far * scene.bodies()[e].size) && !is_held(scene, e)) travel.far.push_back(e);
  }
  return travel;
}

std::string part_name(const StandardScene& scene, ElementIndex e) {
  return fmt::format("{} {}", noun_of(scene, {e}), scene.model.number_of(e));
}

std::string in_words(const StandardScene& scene, const std::vector<ElementIndex>& blocks) {
  return fmt::format("{}{} {} ({})", noun_of(scene, blocks), blocks.size() > 1 ? "s" : "",
                     listed(numbers_of(scene, blocks)), smallest_in_words(scene, blocks));
}

Finding no_equilibrium(const StandardScene& scene, const std::vector<ElementIndex>& blocks) {
  const ElementIndex smallest = smallest_of(scene, blocks);
  const double area = scene.reference.moments[smallest].area;
  const Point at = scene.reference.centroids[smallest];
  Facts facts{{{"smallest", scene.model.number_of(smallest)},
               {"area", area},
               {"percent_of_mean", 100 * area / scene.model.mean_area}},
              {{"noun", std::string(noun_of(scene, blocks))}},
              numbers_of(scene, blocks),
              {{{at.x, at.y}}}};
  if (std::ranges::any_of(blocks, [&](ElementIndex e) { return scene.groups.of(e).needs_fixed_points(); }))
    facts.numbers.emplace_back("least_fixed_points", 2);
  return {blocks.size() > 1 ? "no_equilibrium:several" : "no_equilibrium", std::move(facts)};
}

}  // namespace keyblock
