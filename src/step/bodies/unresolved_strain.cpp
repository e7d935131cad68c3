// Compares the slowest strain mode of each block with the step.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/bodies/unresolved_strain.hpp"

#include <Eigen/LU>
#include <numbers>

namespace keyblock {
namespace {

// ω dt of a mode with two periods a step. From about twice this value rows of blocks explode; at half of it, slopes
// that move need a quarter more iterations.
constexpr double kUnresolved = 4 * std::numbers::pi;

}  // namespace

bool is_unresolved(const Body& body, double dt) {
  return body.slowest_frequency * dt > kUnresolved;
}

void stop_unresolved(const Bodies& bodies, double dt, UnknownsTable& v) {
  for (const ElementIndex e : indices(bodies)) {
    const Body& body = bodies[e];
    if (!is_unresolved(body, dt)) continue;
    const Eigen::Index strains = body.strain_count();
    const Eigen::Vector3d momentum = body.mass.topRightCorner(kRigidUnknowns, strains) * v[e].tail(strains);
    v[e].head<kRigidUnknowns>() += body.mass.topLeftCorner<kRigidUnknowns, kRigidUnknowns>().inverse() * momentum;
    v[e].tail(strains).setZero();
  }
}

}  // namespace keyblock
