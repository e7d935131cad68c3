// Solves three small problems in contact space: projection of positions, jump of velocities, and clean-up of
// velocities.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/time/impact.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "base/context.hpp"
#include "contact/rows/gap.hpp"
#include "contact/solve/friction_newton.hpp"
#include "contact/solve/frictional_problem.hpp"
#include "model/material_choices.hpp"
#include "step/newton/tolerances.hpp"
#include "step/scene/step_constraints.hpp"
#include "step/time/impulse_energy.hpp"

namespace keyblock {
namespace {

using namespace tolerances;

Touches joined(const Touches& a, const Touches& b) {
  Touches all = a;
  all.insert(all.end(), b.begin(), b.end());
  return all;
}

std::vector<double> gaps_of(const StandardScene& scene, const UnknownsTable& q, const Touches& touches) {
  const Table<VertexIndex, Point> vertices = vertices_at(scene.model, scene.reference, q);
  std::vector<double> gaps;
  for (const Touch& touch : touches) gaps.push_back(gap_of(touch, vertices));
  return gaps;
}

// Moves the rows of a contact back by `time`, which changes the arms of the forces. Both centroids and the contact
// point then lay back along their velocities. Directions stay. NMM bodies keep the arms of the end of the step.
void take_back(ContactRow& normal, ContactRow& tangential, const UnknownsTable& v, double time) {
  if (!normal.shared.empty()) return;
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

// Returns two entries per meeting. Other contacts and fixed points respond at once and take the shortest of the times:
// more could lift blocks away from their supports.
Eigen::VectorXd times_of(const std::vector<ImpactMeeting>& meetings, Eigen::Index size) {
  const double least = std::ranges::min_element(meetings, {}, &ImpactMeeting::since)->since;
  Eigen::VectorXd times = Eigen::VectorXd::Constant(size, least);
  for (std::size_t i = 0; i < meetings.size(); ++i)
    times.segment<2>(static_cast<Eigen::Index>(2 * i)).setConstant(meetings[i].since);
  return times;
}

// Returns the greatest displacement of a body by translation and rotation; of velocities, the greatest velocity.
double greatest_rigid(const StandardScene& scene, const UnknownsTable& changes) {
  double most = 0;
  for (const ElementIndex e : indices(changes))
    if (const Unknowns& of = changes[e]; of.size() >= kRigidUnknowns)
      most = std::max(most, of.head<2>().norm() + std::abs(of[2]) * scene.bodies()[e].size);
  return most;
}

// Returns the displacement that impulses have made since the surfaces met, each meeting at its own time. Impulses in a
// jammed ring may balance one another and be far greater than what moves blocks. Their own times would leave them
// unbalanced and throw blocks: then all act for the shortest time. `changed`: their change of velocities.
UnknownsTable shift_since(const StandardScene& scene, const std::vector<ImpactMeeting>& meetings,
                          const ContactRows& rows, const Flexibility& flexibility, const Eigen::VectorXd& impulses,
                          const UnknownsTable& changed) {
  const Eigen::VectorXd times = times_of(meetings, impulses.size());
  UnknownsTable shift = answer(rows, flexibility, impulses.cwiseProduct(times));
  if (greatest_rigid(scene, shift) <= of_impacts::kBalanced * times.maxCoeff() * greatest_rigid(scene, changed))
    return shift;
  return answer(rows, flexibility, times.minCoeff() * impulses);
}

// Pushes apart contacts with too much overlap. Contacts that lock each other may keep their overlap from then on.
class Separation {
 public:
  Separation(const StandardScene& scene, UnknownsTable q, const Touches& impacts, const Touches& others,
             const UnknownsTable& before, const Flexibility& flexibility)
      : scene_(scene),
        touches_(joined(impacts, others)),
        flexibility_(flexibility),
        tolerable_((has_many() ? of_impacts::kNoOverlapOfMany : of_impacts::kNoOverlap) * scene.size()),
        least_(gaps_of(scene, before, touches_)) {
    result_.q = std::move(q);
    for (std::size_t i = 0; i < touches_.size(); ++i)
      least_[i] = i < impacts.size() ? touches_[i].rest_gap : std::min(least_[i], 0.0);
  }

  Separated run() {
    for (int pass = 0; pass < of_impacts::kMostPasses; ++pass) {
      leave_if_stopped();
      const std::vector<double> room = room_at(result_.q);
      if (std::ranges::all_of(room, [&](double gap) { return gap >= -tolerable_; })) break;
      const ContactRows rows = rows_with_points(scene_, result_.q, touches_);
      FrictionalProblem problem = problem_of(rows, room);
      const FrictionalSolution push = solve(problem, Eigen::VectorXd::Zero(problem.w.rows()));
      result_.solves += push.solves;
      UnknownsTable pushed = plus(result_.q, 1, answer(rows, flexibility_, push.forces));
      if (push.converged || is_much_better(room, pushed))
        result_.q = std::move(pushed);
      else
        leave_locked(rows, room, std::move(problem));
    }
    return std::move(result_);
  }

 private:
  bool has_many() const { return touches_.size() > FrictionalProblem::kFewPairs; }

  std::vector<double> room_at(const UnknownsTable& q) const {
    std::vector<double> room = gaps_of(scene_, q, touches_);
    for (std::size_t i = 0; i < room.size(); ++i) room[i] -= least_[i];
    return room;
  }

  // In large problems a push need not converge fully, because the next pass continues it.
  bool is_much_better(const std::vector<double>& room, const UnknownsTable& pushed) const {
    return has_many() && std::ranges::min(room_at(pushed)) > of_impacts::kLocked * std::ranges::min(room);
  }

  FrictionalProblem problem_of(const ContactRows& rows, const std::vector<double>& room) const {
    FrictionalProblem problem{ContactMatrix(rows, flexibility_), {}, std::vector<ForceLaw>(room.size()), 0, 0, {}};
    problem.laws.insert(problem.laws.end(), scene_.held.size(), kHeld);
    problem.b = Eigen::VectorXd::Zero(problem.w.rows());
    for (std::size_t i = 0; i < room.size(); ++i) problem.b[static_cast<Eigen::Index>(2 * i)] = room[i];
    problem.goal = tolerable_ / problem.w.diagonal().maxCoeff();
    problem.acceptable = problem.has_many() ? problem.goal : of_impacts::kLooser * problem.goal;
    return problem;
  }

  // Keeps the overlaps that a soft push would not remove; if there are none such, all overlaps.
  void leave_locked(const ContactRows& rows, const std::vector<double>& room, FrictionalProblem problem) {
    for (Eigen::Index n = 0; n < static_cast<Eigen::Index>(2 * problem.count()); n += 2)
      if (problem.laws[static_cast<std::size_t>(n / 2)].can_open())
        problem.w.add_to_diagonal(n, of_impacts::kYield * problem.w.diagonal()[n]);
    const FrictionalSolution soft = solve(problem, Eigen::VectorXd::Zero(problem.w.rows()));
    result_.solves += soft.solves;
    const std::vector<double> left = room_at(plus(result_.q, 1, answer(rows, flexibility_, soft.forces)));
    std::vector<std::size_t> overlapping;
    for (std::size_t i = 0; i < touches_.size(); ++i)
      if (room[i] < -tolerable_) overlapping.push_back(i);
    std::vector<std::size_t> locked;
    std::ranges::copy_if(overlapping, std::back_inserter(locked),
                         [&](std::size_t i) { return left[i] < of_impacts::kLocked * room[i]; });
    if (locked.empty()) locked = overlapping;
    for (const std::size_t i : locked) least_[i] += room[i];
    result_.locked += static_cast<int>(locked.size());
  }

  const StandardScene& scene_;
  Touches touches_;
  const Flexibility& flexibility_;
  double tolerable_;
  std::vector<double> least_;  ///< gap that a contact must have
  Separated result_;
};

// Returns true if what was gained since the meeting is more than the rebound: the surfaces have met again. `at_end`:
// approach speed at the end of the step.
bool stays(const ImpactMeeting& meeting, double at_end, double restitution) {
  return restitution * (at_end - meeting.gained) < meeting.gained;
}

// Sets the times in which impulses act. Surfaces that stay together take the speed at the meeting during all of it, and
// evenly what they gained since.
void put_times_of_staying(const StandardScene& scene, const Eigen::VectorXd& before,
                          std::vector<ImpactMeeting>& meetings) {
  for (std::size_t i = 0; i < meetings.size(); ++i) {
    ImpactMeeting& meeting = meetings[i];
    const double at_end = -before[static_cast<Eigen::Index>(2 * i)];
    if (at_end > meeting.gained && stays(meeting, at_end, restitution_of(scene.settings, meeting.touch.joint_material)))
      meeting.since *= 1 - meeting.gained / (2 * at_end);
  }
}

// Approach speed at the meeting times one plus restitution, or without it.
enum class Rebound { none, by_restitution };

FrictionalProblem problem_of_jump(const StandardScene& scene, const UnknownsTable& v, const Impacts& impacts,
                                  const Touches& touches, const ContactRows& rows, const Eigen::VectorXd& before,
                                  const Flexibility& flexibility, Rebound rebound) {
  const std::vector<ImpactMeeting>& meetings = impacts.meetings;
  const double goal = of_impacts::kImpulseTolerance * largest_momentum(scene, v) + of_impacts::kSmallest;
  FrictionalProblem problem{ContactMatrix(rows, flexibility), before, {}, goal, of_impacts::kLooser * goal, {}};
  for (const Touch& touch : touches)
    problem.laws.push_back({scene.model.joint_material(touch.joint_material).friction_tangent()});
  problem.laws.insert(problem.laws.end(), scene.held.size(), kHeld);
  problem.b.tail(static_cast<Eigen::Index>(2 * scene.held.size())).setZero();  // fixed points keep their motion
  double greatest = 0;
  for (std::size_t i = 0; i < meetings.size(); ++i) {
    const auto n = static_cast<Eigen::Index>(2 * i);
    const double restitution = rebound == Rebound::none ? 0 : restitution_of(scene.settings, touches[i].joint_material);
    const double approach = -problem.b[n] - meetings[i].gained;
    if (approach > 0 && !stays(meetings[i], -problem.b[n], restitution)) problem.b[n] = -(1 + restitution) * approach;
    greatest = std::max(greatest, approach / problem.w.diagonal()[n]);
  }
  for (std::size_t i = meetings.size(); i < touches.size(); ++i) {
    const auto n = static_cast<Eigen::Index>(2 * i);
    if (impacts.bonds.contains(touches[i].facing)) {
      problem.laws[i] = kHeld;
      problem.b.segment<2>(n).setZero();
    } else {
      problem.b[n] = std::max(problem.b[n], 0.0);
    }
  }
  if (problem.has_many()) {
    problem.goal = of_impacts::kImpulseToleranceOfMany * largest_momentum(scene, v) + of_impacts::kSmallest;
    problem.acceptable = std::max(problem.goal, of_impacts::kShareOfImpulse * greatest);
    problem.gap_tolerance = of_impacts::kShareOfSlow * impacts.slow;
  }
  return problem;
}

}  // namespace

Separated without_overlap(const StandardScene& scene, UnknownsTable q, const Touches& impacts, const Touches& others,
                          const UnknownsTable& before, const Flexibility& flexibility) {
  return Separation(scene, std::move(q), impacts, others, before, flexibility).run();
}

UnknownsTable rigid_part(UnknownsTable v) {
  for (Unknowns& of : v)
    if (of.size() > kRigidUnknowns) of.tail(of.size() - kRigidUnknowns).setZero();
  return v;
}

Flexibility impact_flexibility(const StandardScene& scene, const Flexibility& step, const StepRule& rule) {
  Flexibility flexibility{rigid_mass_inverses(scene.bodies()), nullptr};
  flexibility.shared = scaled(step.shared, rule.inertia.increment);
  return flexibility;
}

Jump after_jump(const StandardScene& scene, const UnknownsTable& q, const UnknownsTable& v, const Impacts& impacts,
                const Flexibility& flexibility) {
  const std::vector<ImpactMeeting>& meetings = impacts.meetings;
  Touches touches;
  for (const ImpactMeeting& meeting : meetings) touches.push_back(meeting.touch);
  touches = joined(touches, impacts.touching);
  ContactRows rows = rows_with_points(scene, q, touches);
  for (std::size_t i = 0; i < meetings.size(); ++i) take_back(rows[2 * i], rows[2 * i + 1], v, meetings[i].since);
  const Eigen::VectorXd before = rates(rows, rigid_part(v));
  const auto impulses_of = [&](Rebound rebound) {
    const FrictionalProblem problem = problem_of_jump(scene, v, impacts, touches, rows, before, flexibility, rebound);
    return solve(problem, Eigen::VectorXd::Zero(before.size()));
  };
  FrictionalSolution solution = impulses_of(Rebound::by_restitution);
  const bool rebounds = std::ranges::any_of(
      touches, [&](const Touch& touch) { return restitution_of(scene.settings, touch.joint_material) > 0; });
  if (rebounds && solution.converged)
    take_gain(
        {scene, touches, rows, before, flexibility}, [&] { return impulses_of(Rebound::none); }, solution);
  const UnknownsTable changed = answer(rows, flexibility, solution.forces);
  std::vector<ImpactMeeting> acting = meetings;
  put_times_of_staying(scene, before, acting);
  Jump jump{plus(q, 1, shift_since(scene, acting, rows, flexibility, solution.forces, changed)),
            plus(v, 1, changed),
            0,
            0,
            solution.solves,
            {}};
  const auto of_touches = static_cast<Eigen::Index>(2 * touches.size());
  const Eigen::VectorXd met = before + rates(rows, rigid_part(jump.v));
  jump.lost = std::max(0.0, -solution.forces.head(of_touches).dot(met.head(of_touches)) / 2);
  const Eigen::Index of_points = met.size() - of_touches;
  if (solution.converged) jump.given = solution.forces.tail(of_points).dot(met.tail(of_points)) / 2;
  if (!solution.converged)
    std::ranges::copy_if(solution.undecided, std::back_inserter(jump.undecided),
                         [&](std::size_t i) { return i < meetings.size(); });
  return jump;
}

UnknownsTable with_points_in_place(const StandardScene& scene, UnknownsTable q, double time,
                                   const Flexibility& flexibility) {
  if (scene.held.empty()) return q;
  const double tolerance = of_impacts::kNoOverlap * scene.size();
  for (int pass = 0; pass < of_impacts::kMostPasses; ++pass) {
    const Eigen::VectorXd off = offsets(scene.model, scene.reference, q, scene.held, time);
    if (off.cwiseAbs().maxCoeff() <= tolerance) break;
    const ContactRows rows = point_rows(scene.model, scene.reference, q, scene.held);
    FrictionalProblem problem{
        ContactMatrix(rows, flexibility), off, std::vector<ForceLaw>(scene.held.size(), kHeld), 0, 0, {}};
    problem.goal = tolerance / problem.w.diagonal().maxCoeff();
    problem.acceptable = of_impacts::kLooser * problem.goal;
    q = plus(q, 1, answer(rows, flexibility, newton(problem, Eigen::VectorXd::Zero(off.size())).forces));
  }
  return q;
}

PushedVelocities with_held_velocities(const StandardScene& scene, const UnknownsTable& q, UnknownsTable v,
                                      const Touches& closed, const std::vector<HeldSlip>& slips, double time, double dt,
                                      const PushAnswer& answered) {
  if (closed.empty() && scene.held.empty()) return {std::move(v)};
  const Flexibility& flexibility = answered.flexibility;
  const ContactRows rows = rows_with_points(scene, q, closed);
  FrictionalProblem problem{ContactMatrix(rows, flexibility), rates(rows, v), {}, 0, 0, {}};
  const auto of_points = static_cast<Eigen::Index>(2 * scene.held.size());
  // Central: a block that sticks to a driven one would creep by the lag of a mean velocity over the step.
  problem.b.tail(of_points) -= wanted_velocities(scene.held, time + dt / 2, dt);
  Eigen::VectorXd had = Eigen::VectorXd::Zero(problem.w.rows());  // forces with a law for the whole impulse
  for (std::size_t i = 0; i < slips.size(); ++i) {
    const auto n = static_cast<Eigen::Index>(2 * i);
    problem.laws.push_back(slips[i].sticks ? kHeld : kBilateral);
    if (slips[i].passes_on) {
      problem.laws.back() = {*slips[i].passes_on};
      problem.b[n] = std::max(problem.b[n], 0.0);
    }
    if (!slips[i].of_sum) continue;
    problem.laws.back() = *slips[i].of_sum;
    had.segment<2>(n) = answered.per_force * slips[i].force;
  }
  const bool has_laws_of_impulse = std::ranges::any_of(slips, &HeldSlip::has_law_of_impulse);
  if (has_laws_of_impulse) problem.b -= problem.w * had;
  problem.laws.insert(problem.laws.end(), scene.held.size(), kHeld);
  problem.goal = of_impacts::kImpulseTolerance * largest_momentum(scene, v) / (dt * dt) + of_impacts::kSmallest;
  problem.acceptable = of_impacts::kLooser * problem.goal;
  const Eigen::VectorXd asked = problem.b;
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(problem.w.rows());
  Eigen::VectorXd pushes = had;
  Eigen::VectorXd smooth;  // pushes without friction
  Eigen::VectorXd friction = none;
  double first_change = 0;
  double change = 0;
  for (int round = 0; round < of_impacts::kMostFrictionRounds; ++round) {
    // If no contact slips by Coulomb's law, the fallback of `solve` could not improve on Newton's method.
    pushes = (has_laws_of_impulse ? solve(problem, pushes) : newton(problem, pushes)).forces;
    if (round == 0) smooth = pushes;
    change = 0;
    for (std::size_t i = 0; i < closed.size(); ++i) {
      const auto n = static_cast<Eigen::Index>(2 * i);
      if (slips[i].sticks || slips[i].has_law_of_impulse()) continue;
      const double before = std::exchange(friction[n + 1], slips[i].friction * pushes[n]);
      change = std::max(change, std::abs(friction[n + 1] - before));
    }
    if (round == 0) first_change = change;
    if (change <= problem.acceptable) break;
    problem.b = asked + problem.w * friction;
  }
  // If slivers slide, friction may amplify the pushes that cause it in each iteration.
  const bool grows = change > std::max(first_change, problem.acceptable);
  const Eigen::VectorXd made = (grows ? smooth : pushes + friction) - had;
  UnknownsTable pushed = plus(v, 1, answer(rows, flexibility, made));
  if (of_points == 0) return {std::move(pushed)};
  Eigen::VectorXd of_supports = made;
  of_supports.head(made.size() - of_points).setZero();
  const UnknownsTable given = momentum(scene, answer(rows, flexibility, of_supports));
  const double energy = (dot(v, given) + dot(pushed, given)) / 2;
  return {std::move(pushed), energy};
}

}  // namespace keyblock
