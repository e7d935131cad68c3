// Covers gather the gradients of their elements; then point by point; see cover_yield.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "terms/cover_yield.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "geometry/quadrature.hpp"
#include "material/elastic_law.hpp"
#include "material/material_stress.hpp"
#include "material/mean_memory.hpp"
#include "terms/green_strain.hpp"

namespace keyblock {
namespace {

Eigen::Vector4d vector_of(const Stress& s) {
  return {s.xx, s.yy, s.xy, s.zz};
}

/// What the star of a cover adds up to.
struct Gathered {
  std::map<int, Eigen::Vector2d> gradients;           // ∫ λ ∇N of each function
  double area = 0;                                    // ∫ λ
  Eigen::Vector4d initial = Eigen::Vector4d::Zero();  // stress
  std::size_t law = 0;
  int element = 0;
};

constexpr double kRounding = 1e-9;  // of weights, which sum to 1

}  // namespace

CoverYield::CoverYield(const Continuum& continuum, const CoverBasis& basis)
    : basis_(basis), plane_(continuum.plane), averages_(basis.functions() == CoverFunctions::constant) {
  for (const BlockMaterial& material : continuum.materials) elastic_.push_back(modulus_of(material, plane_));
  for (const BlockMaterial& material : continuum.materials)
    laws_.push_back(std::make_shared<const YieldLaw>(yield_law(material)));
  of_element_.resize(static_cast<std::size_t>(basis.element_count()));
  averages_ ? add_averaged(continuum, basis) : add_of_elements(continuum, basis);
}

void CoverYield::add_averaged(const Continuum& continuum, const CoverBasis& basis) {
  std::map<int, Gathered> covers;
  for (int e = 0; e < basis.element_count(); ++e) {
    if (!continuum.material(e).is_nonlinear()) continue;
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
    if (continuum.material(e).is_nonlinear())
      for (const int function : basis.shape(e).functions)
        of_element_[static_cast<std::size_t>(e)].push_back(place.at(function));
}

void CoverYield::add_of_elements(const Continuum& continuum, const CoverBasis& basis) {
  for (int e = 0; e < basis.element_count(); ++e) {
    const BlockMaterial& material = continuum.material(e);
    if (!material.is_nonlinear()) continue;
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
}

void CoverYield::add_groups(FunctionGroups& groups) const {
  for (const YieldPoint& point : points_) groups.add(point.functions);
}

YieldStates CoverYield::start() const {
  YieldStates states(points_.size());
  for (std::size_t i = 0; i < points_.size(); ++i) states[i].elastic = points_[i].rock.initial;
  return states;
}

Eigen::Matrix2d CoverYield::displacement_gradient(const YieldPoint& point, const Eigen::VectorXd& d) const {
  Eigen::Matrix2d h = Eigen::Matrix2d::Zero();
  for (std::size_t a = 0; a < point.functions.size(); ++a)
    h += d.segment<2>(2 * point.functions[a]) * point.gradients.col(static_cast<Eigen::Index>(a)).transpose();
  return h;
}

void CoverYield::add_force(const YieldPoint& point, const Eigen::Matrix2d& f, const Eigen::Vector3d& second,
                           Eigen::VectorXd& force) const {
  const Eigen::Matrix2d flux = point.rock.area * f * stress_tensor(second);
  for (std::size_t a = 0; a < point.functions.size(); ++a)
    force.segment<2>(2 * point.functions[a]) += flux * point.gradients.col(static_cast<Eigen::Index>(a));
}

YieldStates CoverYield::after(const Eigen::VectorXd& d, const YieldStates& before) const {
  Answer end = answer(d, before);
  return end.exists ? std::move(end.after) : before;
}

CoverYield::Answer CoverYield::answer(const Eigen::VectorXd& d, const YieldStates& before) const {
  Answer answer{Eigen::VectorXd::Zero(d.size()), YieldStates(points_.size())};
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const YieldPoint& point = points_[i];
    const Eigen::Matrix2d h = displacement_gradient(point, d);
    const Eigen::Matrix2d f = Eigen::Matrix2d::Identity() + h;
    if (!(f.determinant() > 0)) {
      answer.exists = false;
      return answer;
    }
    const Eigen::Vector3d green = green_strain(h);
    const Response r = point.rock.respond(log_strain(green), before[i]);
    if (!r.is_found) {
      answer.exists = false;
      return answer;
    }
    answer.after[i] = r.after;
    add_force(point, f, log_strain_rate(green).transpose() * r.stress.head<3>(), answer.force);
  }
  return answer;
}

// Bᵀ C B and ∇N · S ∇N.
Eigen::MatrixXd CoverYield::tangent_at(const YieldPoint& point, const Eigen::Matrix2d& f,
                                       const Eigen::Matrix3d& stiffness, const Eigen::Vector3d& second) {
  const auto n = static_cast<Eigen::Index>(point.functions.size());
  Eigen::Matrix3Xd b(3, 2 * n);
  for (Eigen::Index a = 0; a < n; ++a) {
    const Eigen::Vector2d g = point.gradients.col(a);
    for (Eigen::Index k = 0; k < 2; ++k)
      b.col(2 * a + k) << f(k, 0) * g(0), f(k, 1) * g(1), f(k, 0) * g(1) + f(k, 1) * g(0);
  }
  Eigen::MatrixXd tangent = b.transpose() * (stiffness * b);
  const Eigen::MatrixXd geometric = point.gradients.transpose() * (stress_tensor(second) * point.gradients);
  for (Eigen::Index a = 0; a < n; ++a)
    for (Eigen::Index c = 0; c < n; ++c) {
      tangent(2 * a, 2 * c) += geometric(a, c);
      tangent(2 * a + 1, 2 * c + 1) += geometric(a, c);
    }
  return point.rock.area * tangent;
}

// C = Pᵀ D P + ∂Pᵀ T/∂E.
void CoverYield::add_tangent(const Eigen::VectorXd& d, const YieldStates& before, double elastic_share,
                             WholeSystem& system) const {
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const YieldPoint& point = points_[i];
    const Eigen::Matrix2d h = displacement_gradient(point, d);
    const Eigen::Vector3d green = green_strain(h);
    const Response response = point.rock.respond(log_strain(green), before[i]);
    const Eigen::Vector3d stress = response.stress.head<3>();
    const Eigen::Matrix3d modulus =
        (1 - elastic_share) * response.tangent.topLeftCorner<3, 3>() + elastic_share * elastic_[point.law];
    const Eigen::Matrix3d rate = log_strain_rate(green);
    system.add_matrix(
        point.functions,
        tangent_at(point, Eigen::Matrix2d::Identity() + h,
                   rate.transpose() * modulus * rate + log_strain_curvature(green, stress), rate.transpose() * stress));
  }
}

double CoverYield::weight_of(const YieldPoint& point, const Way& way) const {
  return way.theta + (way.more.empty() ? 0 : way.more[static_cast<std::size_t>(point.element)]);
}

// A stress of damping follows the strain, whatever of it is plastic.
Eigen::Vector3d CoverYield::mean_stress(const YieldPoint& point, const Way& way, const Eigen::Vector3d& log0,
                                        const Eigen::Vector3d& log1, const YieldState& before,
                                        const Response& end) const {
  const Eigen::Vector3d start = point.rock.stress(log0, before).head<3>();
  Eigen::Vector3d stress = (1 - way.theta) * start + way.theta * end.stress.head<3>();
  stress += point.rock.missing_stress(log0, before, log1, end.after);
  if (!way.more.empty())
    stress += way.more[static_cast<std::size_t>(point.element)] * (elastic_[point.law] * (log1 - log0));
  return stress;
}

Eigen::VectorXd CoverYield::force_of_step(const Way& way) const {
  const auto none = [&] {
    return Eigen::VectorXd(Eigen::VectorXd::Constant(way.d1.size(), std::numeric_limits<double>::quiet_NaN()));
  };
  Eigen::VectorXd force = Eigen::VectorXd::Zero(way.d1.size());
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const YieldPoint& point = points_[i];
    const Eigen::Matrix2d h0 = displacement_gradient(point, way.d0), h1 = displacement_gradient(point, way.d1);
    if (!((Eigen::Matrix2d::Identity() + h1).determinant() > 0)) return none();
    const Eigen::Vector3d from = green_strain(h0), to = green_strain(h1);
    const Eigen::Vector3d log0 = log_strain(from), log1 = log_strain(to);
    const Response end = point.rock.respond(log1, way.before[i]);
    if (!end.is_found) return none();
    const Eigen::Vector3d stress = mean_stress(point, way, log0, log1, way.before[i], end);
    add_force(point, Eigen::Matrix2d::Identity() + (h0 + h1) / 2, log_step_stress(from, to, stress), force);
  }
  return force;
}

// P is taken at the mean strain, which moves by half of what the end does.
void CoverYield::add_tangent_of_step(const Way& way, SparseSystem& system) const {
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const YieldPoint& point = points_[i];
    const Eigen::Matrix2d h0 = displacement_gradient(point, way.d0), h1 = displacement_gradient(point, way.d1);
    const Eigen::Vector3d from = green_strain(h0), to = green_strain(h1), mean = (from + to) / 2;
    const Eigen::Vector3d log0 = log_strain(from), log1 = log_strain(to);
    const Response end = point.rock.respond(log1, way.before[i]);
    const Eigen::Vector3d stress = mean_stress(point, way, log0, log1, way.before[i], end);
    const Eigen::Matrix3d of_law = end.tangent.topLeftCorner<3, 3>();
    const Eigen::Matrix3d modulus = way.theta / 2 * (of_law + of_law.transpose()) +
                                    (weight_of(point, way) - way.theta) * elastic_[point.law] +
                                    point.rock.missing_stiffness(log0, way.before[i], log1, end.after);
    const Eigen::Matrix3d rate = log_strain_rate(mean);
    const Eigen::Matrix3d stiffness = rate.transpose() * modulus * rate + log_strain_curvature(mean, stress) / 2;
    system.add_matrix(point.functions, tangent_at(point, Eigen::Matrix2d::Identity() + (h0 + h1) / 2, stiffness,
                                                  log_step_stress(from, to, stress) / 2));
  }
}

double CoverYield::damping_work(const Eigen::VectorXd& d0, const Eigen::VectorXd& d1,
                                std::span<const double> more) const {
  double sum = 0;
  for (const YieldPoint& point : points_) {
    const Eigen::Vector3d change = log_strain(green_strain(displacement_gradient(point, d1))) -
                                   log_strain(green_strain(displacement_gradient(point, d0)));
    sum += point.rock.area * more[static_cast<std::size_t>(point.element)] * change.dot(elastic_[point.law] * change);
  }
  return sum;
}

double CoverYield::stored(const Eigen::VectorXd& d, const YieldStates& states) const {
  double sum = 0;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const YieldPoint& point = points_[i];
    sum += point.rock.stored(log_strain(green_strain(displacement_gradient(point, d))), states[i]);
  }
  return sum;
}

double CoverYield::plastic_work(const Eigen::VectorXd& d, const YieldStates& before, const YieldStates& after) const {
  double sum = 0;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const YieldPoint& point = points_[i];
    const Eigen::Vector3d log = log_strain(green_strain(displacement_gradient(point, d)));
    sum += point.rock.plastic_work(log, before[i], after[i]);
  }
  return sum;
}

void CoverYield::carry(int element, const CoverYield& before, int was, const YieldStates& from,
                       YieldStates& states) const {
  const std::vector<std::size_t>& to = of_element_[static_cast<std::size_t>(element)];
  const std::vector<std::size_t>& of = before.of_element_[static_cast<std::size_t>(was)];
  for (std::size_t i = 0; i < std::min(to.size(), of.size()); ++i) states[to[i]] = from[of[i]];
}

YieldStates CoverYield::gathered(std::span<const std::vector<Remembered>> of_elements) const {
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

YieldState CoverYield::memory(const YieldStates& states, int element, Point at_start) const {
  MeanMemory mean;
  for (const Share& share : shares(element, at_start)) mean.add(share.weight, states[share.point]);
  return mean.over(1);
}

PlasticState CoverYield::plastic_state(const YieldStates& states, int element, Point at_start, double angle) const {
  PlasticState found = keyblock::plastic_state(memory(states, element, at_start), angle);
  double yielded = 0;
  for (const Share& share : shares(element, at_start))
    if (has_yielded(states[share.point])) yielded += share.weight;
  found.has_yielded = yielded > 0.5 - kRounding;
  return found;
}

void CoverYield::add_totals(const YieldStates& states, PlasticTotals& totals) const {
  for (std::size_t i = 0; i < points_.size(); ++i)
    if (points_[i].rock.law->may_yield) totals.add(points_[i].rock.area, states[i]);
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
  for (const std::size_t point : own) area += points_[point].rock.area;
  for (const std::size_t point : own) shares.push_back({point, points_[point].rock.area / area});
  return shares;
}

Stress CoverYield::stress(const Eigen::VectorXd& d, const YieldStates& states, int element, Point at_start) const {
  Eigen::Vector4d sum = Eigen::Vector4d::Zero();
  for (const Share& share : shares(element, at_start)) {
    const YieldPoint& point = points_[share.point];
    const Eigen::Matrix2d h = displacement_gradient(point, d);
    const Eigen::Matrix2d f = Eigen::Matrix2d::Identity() + h;
    const Eigen::Vector3d green = green_strain(h);
    const Eigen::Vector4d t = point.rock.stress(log_strain(green), states[share.point]);
    const Eigen::Vector3d second = log_strain_rate(green).transpose() * t.head<3>();
    const Eigen::Matrix2d cauchy = f * stress_tensor(second) * f.transpose() / f.determinant();
    sum += share.weight * Eigen::Vector4d(cauchy(0, 0), cauchy(1, 1), cauchy(0, 1), t(3) / f.determinant());
  }
  return {sum(0), sum(1), sum(2), sum(3)};
}

double CoverYield::greatest_size(std::size_t material) const {
  double area = 0;
  for (const YieldPoint& point : points_)
    if (point.law == material) area = std::max(area, point.rock.area);
  return std::sqrt(area);
}

}  // namespace keyblock
