// Solves the linear equations of glued faces, and takes the glue forces as those of contacts.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/scene/glued_faces.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>
#include <vector>

#include "contact/rows/gap.hpp"
#include "contact/rows/joined_blocks.hpp"
#include "step/newton/tolerances.hpp"
#include "step/scene/contact_laws.hpp"
#include "step/scene/equilibrium.hpp"
#include "step/scene/step_constraints.hpp"

namespace keyblock {
namespace {

using namespace tolerances;

// Displacement by the glue, over body size, above which a body swings on its bolts, and stays as drawn: glue does not
// hold it across them.
constexpr double kSwings = 0.1;

}  // namespace

double heaviest(const Table<ElementIndex, Body>& bodies) {
  double mass = 0;
  for (const Body& body : bodies)
    if (body.mass.rows() > 0) mass = std::max(mass, body.mass(0, 0));
  return mass;
}

void load_glued(const StandardScene& scene, const Touches& touches, const UnknownsTable& loads, Motion& motion) {
  Touches faces;
  std::ranges::copy_if(touches, std::back_inserter(faces), [](const Touch& touch) { return touch.stretch > 0; });
  ContactRows rows = contact_rows(scene.model, scene.reference, motion.q, faces);
  const auto of_faces = static_cast<Eigen::Index>(rows.size());
  const StepConstraints constraints(scene, motion, 0, 0);
  const ContactRows of_constraints = constraints.rows(motion.q);
  rows.insert(rows.end(), of_constraints.begin(), of_constraints.end());
  const auto count = static_cast<Eigen::Index>(rows.size());
  Eigen::VectorXd compliance = Eigen::VectorXd::Constant(count, of_settled_start::kRigid / scene.normal_stiffness());
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const Springs springs = springs_of(scene, faces[i]);
    compliance.segment<2>(static_cast<Eigen::Index>(2 * i)) << springs.normal, springs.tangential;
  }
  for (std::size_t i = 0; i < constraints.bolt_count(); ++i) {
    const Eigen::Index n = of_faces + static_cast<Eigen::Index>(2 * i);
    compliance[n] = constraints.compliance(i);
    compliance[n + 1] = of_settled_start::kHeldByNothing / scene.normal_stiffness();  // no force across
  }
  Eigen::VectorXd gaps = Eigen::VectorXd::Zero(count);
  gaps.tail(count - of_faces) = constraints.gaps(motion.q);
  const double inertia = scene.normal_stiffness() / (of_settled_start::kHeldByNothing * heaviest(scene.bodies()));
  Table<ElementIndex, UnknownBlock> stiffness;
  for (const Body& body : scene.bodies()) stiffness.push_back(body.sum_of(inertia, 1));
  UnknownsTable all = loads;
  for (const ElementIndex e : indices(all))
    if (scene.bodies()[e].initial_stress.size() == all[e].size()) all[e] += scene.bodies()[e].initial_stress;
  auto made = displacements_of_joined(stiffness, rows, compliance, gaps, all);
  if (!made) return;
  for (const ElementIndex e : indices(*made)) {
    Unknowns& way = (*made)[e];
    if (way.size() > 0 && way.head<2>().norm() > kSwings * scene.bodies()[e].size) way.setZero();
  }
  const Eigen::VectorXd forces = -(rates(rows, *made) + gaps).cwiseQuotient(compliance);
  motion.q = plus(motion.q, 1, *made);
  std::vector<ClosedContact> closed;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const auto n = static_cast<Eigen::Index>(2 * i);
    closed.push_back({faces[i], memory_of(contact_law(scene, motion.bonds, faces[i]), forces[n], forces[n + 1])});
  }
  motion.closed = ClosedContacts(std::move(closed));
  motion.constraints = constraints.memory(forces.tail(count - of_faces), motion.q);
}

}  // namespace keyblock
