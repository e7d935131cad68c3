// Glue, load, dissolve.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/settled_start.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/union_find.hpp"
#include "contact/gap.hpp"
#include "step/contact_laws.hpp"
#include "step/smooth_solve.hpp"
#include "step/touch_search.hpp"

namespace keyblock {
namespace {

// Strength of the glue, so far above any stress that it never breaks.
constexpr double kGlue = 1e30;
// Stiffness of the contacts over the inertia of the heaviest block in a step: long ones for the static step, in which nothing
// can move away, short and then longer ones to dissolve the glue. A free block moves by half that times its weight over the
// contact stiffness in each.
constexpr double kStaticStep = 1e6;
constexpr int kStaticSteps = 2;
constexpr std::array<double, 3> kDissolving{1, 4, 16};
constexpr int kStepsEach = 8;
constexpr double kForceGoal = 1e-10;  // of the largest load on a block
constexpr double kForceAcceptable = 1e-6;

StandardScene glued(StandardScene scene) {
  for (JointMaterial& joint : scene.model.joint_materials) joint.cohesion = joint.tensile_strength = kGlue;
  return scene;
}

class Settling {
 public:
  Settling(const StandardScene& scene, Motion motion) : scene_(scene), motion_(std::move(motion)) {
    velocities_ = motion_.v;
    motion_.v.set_zero();
    loads_ = loads_at(scene, motion_.q, 0);
    scales_ = scales_of(scene, loads_, motion_.q, velocities_);
  }

  Settled run() {
    const Touches touches = resting_touches(scene_, motion_, scales_);
    leave_unsupported(touches);
    const Bonds bonds = motion_.bonds;
    const StandardScene with_glue = glued(scene_);
    motion_.bonds = bonds_at(with_glue, motion_.q, touches);
    for (int i = 0; i < kStaticSteps; ++i) step(with_glue, touches, kStaticStep);
    motion_.bonds = bonds;
    for (double stiffness : kDissolving)
      for (int i = 0; i < kStepsEach; ++i) step(scene_, touches, stiffness);
    motion_.v = velocities_;
    return {std::move(motion_), unsolved_};
  }

 private:
  // A step that finds no forces changes nothing.
  void step(const StandardScene& scene, const Touches& touches, double stiffness_over_inertia) {
    const ForceTolerance tolerance{kForceGoal * scales_.force, kForceAcceptable * scales_.force};
    const double dt = std::sqrt(stiffness_over_inertia * heaviest() / scene.normal_stiffness());
    SmoothMotion made =
        smooth_solve(scene, motion_, loads_, touches, tolerance, 0, dt, step_rule(scene.settings.standard, dt));
    if (!made.converged) {
      ++unsolved_;
      return;
    }
    motion_.q = std::move(made.q);
    motion_.bonds = std::move(made.bonds);
    motion_.ties = std::move(made.ties);
    std::vector<ClosedContact> closed;
    for (std::size_t i = 0; i < touches.size(); ++i) {
      const auto n = static_cast<Eigen::Index>(2 * i);
      if (made.forces[n] != 0 || made.laws[i].is_bonded)
        closed.push_back({touches[i], memory_of(made.laws[i], made.forces[n], made.forces[n + 1])});
    }
    motion_.closed = ClosedContacts(std::move(closed));
  }

  double heaviest() const {
    double mass = 0;
    for (const Body& body : scene_.bodies)
      if (body.mass.rows() > 0) mass = std::max(mass, body.mass(0, 0));
    return mass;
  }

  // Union of touching and bolted blocks; a group without a block that is fixed or held somewhere bears no load here.
  void leave_unsupported(const Touches& touches) {
    UnionFind groups(scene_.bodies.size());
    const auto join = [&](ElementIndex first, ElementIndex second) { groups.unite(first.value, second.value); };
    for (const Touch& touch : touches)
      join(scene_.model.vertices[touch.vertex].element, scene_.model.vertices[touch.start].element);
    for (const Bolt& bolt : scene_.model.bolts) join(bolt.first.element, bolt.second.element);
    std::vector<bool> held(scene_.bodies.size(), false);
    for (ElementIndex e : indices(scene_.bodies))
      if (scene_.bodies[e].mass.rows() == 0) held[static_cast<std::size_t>(groups.find(e.value))] = true;
    for (const CarriedPoint& point : scene_.held)
      held[static_cast<std::size_t>(groups.find(point.element.value))] = true;
    for (ElementIndex e : indices(loads_))
      if (!held[static_cast<std::size_t>(groups.find(e.value))]) loads_[e].setZero();
  }

  const StandardScene& scene_;
  Motion motion_;
  UnknownsTable velocities_;
  UnknownsTable loads_;
  Scales scales_;
  int unsolved_ = 0;
};

}  // namespace

Settled settled(const StandardScene& scene, Motion motion) {
  return Settling(scene, std::move(motion)).run();
}

}  // namespace keyblock
