// Computes mass, stiffness, damping and loads of a block from its initial area moments.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/bodies/standard_body.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "base/loop.hpp"
#include "material/material_stress.hpp"
#include "model/body_load.hpp"
#include "step/bodies/integrator.hpp"
#include "terms/mass_matrix.hpp"

namespace keyblock {
namespace {

// Least stiffness damping times ω₁ of a block, with the damping of the rule. An undamped block in steady sliding is
// unstable above φ of about 20 degrees. Take a square on two sliding corners, H = Gₙᵀ − μ Gₜᵀ, S = Gₙ M⁻¹ H.
// Eigenvalues of
//   q̈ = −M⁻¹ K q + M⁻¹ H S⁻¹ Gₙ M⁻¹ K q
// grow by up to 0.13 ω₁ at 45 degrees. With β + (θf − ½) dt ≥ 2/ω₁ the slowest strain mode is damped critically, twice
// the need at 45 degrees.
constexpr double kDampingOverPeriod = 2;

UnknownBlock rigid_inverse(const UnknownBlock& mass) {
  UnknownBlock inverse = UnknownBlock::Zero(mass.rows(), mass.cols());
  if (mass.rows() < kRigidUnknowns) return inverse;
  const Eigen::Matrix3d rigid = mass.topLeftCorner<kRigidUnknowns, kRigidUnknowns>();
  inverse.topLeftCorner<kRigidUnknowns, kRigidUnknowns>() = rigid.inverse();
  return inverse;
}

// Returns ω₁ of the strain modes, rigid part free: K x = ω² (M_εε − M_εr M_rr⁻¹ M_rε) x.
double slowest_frequency(const Body& body) {
  const Eigen::Index strains = body.strain_count();
  if (strains == 0) return 0;
  const Eigen::MatrixXd coupling = body.mass.bottomLeftCorner(strains, kRigidUnknowns);
  const Eigen::MatrixXd rigid = body.mass.topLeftCorner<kRigidUnknowns, kRigidUnknowns>().inverse();
  const Eigen::MatrixXd mass = body.mass.bottomRightCorner(strains, strains) - coupling * rigid * coupling.transpose();
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> modes(Eigen::MatrixXd(body.stiffness), mass,
                                                                        Eigen::EigenvaluesOnly);
  return std::sqrt(modes.eigenvalues().minCoeff());
}

double least_stiffness_damping(const Body& body, const Settings& settings) {
  if (settings.standard.strain_damping == StrainDamping::none || body.strain_count() == 0) return 0;
  // Under step control a part of a step can be arbitrarily short, so that its rule gives no damping to rely on.
  const bool constant = settings.step_control == StepControl::constant;
  const double by_rule = constant ? damping_of_rule(settings.standard, settings.time_step) : 0;
  return std::max(0.0, kDampingOverPeriod / body.slowest_frequency - by_rule);
}

double stiffness_damping(const Body& body, const Settings& settings, int material) {
  const std::optional<double> given = settings.stiffness_damping.of(material);
  return given ? *given : least_stiffness_damping(body, settings);
}

Body body_of(const Model& model, const Reference& reference, const Settings& settings, ElementIndex e) {
  const Element& element = model.elements[e];
  const Basis& basis = *element.basis;
  const BlockMaterial& material = model.material_of(element);
  const Moments& moments = reference.moments[e];
  Body body;
  body.area = moments.area;
  body.mass = mass_matrix(basis, moments, material.density);
  const StrainOperator strain = basis.strain();
  const Eigen::Index strains = std::max<Eigen::Index>(0, body.mass.rows() - kRigidUnknowns);
  const auto of_strains = strain.rightCols(strains);
  body.stiffness = moments.area * (of_strains.transpose() * modulus_of(material, settings.plane) * of_strains);
  const Stress start = start_stress(material, material.stress_gradient, reference.centroids[e].y, settings.plane);
  body.initial_stress = -moments.area * (strain.transpose() * in_plane(start));
  body.weight = basis.constant.transpose() * (moments.area * weight_per_area(material, settings));
  body.slowest_frequency = slowest_frequency(body);
  body.mass_damping = settings.mass_damping.of(element.material);
  body.stiffness_damping = stiffness_damping(body, settings, element.material);
  for (VertexIndex v : element.vertices()) body.size = std::max(body.size, length(reference.offsets[v]));
  return body;
}

}  // namespace

Bodies bodies_of(const Model& model, const Reference& reference, const Settings& settings) {
  Bodies bodies;
  bodies.reserve(model.elements.size());
  for (ElementIndex e : indices(model.elements)) bodies.push_back(body_of(model, reference, settings, e));
  return bodies;
}

Table<ElementIndex, UnknownBlock> mass_inverses(const Bodies& bodies) {
  Table<ElementIndex, UnknownBlock> all(bodies.size());
  for_each_entry(bodies.size(), [&](std::size_t i) {
    const ElementIndex e{static_cast<int>(i)};
    const UnknownBlock& mass = bodies[e].mass;
    all[e] = mass.rows() > 0 ? UnknownBlock(mass.inverse()) : mass;
  });
  return all;
}

Table<ElementIndex, UnknownBlock> rigid_mass_inverses(const Bodies& bodies) {
  Table<ElementIndex, UnknownBlock> all;
  all.reserve(bodies.size());
  for (const Body& body : bodies) all.push_back(rigid_inverse(body.mass));
  return all;
}

Stress block_stress(const Model& model, ElementIndex e, const Reference& reference, const Settings& settings,
                    const Unknowns& q) {
  const Element& element = model.elements[e];
  const BlockMaterial& material = model.material_of(element);
  const Stress start = start_stress(material, material.stress_gradient, reference.centroids[e].y, settings.plane);
  return with_across(in_plane(start) + modulus_of(material, settings.plane) * (element.basis->strain() * q), start,
                     share_across(material, settings.plane));
}

Stress turned(const Stress& s, double angle) {
  const double c = std::cos(angle);
  const double n = std::sin(angle);
  return {c * c * s.xx - 2 * c * n * s.xy + n * n * s.yy, n * n * s.xx + 2 * c * n * s.xy + c * c * s.yy,
          c * n * (s.xx - s.yy) + (c * c - n * n) * s.xy, s.zz};
}

}  // namespace keyblock
