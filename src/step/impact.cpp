// Projection of positions, jump and clean-up of velocities: three small problems in contact space.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/impact.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "contact/friction_newton.hpp"
#include "contact/frictional_problem.hpp"
#include "contact/gap.hpp"
#include "model/material_choices.hpp"
#include "step/rigid_view.hpp"
#include "step/step_ties.hpp"

namespace keyblock {
namespace {

// Overlap of this share of block size is round-off of a position; linearised passes get there in two or three.
constexpr double kNoOverlap = 1e-14;
constexpr int kMostPasses = 10;
// Overlaps of more touches than the first figure may lock each other, and no push takes them all away. Where none is found, each
// touch yields this share of what its blocks do; passes end where the deepest overlap does not fall to the last figure.
constexpr std::size_t kMany = 50;
constexpr double kYield = 1e-2;
constexpr double kGain = 0.5;
// Impulses are settled at this share of the largest momentum.
constexpr double kImpulseTolerance = 1e-13;
// In assemblies the goal may be out of reach; a residual this much larger still counts.
constexpr double kLooser = 1e4;
constexpr double kSmallest = 1e-300;  // a tolerance is never zero

Touches joined(const Touches& a, const Touches& b) {
  Touches all = a;
  all.insert(all.end(), b.begin(), b.end());
  return all;
}

double size_of(const StandardScene& scene) {
  double size = 0;
  for (const Body& body : scene.bodies)
    if (body.mass.rows() > 0) size = std::max(size, body.size);
  return scene.covers ? std::max(size, scene.covers->size()) : size;
}

double momentum_of(const StandardScene& scene, const UnknownsTable& v) {
  double greatest = 0;
  for (ElementIndex e : indices(v))
    if (v[e].size() > 0) greatest = std::max(greatest, (scene.bodies[e].mass * v[e]).head<2>().norm());
  return scene.covers ? std::max(greatest, scene.covers->greatest_momentum(v.covers)) : greatest;
}

std::vector<double> gaps_of(const StandardScene& scene, const UnknownsTable& q, const Touches& touches) {
  const Table<VertexIndex, Point> vertices = vertices_at(scene.model, scene.reference, q);
  std::vector<double> gaps;
  for (const Touch& touch : touches) gaps.push_back(gap_of(touch, vertices));
  return gaps;
}

// Rows of a touch, with the arms that its forces had `time` ago: both centroids and the point of contact then lay back along
// their velocities. The directions stay. Bodies on covers keep the arms of the end of the step.
void take_back(ContactRow& normal, ContactRow& tangential, const UnknownsTable& v, double time) {
  if (!normal.covers.empty()) return;
  const Unknowns& of_vertex = v[normal.vertex_element];
  const Unknowns& of_edge = v[normal.edge_element];
  Eigen::Vector2d point = Eigen::Vector2d::Zero();
  if (of_vertex.size() > 0)
    point = normal.of_vertex.dot(of_vertex.transpose()) * normal.of_vertex.head<2>().transpose() +
            tangential.of_vertex.dot(of_vertex.transpose()) * tangential.of_vertex.head<2>().transpose();
  const auto turn = [&](ContactRow::Row& row, const Unknowns& body) {
    if (body.size() == 0) return;
    const Eigen::Vector2d arm = time * (body.head<2>() - point);
    row[2] += arm.x() * row[1] - arm.y() * row[0];
  };
  for (ContactRow* row : {&normal, &tangential}) {
    turn(row->of_vertex, of_vertex);
    turn(row->of_edge, of_edge);
  }
}

// Two entries a meeting. What answers them at once, closed touches and held points, takes the least of their times: more could
// lift blocks out of reach of what they rest on.
Eigen::VectorXd times_of(const std::vector<Meeting>& meetings, Eigen::Index size) {
  const double least = std::ranges::min_element(meetings, {}, &Meeting::since)->since;
  Eigen::VectorXd times = Eigen::VectorXd::Constant(size, least);
  for (std::size_t i = 0; i < meetings.size(); ++i)
    times.segment<2>(static_cast<Eigen::Index>(2 * i)).setConstant(meetings[i].since);
  return times;
}

Eigen::VectorXd push(const FrictionalProblem& problem) {
  return solve(problem, Eigen::VectorXd::Zero(problem.w.rows())).forces;
}

Eigen::VectorXd push_of_many(FrictionalProblem& problem) {
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(problem.w.rows());
  const FrictionalSolution exact = newton(problem, none);
  if (exact.converged) return exact.forces;
  for (Eigen::Index i = 0; i < none.size(); ++i) problem.w.add_to_diagonal(i, kYield * problem.w.diagonal()[i]);
  return newton(problem, none).forces;
}

}  // namespace

UnknownsTable without_overlap(const StandardScene& scene, UnknownsTable q, const Touches& impacts,
                              const Touches& closed) {
  const Touches all = joined(impacts, closed);
  std::vector<double> least = gaps_of(scene, q, all);
  for (std::size_t i = 0; i < all.size(); ++i)
    least[i] = i < impacts.size() ? all[i].rest_gap : std::min(least[i], 0.0);
  const double tolerable = kNoOverlap * size_of(scene);
  const bool may_lock = all.size() > kMany;
  const RigidView view(scene, q);
  double before = std::numeric_limits<double>::infinity();
  for (int pass = 0; pass < kMostPasses; ++pass) {
    std::vector<double> room = gaps_of(scene, q, all);
    for (std::size_t i = 0; i < all.size(); ++i) room[i] -= least[i];
    const double deepest = -std::ranges::min(room);
    if (deepest <= tolerable || (may_lock && deepest > kGain * before)) break;
    before = deepest;
    const ContactRows rows = view.rows(rows_with_points(scene, q, all));
    FrictionalProblem problem{ContactMatrix(rows, view.flexibility()), {}, std::vector<ForceLaw>(all.size()), 0, 0, {}};
    problem.laws.insert(problem.laws.end(), scene.held.size(), kHeld);
    problem.b = Eigen::VectorXd::Zero(problem.w.rows());
    for (std::size_t i = 0; i < all.size(); ++i) problem.b[static_cast<Eigen::Index>(2 * i)] = room[i];
    problem.goal = tolerable / problem.w.diagonal().maxCoeff();
    problem.acceptable = kLooser * problem.goal;
    q = plus(q, 1, view.answer(rows, may_lock ? push_of_many(problem) : push(problem)));
  }
  return q;
}

UnknownsTable rigid_part(const StandardScene& scene, const UnknownsTable& q, UnknownsTable v) {
  for (Unknowns& of : v)
    if (of.size() > kRigidUnknowns) of.tail(of.size() - kRigidUnknowns).setZero();
  if (scene.covers) v.covers = scene.covers->rigid_part(q.covers, v.covers);
  return v;
}

Jump after_jump(const StandardScene& scene, const UnknownsTable& q, const UnknownsTable& v,
                const std::vector<Meeting>& meetings, const Touches& closed) {
  Touches touches;
  for (const Meeting& meeting : meetings) touches.push_back(meeting.touch);
  touches = joined(touches, closed);
  ContactRows rows = rows_with_points(scene, q, touches);
  for (std::size_t i = 0; i < meetings.size(); ++i) take_back(rows[2 * i], rows[2 * i + 1], v, meetings[i].since);
  const RigidView view(scene, q);
  const double goal = kImpulseTolerance * momentum_of(scene, v) + kSmallest;
  const Eigen::VectorXd speeds = rates(rows, rigid_part(scene, q, v));
  rows = view.rows(std::move(rows));
  FrictionalProblem problem{ContactMatrix(rows, view.flexibility()), speeds, {}, goal, kLooser * goal, {}};
  for (const Touch& touch : touches)
    problem.laws.push_back({scene.model.joint_material(touch.joint_material).friction_tangent()});
  problem.laws.insert(problem.laws.end(), scene.held.size(), kHeld);
  problem.b.tail(static_cast<Eigen::Index>(2 * scene.held.size())).setZero();  // held points move on as they do
  for (std::size_t i = 0; i < meetings.size(); ++i) {
    double& normal = problem.b[static_cast<Eigen::Index>(2 * i)];
    const double approach = -normal - meetings[i].gained;
    const double restitution = restitution_of(scene.settings, touches[i].joint_material);
    if (approach > 0) normal = -(1 + restitution) * approach;
  }
  for (std::size_t i = meetings.size(); i < touches.size(); ++i) {
    double& normal = problem.b[static_cast<Eigen::Index>(2 * i)];
    normal = std::max(normal, 0.0);
  }
  const Eigen::VectorXd impulses = solve(problem, Eigen::VectorXd::Zero(problem.w.rows())).forces;
  const Eigen::VectorXd shifts = impulses.cwiseProduct(times_of(meetings, impulses.size()));
  return {plus(q, 1, view.answer(rows, shifts)), plus(v, 1, view.answer(rows, impulses))};
}

UnknownsTable with_held_velocities(const StandardScene& scene, const UnknownsTable& q, UnknownsTable v,
                                   const Touches& closed, double time, double dt) {
  if (closed.empty() && scene.held.empty()) return v;
  const Flexibility blocks = mass_flexibility(scene);
  const double goal = kImpulseTolerance * momentum_of(scene, v) + kSmallest;
  const ContactRows rows = rows_with_points(scene, q, closed);
  FrictionalProblem problem{ContactMatrix(rows, blocks), rates(rows, v), {}, goal, kLooser * goal, {}};
  problem.b.tail(static_cast<Eigen::Index>(2 * scene.held.size())) -= wanted_velocities(scene.held, time, dt);
  problem.laws.assign(closed.size(), kTie);
  problem.laws.insert(problem.laws.end(), scene.held.size(), kHeld);
  const Eigen::VectorXd impulses = solve(problem, Eigen::VectorXd::Zero(problem.w.rows())).forces;
  return plus(v, 1, answer(rows, blocks, impulses));
}

}  // namespace keyblock
