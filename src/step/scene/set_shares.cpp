// Adds load, momentum over the step and round-off of the last forces; see set_shares.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/scene/set_shares.hpp"

#include <algorithm>
#include <cmath>

#include "contact/find/connected_sets.hpp"
#include "step/newton/tolerances.hpp"
#include "step/scene/equilibrium.hpp"

namespace keyblock {
namespace {

using namespace tolerances;

struct SetForces {
  Scales scales;
  double of_stress = 0;    ///< reference of a set without load
  double of_contacts = 0;  ///< greatest force of the last step

  // Returns the goal of the residual of few contacts, as for a scene of this set alone.
  double goal(double dt) const {
    const double load = scales.force > 0 ? scales.force : of_stress;
    return std::max(of_steps::kForceGoal * load + of_steps::kMomentumGoal * scales.momentum / dt,
                    of_gaps::kRoundOff * of_contacts);
  }
  void raise_to(const SetForces& other) {
    scales.force = std::max(scales.force, other.scales.force);
    scales.momentum = std::max(scales.momentum, other.scales.momentum);
    of_stress = std::max(of_stress, other.of_stress);
    of_contacts = std::max(of_contacts, other.of_contacts);
  }
};

}  // namespace

std::vector<double> shares_of_sets(const StandardScene& scene, const Motion& start, const UnknownsTable& loads,
                                   const Touches& touches, double dt) {
  if (scene.model.shares_unknowns()) return {};
  const ConnectedSets connected(scene.model, pairs_of(scene.model, touches), {});
  std::vector<SetForces> sets(scene.model.elements.size());
  std::vector<std::size_t> first_of_sets;
  for (const ElementIndex e : indices(scene.bodies())) {
    if (loads[e].size() == 0) continue;
    if (connected.of(e) == static_cast<std::size_t>(e.value)) first_of_sets.push_back(connected.of(e));
    SetForces& set = sets[connected.of(e)];
    const Body& body = scene.bodies()[e];
    add_block(set.scales, body, loads[e], start.v[e]);
    set.of_stress = std::max(set.of_stress, reference_of_stress(body));
  }
  if (first_of_sets.size() < 2) return {};
  for (const auto& [touch, memory] : start.closed.all())
    for (const VertexIndex v : {touch.vertex, touch.start}) {
      double& greatest = sets[connected.of(scene.model.vertices[v].element)].of_contacts;
      greatest = std::max({greatest, std::abs(memory.normal), std::abs(memory.tangential)});
    }
  SetForces all;
  for (const std::size_t s : first_of_sets) all.raise_to(sets[s]);
  std::vector<double> shares(scene.model.elements.size(), 1);
  bool all_alike = true;
  for (const ElementIndex e : indices(scene.bodies())) {
    const double share = sets[connected.of(e)].goal(dt) / all.goal(dt);
    if (loads[e].size() == 0 || !(share > 0 && share < 1 / kAlikeForces)) continue;
    shares[static_cast<std::size_t>(e.value)] = share;
    all_alike = false;
  }
  return all_alike ? std::vector<double>{} : shares;
}

}  // namespace keyblock
