// Compares the slowest strain mode of each block with the step.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/time/unresolved_strain.hpp"

#include <Eigen/LU>
#include <numbers>

namespace keyblock {
namespace {

// ω dt of a mode whose period is the step. Below, the rule of the step damps it in a few periods.
constexpr double kUnresolved = 2 * std::numbers::pi;

}  // namespace

void stop_unresolved(const Bodies& bodies, double dt, UnknownsTable& v) {
  for (const ElementIndex e : indices(bodies)) {
    const Body& body = bodies[e];
    if (!(body.slowest_frequency * dt > kUnresolved)) continue;
    const Eigen::Index strains = body.strain_count();
    const Eigen::Vector3d momentum = body.mass.topRightCorner(kRigidUnknowns, strains) * v[e].tail(strains);
    v[e].head<kRigidUnknowns>() += body.mass.topLeftCorner<kRigidUnknowns, kRigidUnknowns>().inverse() * momentum;
    v[e].tail(strains).setZero();
  }
}

}  // namespace keyblock
