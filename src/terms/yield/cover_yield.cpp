// Integrates point by point; see cover_yield.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "terms/yield/cover_yield.hpp"

#include <Eigen/LU>
#include <cmath>
#include <limits>

#include "material/elastic_law.hpp"
#include "terms/green_strain.hpp"

namespace keyblock {
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

// B(F)ᵀ C B(F of strain) and ∇N · S ∇N.
Eigen::MatrixXd CoverYield::tangent_at(const YieldPoint& point, const Eigen::Matrix2d& f,
                                       const Eigen::Matrix2d& of_strain, const Eigen::Matrix3d& stiffness,
                                       const Eigen::Vector3d& second, double share) {
  const auto n = static_cast<Eigen::Index>(point.functions.size());
  const auto strain_operator = [&](const Eigen::Matrix2d& at) {
    Eigen::Matrix3Xd b(3, 2 * n);
    for (Eigen::Index a = 0; a < n; ++a) {
      const Eigen::Vector2d g = point.gradients.col(a);
      for (Eigen::Index k = 0; k < 2; ++k)
        b.col(2 * a + k) << at(k, 0) * g(0), at(k, 1) * g(1), at(k, 0) * g(1) + at(k, 1) * g(0);
    }
    return b;
  };
  Eigen::MatrixXd tangent = strain_operator(f).transpose() * (stiffness * strain_operator(of_strain));
  const Eigen::MatrixXd geometric = share * (point.gradients.transpose() * (stress_tensor(second) * point.gradients));
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
    const Eigen::Matrix2d f = Eigen::Matrix2d::Identity() + h;
    system.add_matrix(point.functions,
                      tangent_at(point, f, f, rate.transpose() * modulus * rate + log_strain_curvature(green, stress),
                                 rate.transpose() * stress));
  }
}

double CoverYield::weight_of(const YieldPoint& point, const Way& way) const {
  return way.theta + (way.more.empty() ? 0 : way.more[static_cast<std::size_t>(point.element)]);
}

// A stress of damping follows the total strain, plastic or not.
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

// Made symmetric: P is taken at the mean strain, which moves by half of the change of the end, and F1 is F_half.
void CoverYield::add_tangent_of_step(const Way& way, SparseSystem& system, WholeSystem* whole) const {
  const Eigen::Matrix2d one = Eigen::Matrix2d::Identity();
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const YieldPoint& point = points_[i];
    const Eigen::Matrix2d h0 = displacement_gradient(point, way.d0), h1 = displacement_gradient(point, way.d1);
    const Eigen::Vector3d from = green_strain(h0), to = green_strain(h1), mean = (from + to) / 2;
    const Eigen::Vector3d log0 = log_strain(from), log1 = log_strain(to);
    const Response end = point.rock.respond(log1, way.before[i]);
    const Eigen::Vector3d stress = mean_stress(point, way, log0, log1, way.before[i], end);
    Eigen::Matrix3d modulus = way.theta * end.tangent.topLeftCorner<3, 3>() +
                              (weight_of(point, way) - way.theta) * elastic_[point.law] +
                              point.rock.missing_stiffness(log0, way.before[i], log1, end.after);
    const Eigen::Matrix2d half = one + (h0 + h1) / 2;
    const Eigen::Vector3d second = log_step_stress(from, to, stress);
    if (whole != nullptr && !point.rock.law->has_symmetric_tangent()) {
      const Eigen::Matrix3d stiffness = log_step_stiffness(from, to, stress, modulus);
      whole->add_matrix(point.functions, tangent_at(point, half, one + h1, stiffness, second, 0.5));
      continue;
    }
    modulus = ((modulus + modulus.transpose()) / 2).eval();
    const Eigen::Matrix3d rate = log_strain_rate(mean);
    const Eigen::Matrix3d stiffness = rate.transpose() * modulus * rate + log_strain_curvature(mean, stress) / 2;
    system.add_matrix(point.functions, tangent_at(point, half, half, stiffness, second, 0.5));
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

}  // namespace keyblock
