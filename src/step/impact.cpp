// Projection of positions, jump and clean-up of velocities: three small problems in contact space.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/impact.hpp"

#include <algorithm>
#include <iterator>
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
// Overlaps may lock each other, so that no push takes them all away. Which do is found with touches that yield this share of what
// their blocks do, so soft that there is always a push: where it leaves more than the second share of an overlap, it is taken
// for locked. A pair with room keeps a hundredth, a chain of ten a tenth.
constexpr double kYield = 1e-2;
constexpr double kLocked = 0.1;
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

// Pushes touches apart that overlap more than they may; those that lock each other may from then on.
class Separation {
 public:
  Separation(const StandardScene& scene, UnknownsTable q, const Touches& impacts, const Touches& closed)
      : scene_(scene),
        touches_(joined(impacts, closed)),
        view_(scene, q),
        tolerable_(kNoOverlap * size_of(scene)),
        least_(gaps_of(scene, q, touches_)) {
    result_.q = std::move(q);
    for (std::size_t i = 0; i < touches_.size(); ++i)
      least_[i] = i < impacts.size() ? touches_[i].rest_gap : std::min(least_[i], 0.0);
  }

  Separated run() {
    for (int pass = 0; pass < kMostPasses; ++pass) {
      const std::vector<double> room = room_at(result_.q);
      if (std::ranges::all_of(room, [&](double gap) { return gap >= -tolerable_; })) break;
      const ContactRows rows = view_.rows(rows_with_points(scene_, result_.q, touches_));
      FrictionalProblem problem = problem_of(rows, room);
      const FrictionalSolution push = newton(problem, Eigen::VectorXd::Zero(problem.w.rows()));
      result_.solves += push.solves;
      if (push.converged)
        result_.q = plus(result_.q, 1, view_.answer(rows, push.forces));
      else
        leave_locked(rows, room, std::move(problem));
    }
    return std::move(result_);
  }

 private:
  std::vector<double> room_at(const UnknownsTable& q) const {
    std::vector<double> room = gaps_of(scene_, q, touches_);
    for (std::size_t i = 0; i < room.size(); ++i) room[i] -= least_[i];
    return room;
  }

  FrictionalProblem problem_of(const ContactRows& rows, const std::vector<double>& room) const {
    FrictionalProblem problem{
        ContactMatrix(rows, view_.flexibility()), {}, std::vector<ForceLaw>(room.size()), 0, 0, {}};
    problem.laws.insert(problem.laws.end(), scene_.held.size(), kHeld);
    problem.b = Eigen::VectorXd::Zero(problem.w.rows());
    for (std::size_t i = 0; i < room.size(); ++i) problem.b[static_cast<Eigen::Index>(2 * i)] = room[i];
    problem.goal = tolerable_ / problem.w.diagonal().maxCoeff();
    problem.acceptable = kLooser * problem.goal;
    return problem;
  }

  // Those whose overlap a soft push would not take away stay as they are; where that are none, all.
  void leave_locked(const ContactRows& rows, const std::vector<double>& room, FrictionalProblem problem) {
    for (std::size_t i = 0; i < touches_.size(); ++i) {
      const auto n = static_cast<Eigen::Index>(2 * i);
      problem.w.add_to_diagonal(n, kYield * problem.w.diagonal()[n]);
    }
    const FrictionalSolution soft = newton(problem, Eigen::VectorXd::Zero(problem.w.rows()));
    result_.solves += soft.solves;
    const std::vector<double> left = room_at(plus(result_.q, 1, view_.answer(rows, soft.forces)));
    std::vector<std::size_t> overlapping;
    for (std::size_t i = 0; i < touches_.size(); ++i)
      if (room[i] < -tolerable_) overlapping.push_back(i);
    std::vector<std::size_t> locked;
    std::ranges::copy_if(overlapping, std::back_inserter(locked),
                         [&](std::size_t i) { return left[i] < kLocked * room[i]; });
    if (locked.empty()) locked = overlapping;
    for (const std::size_t i : locked) least_[i] += room[i];
    result_.locked += static_cast<int>(locked.size());
  }

  const StandardScene& scene_;
  Touches touches_;
  RigidView view_;
  double tolerable_;
  std::vector<double> least_;  ///< gap that a touch must have
  Separated result_;
};

}  // namespace

Separated without_overlap(const StandardScene& scene, UnknownsTable q, const Touches& impacts, const Touches& closed) {
  return Separation(scene, std::move(q), impacts, closed).run();
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
                                   const Touches& closed, double time, double dt, const Flexibility& flexibility) {
  if (closed.empty() && scene.held.empty()) return v;
  const ContactRows rows = rows_with_points(scene, q, closed);
  FrictionalProblem problem{ContactMatrix(rows, flexibility), rates(rows, v), {}, 0, 0, {}};
  problem.b.tail(static_cast<Eigen::Index>(2 * scene.held.size())) -= wanted_velocities(scene.held, time, dt);
  problem.laws.assign(closed.size(), kTie);
  problem.laws.insert(problem.laws.end(), scene.held.size(), kHeld);
  problem.goal = kImpulseTolerance * momentum_of(scene, v) / (dt * dt) + kSmallest;
  problem.acceptable = kLooser * problem.goal;
  const Eigen::VectorXd pushes = solve(problem, Eigen::VectorXd::Zero(problem.w.rows())).forces;
  return plus(v, 1, answer(rows, flexibility, pushes));
}

}  // namespace keyblock
