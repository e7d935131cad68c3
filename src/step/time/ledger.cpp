// Computes the work of each force over the smooth motion, later losses of velocity, and impulses of the loads.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/time/ledger.hpp"

#include <algorithm>
#include <cmath>

#include "contact/rows/gap.hpp"

namespace keyblock {
namespace {

double spring_energy(const Motion& motion) {
  double energy = 0;
  for (const auto& [touch, memory] : motion.closed.all()) energy += memory.energy();
  return energy;
}

double bolt_energy(const Bolt& bolt, double force) {
  return bolt.is_spring() ? force * force / (2 * bolt.stiffness) : 0;
}

double bolt_energy(const StandardScene& scene, const Motion& motion) {
  double energy = 0;
  for (std::size_t i = 0; i < scene.model.bolts.size(); ++i)
    energy += bolt_energy(scene.model.bolts[i], motion.constraints.bolt_forces[i]);
  return energy;
}

// Returns the energy of bolts that broke in this step.
double ruptured(const StandardScene& scene, const StepTrail& trail) {
  double energy = 0;
  for (std::size_t i = 0; i < scene.model.bolts.size(); ++i) {
    const Bolt& bolt = scene.model.bolts[i];
    if (trail.end.constraints.broken[i] && !trail.start.constraints.broken[i])
      energy += bolt_energy(bolt, bolt.strength);
  }
  return energy;
}

// Returns the energy that separating crack faces take from their bodies; the loads of the step include these forces.
double fractured(const StandardScene& scene, const StepTrail& trail) {
  double work = 0;
  for (const FacePull& pull : scene.pulls) {
    const auto place = [&](const UnknownsTable& q) {
      return point_at(scene.model, scene.reference, q, pull.element, pull.start);
    };
    work += dot(pull.force, place(trail.smooth.q) - place(trail.start.q));
  }
  return -work;
}

EnergyFlow body_flow(const StandardScene& scene, const StepTrail& trail) {
  const SmoothMotion& smooth = trail.smooth;
  const BodiesStep step{trail.start,   smooth.q,    smooth.v,   smooth.a, trail.end.q,
                        smooth.points, trail.loads, trail.rule, trail.dt};
  EnergyFlow flow;
  for (const auto& group : scene.groups) group->add_flow(step, flow);
  return flow;
}

// Computes the energy flow of contacts over the increments and gaps of one smooth motion.
class ContactFlow {
 public:
  ContactFlow(const StandardScene& scene, const StepTrail& trail)
      : scene_(scene), trail_(trail), forgotten_(spring_energy(trail.start)) {}

  EnergyFlow run() {
    if (!trail_.smooth.forces.isZero(0)) add_touches();
    if (trail_.constraints.count() > 0) add_constraints();
    flow_.algorithmic += forgotten_;  // springs that opened in this step
    return flow_;
  }

 private:
  void add_touches() {
    const auto before = vertices_at(scene_.model, scene_.reference, trail_.start.q);
    const auto after = vertices_at(scene_.model, scene_.reference, trail_.smooth.q);
    const Eigen::VectorXd way = rates(trail_.smooth.rows, plus(trail_.smooth.q, -1, trail_.start.q));
    for (std::size_t i = 0; i < trail_.touches.size(); ++i) {
      const auto n = static_cast<Eigen::Index>(2 * i);
      const Touch& touch = trail_.touches[i];
      Forces forces{trail_.smooth.forces[n], trail_.smooth.forces[n + 1], memory_of(trail_.start, touch), 0, 0, 0,
                    trail_.smooth.laws[i]};
      const ContactMemory at_end = memory_of(trail_.end, touch);
      forces.at_end = at_end.normal_at_end;
      forces.tangential_at_end = at_end.tangential;
      forces.stretch = at_end.stretch;
      if (forces.is_none()) continue;
      add_normal(forces, gap_of(touch, after) - gap_of(touch, before), way[n]);
      add_tangential(forces, way[n + 1]);
      forgotten_ -= forces.before.energy();
    }
  }

  // A bolt is a spring; a fixed point does the work of its support.
  void add_constraints() {
    const Eigen::VectorXd way = rates(trail_.smooth.rows, plus(trail_.smooth.q, -1, trail_.start.q));
    const Eigen::VectorXd longer =
        trail_.constraints.elongation(trail_.smooth.q) - trail_.constraints.elongation(trail_.start.q);
    const Eigen::VectorXd before = trail_.constraints.remembered();
    const Eigen::Index first = static_cast<Eigen::Index>(2 * trail_.touches.size());
    for (std::size_t i = 0; i < trail_.constraints.count(); ++i) {
      const Eigen::Index own = static_cast<Eigen::Index>(2 * i);
      const Eigen::Index n = first + own;
      if (i >= trail_.constraints.bolt_count()) {
        flow_.external += trail_.smooth.forces.segment<2>(n).dot(way.segment<2>(n));
        continue;
      }
      ContactLaw law;
      law.normal_compliance = trail_.constraints.compliance(i);
      ContactMemory memory;
      memory.normal_at_end = before[own];
      const double at_end = -trail_.constraints.at_end(i, trail_.end);
      add_normal({trail_.smooth.forces[n], 0, memory, at_end, 0, 0, law}, longer[static_cast<Eigen::Index>(i)], way[n]);
    }
  }

  struct Forces {
    double normal = 0;
    double tangential = 0;
    ContactMemory before;
    double at_end = 0;  ///< of the normal spring
    double tangential_at_end = 0;
    double stretch = 0;  ///< of the tangential spring at the end
    const ContactLaw& law;

    bool is_none() const { return normal == 0 && tangential == 0 && before.normal == 0 && before.tangential == 0; }
  };

  static ContactMemory memory_of(const Motion& motion, const Touch& touch) {
    const ContactMemory* memory = motion.closed.of(touch);
    return memory ? *memory : ContactMemory{};
  }

  void add_normal(const Forces& forces, double opening, double way) {
    const double compliance = forces.law.normal_compliance;
    const double change = forces.at_end - forces.before.normal_at_end;
    const double mean = (forces.at_end + forces.before.normal_at_end) / 2;
    flow_.geometric += forces.normal * (way - opening);
    if (scene_.settings.standard.impact == ImpactLaw::springs) {  // their force is the derivative of their energy
      flow_.closing -= forces.normal * opening + compliance * mean * change;
      return;
    }
    flow_.closing -= forces.normal * (opening + compliance * change);
    flow_.algorithmic += compliance * (forces.normal - mean) * change;
  }

  // Slip beyond the stretch of the spring is friction. A sticking multiplier lets slip pass while its velocity comes to
  // rest.
  void add_tangential(const Forces& forces, double slip) {
    const double compliance = forces.law.tangential_compliance;
    if (compliance == 0) {
      const double work = forces.tangential * slip;
      const bool stuck = sticks(forces.law, forces.normal, forces.tangential) &&
                         sticks(forces.law, forces.before.normal, forces.before.tangential);
      (stuck ? flow_.creep : flow_.friction) += stuck ? work : -work;
      return;
    }
    const bool had_spring = forces.before.tangential_compliance > 0;
    const double longer = forces.stretch - (had_spring ? forces.before.stretch : 0);
    const double before = had_spring ? forces.before.tangential : 0;
    const double at_end = forces.tangential_at_end;
    flow_.friction -= forces.tangential * (slip - longer);
    flow_.algorithmic -= forces.tangential * longer + compliance * (at_end * at_end - before * before) / 2;
  }

  const StandardScene& scene_;
  const StepTrail& trail_;
  double forgotten_;  ///< energy of the initial springs that this step has not met
  EnergyFlow flow_;
};

// Loads act for the whole step in its middle configuration, as in the equation of the step.
Momentum load_impulse(const StandardScene& scene, const StepTrail& trail) {
  UnknownsTable middle = plus(trail.start.q, 1, trail.smooth.q);
  middle *= 0.5;
  Momentum impulse;
  for (const auto& group : scene.groups)
    group->look_at_bodies(scene.parts(), middle, trail.loads, [&](const WholeBody& body) {
      const Point force{body.resultant[0], body.resultant[1]};
      const Point arm = body.centre - scene.mass_centre;
      impulse += {trail.dt * force, trail.dt * (cross(arm, force) + body.resultant[2])};
    });
  return impulse;
}

}  // namespace

StepAccount& StepAccount::operator+=(const StepAccount& other) {
  flow += other.flow;
  impulse += other.impulse;
  return *this;
}

StepAccount account_of(const StandardScene& scene, const StepTrail& trail) {
  StepAccount account{body_flow(scene, trail), load_impulse(scene, trail)};
  account.flow += ContactFlow(scene, trail).run();
  account.flow.rupture += ruptured(scene, trail);
  const double taken = fractured(scene, trail);
  account.flow.fracture += taken;
  account.flow.external += taken;
  const double smooth = kinetic_energy(scene, trail.smooth.v);
  const double cleaned = kinetic_energy(scene, trail.cleaned);
  account.flow.clean_up += smooth - cleaned + trail.given.clean_up;
  account.flow.impact += cleaned - kinetic_energy(scene, trail.end.v) + trail.given.jump;
  account.flow.external += trail.given.clean_up + trail.given.jump;
  return account;
}

double kinetic_energy(const StandardScene& scene, const UnknownsTable& v) {
  double energy = 0;
  for (const auto& group : scene.groups) energy += group->kinetic_energy(v);
  return energy;
}

StoredEnergy stored_energy(const StandardScene& scene, const Motion& motion) {
  StoredEnergy stored;
  stored.kinetic = kinetic_energy(scene, motion.v);
  stored.contact = spring_energy(motion) + bolt_energy(scene, motion);
  for (const auto& group : scene.groups) group->add_stored(motion, stored);
  return stored;
}

LedgerRow ledger_row(const StandardScene& scene, const Motion& motion) {
  LedgerRow row;
  row.stored = stored_energy(scene, motion);
  const UnknownsTable momenta = momentum(scene, motion.v);
  const auto add = [&](const WholeBody& body) {
    const Point linear{body.resultant[0], body.resultant[1]};
    const double spin = body.resultant[2];
    const Point arm = body.centre - scene.mass_centre;
    row.momentum += {linear, cross(arm, linear) + spin};
    row.momentum_size.linear += length(linear);
    row.momentum_size.angular += (length(arm) + body.size) * length(linear) + std::abs(spin);
  };
  for (const auto& group : scene.groups) group->look_at_bodies(scene.parts(), motion.q, momenta, add);
  return row;
}

LedgerScope ledger_scope(const StandardScene& scene) {
  const bool has_supports =
      std::ranges::any_of(scene.groups, [](const BodyGroups::Group& group) { return group->has_supports(); });
  const bool is_dynamic = scene.settings.standard.motion == MotionRule::dynamic;
  return {is_dynamic, has_supports || !scene.held.empty(), scene.mass_centre, false, may_yield(scene)};
}

}  // namespace keyblock
