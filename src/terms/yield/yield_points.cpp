// Gathers gradients of elements at covers; see yield_points.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "terms/yield/yield_points.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "geometry/polygon.hpp"
#include "geometry/quadrature.hpp"
#include "material/elastic_law.hpp"
#include "material/material_stress.hpp"
#include "material/mean_memory.hpp"

namespace keyblock {
namespace {

Eigen::Vector4d vector_of(const Stress& s) {
  return {s.xx, s.yy, s.xy, s.zz};
}

/// Sums over the star of a cover.
struct Gathered {
  std::map<int, Eigen::Vector2d> gradients;           // ∫ λ ∇N per function
  double area = 0;                                    // ∫ λ
  Eigen::Vector4d initial = Eigen::Vector4d::Zero();  // stress
  std::size_t law = 0;
  int element = 0;
};

constexpr double kRounding = 1e-9;  // per weight; weights sum to 1
// Share of its triangle below which a piece has a point of its own. Averages over covers see only the square of its
// area, so that forces on it would move it too far. The corner of Cook's membrane went 8 to 22 % too far on rotated
// meshes.
constexpr double kSmallPiece = 0.2;

bool averages_miss(const Manifold& manifold, int e) {
  const ManifoldElement& element = manifold.elements[static_cast<std::size_t>(e)];
  double own = 0;
  for (const std::vector<Point>& loop : manifold.polygon(element)) own += area(loop);
  return own < kSmallPiece * area(manifold.triangle(element));
}

}  // namespace

YieldPoints::YieldPoints(const Continuum& continuum, const CoverBasis& basis)
    : basis_(basis), plane_(continuum.plane), averages_(basis.functions() == CoverFunctions::constant) {
  for (const BlockMaterial& material : continuum.materials) elastic_.push_back(modulus_of(material, plane_));
  for (const BlockMaterial& material : continuum.materials)
    laws_.push_back(std::make_shared<const YieldLaw>(yield_law(material)));
  of_element_.resize(static_cast<std::size_t>(basis.element_count()));
  has_own_.resize(of_element_.size());
  averages_ ? add_averaged(continuum, basis) : add_of_elements(continuum, basis);
}

void YieldPoints::add_averaged(const Continuum& continuum, const CoverBasis& basis) {
  std::map<int, Gathered> covers;
  for (int e = 0; e < basis.element_count(); ++e) {
    if (!continuum.material(e).is_nonlinear()) continue;
    if (averages_miss(continuum.manifold, e)) {
      add_own(continuum, basis, e);
      has_own_[static_cast<std::size_t>(e)] = true;
      continue;
    }
    const ElementShape shape = basis.shape(e);
    const auto loops = continuum.manifold.polygon(continuum.manifold.elements[static_cast<std::size_t>(e)]);
    for (const AreaPoint& at : polygon_rule(loops, 2)) {
      const Eigen::RowVectorXd values = shape.values(at.at);
      const Eigen::Matrix2Xd gradients = shape.gradients(at.at);
      const Eigen::Vector4d initial = vector_of(continuum.initial_stress_at(e, at.at));
      for (Eigen::Index i = 0; i < values.size(); ++i) {
        Gathered& cover = covers[shape.functions[static_cast<std::size_t>(i)]];
        const double weight = at.weight * values(i);
        cover.law = static_cast<std::size_t>(&continuum.material(e) - continuum.materials.data());
        cover.element = e;
        cover.area += weight;
        cover.initial += weight * initial;
        for (Eigen::Index a = 0; a < values.size(); ++a) {
          Eigen::Vector2d& sum =
              cover.gradients.try_emplace(shape.functions[static_cast<std::size_t>(a)], Eigen::Vector2d::Zero())
                  .first->second;
          sum += weight * gradients.col(a);
        }
      }
    }
  }
  std::map<int, std::size_t> place;
  for (const auto& [cover, sum] : covers) {
    place[cover] = points_.size();
    YieldPoint& point = points_.emplace_back();
    point.law = sum.law;
    point.element = sum.element;
    const std::shared_ptr<const YieldLaw>& law = laws_[point.law];
    point.rock = {law, plane_, sum.area, law->elastic_strain(sum.initial / sum.area)};
    point.gradients.resize(2, static_cast<Eigen::Index>(sum.gradients.size()));
    for (const auto& [function, gradient] : sum.gradients) {
      point.gradients.col(static_cast<Eigen::Index>(point.functions.size())) = gradient / sum.area;
      point.functions.push_back(function);
    }
  }
  for (int e = 0; e < basis.element_count(); ++e)
    if (continuum.material(e).is_nonlinear() && !has_own_[static_cast<std::size_t>(e)])
      for (const int function : basis.shape(e).functions)
        of_element_[static_cast<std::size_t>(e)].push_back(place.at(function));
}

void YieldPoints::add_own(const Continuum& continuum, const CoverBasis& basis, int e) {
  const BlockMaterial& material = continuum.material(e);
  const ElementShape shape = basis.shape(e);
  const auto loops = continuum.manifold.polygon(continuum.manifold.elements[static_cast<std::size_t>(e)]);
  for (const AreaPoint& at : polygon_rule(loops, 2 * (shape.degree - 1))) {
    of_element_[static_cast<std::size_t>(e)].push_back(points_.size());
    YieldPoint& point = points_.emplace_back();
    point.law = static_cast<std::size_t>(&material - continuum.materials.data());
    point.element = e;
    const std::shared_ptr<const YieldLaw>& law = laws_[point.law];
    point.rock = {law, plane_, at.weight, law->elastic_strain(vector_of(continuum.initial_stress_at(e, at.at)))};
    point.gradients = shape.gradients(at.at);
    point.functions.assign(shape.functions.begin(), shape.functions.end());
  }
}

void YieldPoints::add_of_elements(const Continuum& continuum, const CoverBasis& basis) {
  for (int e = 0; e < basis.element_count(); ++e)
    if (continuum.material(e).is_nonlinear()) add_own(continuum, basis, e);
}

void YieldPoints::add_groups(FunctionGroups& groups) const {
  for (const YieldPoint& point : points_) groups.add(point.functions);
}

std::set<int> YieldPoints::functions_of_whole_tangents() const {
  std::set<int> functions;
  for (const YieldPoint& point : points_)
    if (!point.rock.law->has_symmetric_tangent()) functions.insert(point.functions.begin(), point.functions.end());
  return functions;
}

YieldStates YieldPoints::start() const {
  YieldStates states(points_.size());
  for (std::size_t i = 0; i < points_.size(); ++i) states[i].elastic = points_[i].rock.initial;
  return states;
}

void YieldPoints::carry(int element, const YieldPoints& before, int was, const YieldStates& from,
                        YieldStates& states) const {
  const std::vector<std::size_t>& to = of_element_[static_cast<std::size_t>(element)];
  const std::vector<std::size_t>& of = before.of_element_[static_cast<std::size_t>(was)];
  for (std::size_t i = 0; i < std::min(to.size(), of.size()); ++i) states[to[i]] = from[of[i]];
}

YieldStates YieldPoints::gathered(std::span<const std::vector<Remembered>> of_elements) const {
  std::vector<MeanMemory> means(points_.size());
  for (std::size_t e = 0; e < of_elements.size(); ++e)
    for (const Remembered& part : of_elements[e])
      for (const Share& share : shares(static_cast<int>(e), part.at))
        means[share.point].add(share.weight * part.area, part.memory);
  YieldStates states = start();
  for (std::size_t i = 0; i < points_.size(); ++i) {
    if (!(means[i].weight() > 0)) continue;
    const Eigen::Vector4d elastic = states[i].elastic;
    states[i] = means[i].over(means[i].weight());
    states[i].elastic = elastic;
  }
  return states;
}

YieldState YieldPoints::memory(const YieldStates& states, int element, Point at_start) const {
  MeanMemory mean;
  for (const Share& share : shares(element, at_start)) mean.add(share.weight, states[share.point]);
  return mean.over(1);
}

PlasticState YieldPoints::plastic_state(const YieldStates& states, int element, Point at_start, double angle) const {
  PlasticState found = keyblock::plastic_state(memory(states, element, at_start), angle);
  double yielded = 0;
  for (const Share& share : shares(element, at_start))
    if (has_yielded(states[share.point])) yielded += share.weight;
  found.has_yielded = yielded > 0.5 - kRounding;
  return found;
}

void YieldPoints::add_totals(const YieldStates& states, PlasticTotals& totals) const {
  for (std::size_t i = 0; i < points_.size(); ++i)
    if (points_[i].rock.law->may_yield) totals.add(points_[i].rock.area, states[i]);
}

std::vector<YieldPoints::Share> YieldPoints::shares(int element, Point at_start) const {
  const std::vector<std::size_t>& own = of_element_[static_cast<std::size_t>(element)];
  std::vector<Share> shares;
  if (averages_ && !has_own_[static_cast<std::size_t>(element)]) {
    const Eigen::RowVectorXd values = basis_.shape(element).values(at_start);
    for (std::size_t i = 0; i < own.size(); ++i) shares.push_back({own[i], values(static_cast<Eigen::Index>(i))});
    return shares;
  }
  double area = 0;
  for (const std::size_t point : own) area += points_[point].rock.area;
  for (const std::size_t point : own) shares.push_back({point, points_[point].rock.area / area});
  return shares;
}

std::vector<YieldPoints::Extent> YieldPoints::extents(std::size_t material) const {
  std::vector<Extent> found;
  for (const YieldPoint& point : points_)
    if (point.law == material) found.push_back({std::sqrt(point.rock.area), point.element});
  return found;
}

}  // namespace keyblock
