// Covers gather the gradients of their elements; then point by point; see cover_yield.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "terms/cover_yield.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <map>

#include "geometry/quadrature.hpp"
#include "material/elastic_law.hpp"
#include "material/material_stress.hpp"
#include "terms/green_strain.hpp"

namespace keyblock {
namespace {

Eigen::Vector4d vector_of(const Stress& s) {
  return {s.xx, s.yy, s.xy, s.zz};
}

/// What the star of a cover adds up to.
struct Gathered {
  std::map<int, Eigen::Vector2d> gradients;  // ∫ λ ∇N of each function
  double area = 0;                           // ∫ λ
  Eigen::Vector4d initial = Eigen::Vector4d::Zero();
  std::size_t law = 0;
};

}  // namespace

CoverYield::CoverYield(const Continuum& continuum, const CoverBasis& basis)
    : basis_(basis), plane_(continuum.plane), averages_(basis.functions() == CoverFunctions::constant) {
  for (const BlockMaterial& material : continuum.materials) elastic_.push_back(modulus_of(material, plane_));
  for (const BlockMaterial& material : continuum.materials)
    laws_.push_back(
        {material.youngs_modulus, material.poissons_ratio, material.strength ? *material.strength : Strength{}});
  of_element_.resize(static_cast<std::size_t>(basis.element_count()));
  averages_ ? add_averaged(continuum, basis) : add_of_elements(continuum, basis);
}

void CoverYield::add_averaged(const Continuum& continuum, const CoverBasis& basis) {
  std::map<int, Gathered> covers;
  for (int e = 0; e < basis.element_count(); ++e) {
    if (!continuum.material(e).strength) continue;
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
    point.area = sum.area;
    point.law = sum.law;
    point.initial = sum.initial / sum.area;
    point.gradients.resize(2, static_cast<Eigen::Index>(sum.gradients.size()));
    for (const auto& [function, gradient] : sum.gradients) {
      point.gradients.col(static_cast<Eigen::Index>(point.functions.size())) = gradient / sum.area;
      point.functions.push_back(function);
    }
  }
  for (int e = 0; e < basis.element_count(); ++e)
    if (continuum.material(e).strength)
      for (const int function : basis.shape(e).functions)
        of_element_[static_cast<std::size_t>(e)].push_back(place.at(function));
}

void CoverYield::add_of_elements(const Continuum& continuum, const CoverBasis& basis) {
  for (int e = 0; e < basis.element_count(); ++e) {
    const BlockMaterial& material = continuum.material(e);
    if (!material.strength) continue;
    const ElementShape shape = basis.shape(e);
    const auto loops = continuum.manifold.polygon(continuum.manifold.elements[static_cast<std::size_t>(e)]);
    for (const AreaPoint& at : polygon_rule(loops, 2 * (shape.degree - 1))) {
      of_element_[static_cast<std::size_t>(e)].push_back(points_.size());
      YieldPoint& point = points_.emplace_back();
      point.area = at.weight;
      point.law = static_cast<std::size_t>(&material - continuum.materials.data());
      point.initial = vector_of(continuum.initial_stress_at(e, at.at));
      point.gradients = shape.gradients(at.at);
      point.functions.assign(shape.functions.begin(), shape.functions.end());
    }
  }
}

void CoverYield::add_groups(FunctionGroups& groups) const {
  for (const YieldPoint& point : points_) groups.add(point.functions);
}

YieldStates CoverYield::start() const {
  YieldStates states(points_.size());
  for (std::size_t i = 0; i < points_.size(); ++i)
    states[i].elastic = laws_[points_[i].law].elastic_strain(points_[i].initial);
  return states;
}

Eigen::Matrix2d CoverYield::displacement_gradient(const YieldPoint& point, const Eigen::VectorXd& d) const {
  Eigen::Matrix2d h = Eigen::Matrix2d::Zero();
  for (std::size_t a = 0; a < point.functions.size(); ++a)
    h += d.segment<2>(2 * point.functions[a]) * point.gradients.col(static_cast<Eigen::Index>(a)).transpose();
  return h;
}

Response CoverYield::respond_at(const YieldPoint& point, const Eigen::Vector3d& change,
                                const YieldState& before) const {
  const YieldLaw& law = laws_[point.law];
  const double size = std::sqrt(point.area);
  if (plane_ == Plane::stress) return respond_plane_stress(law, change, before, size);
  return respond(law, {change(0), change(1), change(2), 0}, before, size);
}

CoverYield::Answer CoverYield::answer(const Eigen::VectorXd& d0, const YieldStates& before,
                                      const Eigen::VectorXd& d1) const {
  Answer answer{Eigen::VectorXd::Zero(d1.size()), YieldStates(points_.size())};
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const YieldPoint& point = points_[i];
    const Eigen::Matrix2d h = displacement_gradient(point, d1);
    if (!((Eigen::Matrix2d::Identity() + h).determinant() > 0)) {
      answer.is_turned_over = true;
      return answer;
    }
    const Eigen::Vector3d green = green_strain(h);
    const Response r =
        respond_at(point, log_strain(green) - log_strain(green_strain(displacement_gradient(point, d0))), before[i]);
    answer.after[i] = r.after;
    const Eigen::Vector3d second = log_strain_rate(green).transpose() * r.stress.head<3>();
    const Eigen::Matrix2d flux = point.area * (Eigen::Matrix2d::Identity() + h) * stress_tensor(second);
    for (std::size_t a = 0; a < point.functions.size(); ++a)
      answer.force.segment<2>(2 * point.functions[a]) += flux * point.gradients.col(static_cast<Eigen::Index>(a));
  }
  return answer;
}

// Bᵀ (Pᵀ D P + ∂Pᵀ T/∂E) B and ∇N · S ∇N.
Eigen::MatrixXd CoverYield::tangent_at(const YieldPoint& point, const Eigen::Matrix2d& h,
                                       const Response& response) const {
  const Eigen::Vector3d green = green_strain(h);
  const Eigen::Matrix3d rate = log_strain_rate(green);
  const Eigen::Vector3d stress = response.stress.head<3>();
  const Eigen::Matrix3d material =
      rate.transpose() * response.tangent.topLeftCorner<3, 3>() * rate + log_strain_curvature(green, stress);
  const Eigen::Matrix2d f = Eigen::Matrix2d::Identity() + h;
  const auto n = static_cast<Eigen::Index>(point.functions.size());
  Eigen::Matrix3Xd b(3, 2 * n);
  for (Eigen::Index a = 0; a < n; ++a) {
    const Eigen::Vector2d g = point.gradients.col(a);
    for (Eigen::Index k = 0; k < 2; ++k)
      b.col(2 * a + k) << f(k, 0) * g(0), f(k, 1) * g(1), f(k, 0) * g(1) + f(k, 1) * g(0);
  }
  Eigen::MatrixXd tangent = b.transpose() * (material * b);
  const Eigen::Vector3d second = rate.transpose() * stress;
  const Eigen::MatrixXd geometric = point.gradients.transpose() * (stress_tensor(second) * point.gradients);
  for (Eigen::Index a = 0; a < n; ++a)
    for (Eigen::Index c = 0; c < n; ++c) {
      tangent(2 * a, 2 * c) += geometric(a, c);
      tangent(2 * a + 1, 2 * c + 1) += geometric(a, c);
    }
  return point.area * tangent;
}

void CoverYield::add_tangent(const Eigen::VectorXd& d0, const YieldStates& before, const Eigen::VectorXd& d1,
                             double elastic_share, WholeSystem& system) const {
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const YieldPoint& point = points_[i];
    const Eigen::Matrix2d h = displacement_gradient(point, d1);
    const Eigen::Vector3d change =
        log_strain(green_strain(h)) - log_strain(green_strain(displacement_gradient(point, d0)));
    Response response = respond_at(point, change, before[i]);
    if (elastic_share > 0)
      response.tangent.topLeftCorner<3, 3>() =
          (1 - elastic_share) * response.tangent.topLeftCorner<3, 3>() + elastic_share * elastic_[point.law];
    system.add_matrix(point.functions, tangent_at(point, h, response));
  }
}

void CoverYield::carry(int element, const CoverYield& before, int was, const YieldStates& from,
                       YieldStates& states) const {
  const std::vector<std::size_t>& to = of_element_[static_cast<std::size_t>(element)];
  const std::vector<std::size_t>& of = before.of_element_[static_cast<std::size_t>(was)];
  for (std::size_t i = 0; i < std::min(to.size(), of.size()); ++i) states[to[i]] = from[of[i]];
}

std::vector<CoverYield::Share> CoverYield::shares(int element, Point at_start) const {
  const std::vector<std::size_t>& own = of_element_[static_cast<std::size_t>(element)];
  std::vector<Share> shares;
  if (averages_) {
    const Eigen::RowVectorXd values = basis_.shape(element).values(at_start);
    for (std::size_t i = 0; i < own.size(); ++i) shares.push_back({own[i], values(static_cast<Eigen::Index>(i))});
    return shares;
  }
  double area = 0;
  for (const std::size_t point : own) area += points_[point].area;
  for (const std::size_t point : own) shares.push_back({point, points_[point].area / area});
  return shares;
}

Stress CoverYield::stress(const Eigen::VectorXd& d, const YieldStates& states, int element, Point at_start) const {
  Eigen::Vector4d sum = Eigen::Vector4d::Zero();
  for (const Share& share : shares(element, at_start)) {
    const YieldPoint& point = points_[share.point];
    const Eigen::Vector4d t = laws_[point.law].modulus() * states[share.point].elastic;
    const Eigen::Matrix2d h = displacement_gradient(point, d);
    const Eigen::Matrix2d f = Eigen::Matrix2d::Identity() + h;
    const Eigen::Vector3d second = log_strain_rate(green_strain(h)).transpose() * t.head<3>();
    const Eigen::Matrix2d cauchy = f * stress_tensor(second) * f.transpose() / f.determinant();
    sum += share.weight * Eigen::Vector4d(cauchy(0, 0), cauchy(1, 1), cauchy(0, 1), t(3) / f.determinant());
  }
  return {sum(0), sum(1), sum(2), sum(3)};
}

double CoverYield::greatest_size(std::size_t material) const {
  double area = 0;
  for (const YieldPoint& point : points_)
    if (point.law == material) area = std::max(area, point.area);
  return std::sqrt(area);
}

}  // namespace keyblock
