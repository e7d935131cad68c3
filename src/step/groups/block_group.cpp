// Computes elasticity and plastic flow of blocks; each has one small vector of unknowns.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/groups/block_group.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "base/loop.hpp"
#include "geometry/quadrature.hpp"
#include "step/bodies/step_equations.hpp"
#include "step/groups/carry_blocks.hpp"
#include "step/groups/yielding_blocks.hpp"

namespace keyblock {
namespace {

// Returns ½ A σᵀ D⁻¹ σ in terms of unknowns: the force f of the initial stress gives ½ (q − K⁻¹f)ᵀ K (q − K⁻¹f).
double strain_energy(const Body& body, const Unknowns& q) {
  const Eigen::Index strains = body.strain_count();
  if (strains == 0) return 0;
  const double without_initial = q.dot(body.elastic_force(q)) / 2;
  if (body.initial_stress.isZero(0)) return without_initial;
  const Unknowns force = body.initial_stress.tail(strains);
  return without_initial - body.initial_stress.dot(q) + force.dot(body.stiffness.llt().solve(force)) / 2;
}

// Returns pᵀ M Δv/dt + (dt v̄ + p)ᵀ M r of `account_of`, from velocities and accelerations alone. The closure of the
// energy balance then checks that these fit the increments.
double inertia_loss(const Body& body, const BodiesStep& step, ElementIndex e) {
  const StepRule& rule = step.rule;
  const Unknowns dv = step.v[e] - step.start.v[e];
  const Unknowns da = step.a[e] - step.start.a[e];
  const Unknowns lead = rule.velocity_lead * dv + rule.acceleration_lead * da;
  const Unknowns way = step.dt / 2 * (step.start.v[e] + step.v[e]) + lead;
  return lead.dot(body.mass * dv) / step.dt + rule.inertia_lead * way.dot(body.mass * da);
}

Unknowns sum_of(const StepSum& sum, const Unknowns& increment, const BodiesMotion& start, ElementIndex e) {
  return sum.increment * increment + sum.velocity * start.v[e] + sum.acceleration * start.a[e];
}

}  // namespace

void BlockGroup::put_start(const SceneParts& scene, BodiesMotion& motion) const {
  for (UnknownsTable* table : {&motion.q, &motion.v, &motion.a}) table->reserve(scene.model.elements.size());
  for (const Element& element : scene.model.elements) {
    const int count = element.basis->unknown_count();
    motion.q.push_back(Unknowns::Zero(count));
    Unknowns v = Unknowns::Zero(count);
    const Velocity& given = scene.model.material_of(element).initial_velocity;
    if (count > 0) v.head<3>() << given.x, given.y, given.rotation;
    motion.v.push_back(v);
    motion.a.push_back(Unknowns::Zero(count));
  }
  motion.points.blocks.resize(yields_.size());
  for (ElementIndex e : indices(bodies_))
    if (const BlockYield* yield = yield_of(e))
      motion.points.blocks[static_cast<std::size_t>(e.value)].elastic = yield->rock.initial;
}

void BlockGroup::unload(const ChosenElements& bodies, UnknownsTable& loads) const {
  for (ElementIndex e : indices(loads))
    if (has(e) && bodies[static_cast<std::size_t>(e.value)]) loads[e].setZero();
}

void BlockGroup::put_back(const ChosenElements& bodies, const BodiesMotion& as, BodiesMotion& motion) const {
  for (ElementIndex e : indices(bodies_)) {
    const auto i = static_cast<std::size_t>(e.value);
    if (!has(e) || !bodies[i]) continue;
    motion.q[e] = as.q[e];
    if (!yields_.empty()) motion.points.blocks[i] = as.points.blocks[i];
  }
}

void BlockGroup::add_stored(const BodiesMotion& motion, StoredEnergy& stored) const {
  const UnknownsTable& q = motion.q;
  for (ElementIndex e : indices(q)) {
    const Body& body = bodies_[e];
    if (body.mass.rows() == 0) continue;
    stored.strain += strain_energy(body, q[e]);
    if (const BlockYield* yield = yield_of(e))
      stored.strain += yield->inelastic_energy(q[e], motion.points.blocks[static_cast<std::size_t>(e.value)]);
    stored.gravity -= body.weight.dot(q[e]);
  }
}

void BlockGroup::add_flow(const BodiesStep& step, EnergyFlow& flow) const {
  const StepRule& rule = step.rule;
  for (ElementIndex e : indices(bodies_)) {
    const Body& body = bodies_[e];
    if (body.mass.rows() == 0) continue;
    const Unknowns dq = step.q[e] - step.start.q[e];
    flow.external += (step.loads[e] - body.weight).dot(dq);
    flow.projection -= body.weight.dot(step.end[e] - step.q[e]);
    const Unknowns rate = sum_of(rule.strain_rate, dq, step.start, e);
    const Unknowns beyond =
        sum_of(rule.strain, dq, step.start, e) - dq / 2;  // strain that the elastic force sees beyond its mean
    flow.damping += body.mass_damping * dq.dot(body.mass * sum_of(rule.damping, dq, step.start, e)) +
                    body.stiffness_damping * dq.dot(body.elastic_force(rate));
    flow.algorithmic += inertia_loss(body, step, e) + dq.dot(body.elastic_force(beyond));
    if (yield_of(e)) add_yield_flow(step, e, flow);
  }
}

// A change of inelastic strain reduces the force by k D times itself. The part b/dt of k is damping that does not act,
// and the stored energy falls by that of the inelastic strain. The rest of the work is plastic, except for the time
// discretisation error of the step.
void BlockGroup::add_yield_flow(const BodiesStep& step, ElementIndex e, EnergyFlow& flow) const {
  const BlockYield& yield = *yield_of(e);
  const auto i = static_cast<std::size_t>(e.value);
  const YieldState& before = step.start.points.blocks[i];
  const YieldState& after = step.points.blocks[i];
  const Unknowns dq = step.q[e] - step.start.q[e];
  const Eigen::Vector4d at_start = yield.inelastic(step.start.q[e], before);
  const Unknowns flowed = yield.inelastic_force(yield.inelastic(step.q[e], after) - at_start);
  const InelasticShare share = inelastic_share(bodies_[e], step.rule, step.dt);
  const Unknowns missing = yield.missing_force(step.start.q[e], before, step.q[e], after);
  const double work = dq.dot(missing - yield.inelastic_force(at_start) - share.total() * flowed);
  const double stored = yield.inelastic_energy(step.q[e], after) - yield.inelastic_energy(step.start.q[e], before);
  const double plastic = yield.rock.plastic_work(yield.strain_at(step.q[e]), before, after);
  const double damping = -share.damping * dq.dot(flowed);
  flow.damping += damping;
  flow.plastic += plastic;
  flow.algorithmic += work - stored - plastic - damping;
}

Unknowns BlockGroup::inelastic_force(ElementIndex e, const BodiesMotion& motion) const {
  const BlockYield* yield = yield_of(e);
  if (yield == nullptr) return Unknowns::Zero(motion.q[e].size());
  const YieldState& before = motion.points.blocks[static_cast<std::size_t>(e.value)];
  return yield->inelastic_force(yield->inelastic(motion.q[e], yield->respond(motion.q[e], before).after));
}

void BlockGroup::add_acceleration(const UnknownsTable& loads, const BodiesMotion& motion,
                                  const Flexibility& mass_inverse, UnknownsTable& a) const {
  for (ElementIndex e : indices(a)) {
    const Body& body = bodies_[e];
    a[e] += mass_inverse.blocks[e] * (loads[e] + inelastic_force(e, motion) + body.initial_stress -
                                      body.elastic_force(motion.q[e]) - body.damping_force(motion.v[e]));
  }
}

std::unique_ptr<EstimatedStep> BlockGroup::begin(const BodiesMotion& start, const UnknownsTable& loads,
                                                 const StepRule& rule, double dt, FreeStep& step) const {
  const std::size_t count = bodies_.size();
  step.flexibility.blocks.resize(count);
  if (yields_.empty()) step.flexibility.inverses.resize(count);
  if (rule.judging_inertia > 0) step.judging.blocks.resize(count);
  for (UnknownsTable* table : {&step.increments, &step.known_velocity, &step.known_acceleration}) table->resize(count);
  auto yielding = yields_.empty() ? nullptr : std::make_unique<YieldingBlocks>(bodies_, yields_, start, rule, dt);
  for_each_entry(count, [&](std::size_t i) {
    const ElementIndex e{static_cast<int>(i)};
    StepEquations equations =
        step_equations(bodies_[e], {start.q[e], start.v[e], start.a[e]}, loads[e], rule, kept_[i]);
    if (yielding) yielding->put_elastic(e, equations);
    step.flexibility.blocks[e] = std::move(equations.inverse);
    if (!yielding) step.flexibility.inverses[e] = std::move(equations.matrix);
    if (!step.judging.blocks.empty()) step.judging.blocks[e] = std::move(equations.judging);
    step.increments[e] = std::move(equations.free);
    step.known_velocity[e] = std::move(equations.known_velocity);
    step.known_acceleration[e] = std::move(equations.known_acceleration);
  });
  return yielding;
}

// The centroid is an unknown. The moments are those of the polygon in its current position.
ElementState BlockGroup::state_of(const SceneParts& scene, ElementIndex e, const BodiesMotion& motion,
                                  const Placement& placed) const {
  const Basis& basis = *scene.model.elements[e].basis;
  const Unknowns& q = motion.q[e];
  return {scene.reference.centroids[e] + translation(basis, q),
          placed.moments,
          motion.v[e],
          Unknowns::Zero(q.size()),
          stress_at(scene, e, motion, {}),
          angle_of(basis, q)};
}

Stress BlockGroup::stress_at(const SceneParts& scene, ElementIndex e, const BodiesMotion& motion, Point) const {
  const double angle = angle_of(*scene.model.elements[e].basis, motion.q[e]);
  if (const BlockYield* yield = yield_of(e)) {
    const YieldState& state = motion.points.blocks[static_cast<std::size_t>(e.value)];
    const Eigen::Vector4d stress = yield->rock.stress(yield->strain_at(motion.q[e]), state);
    return turned({stress(0), stress(1), stress(2), stress(3)}, angle);
  }
  return turned(block_stress(scene.model, e, scene.reference, scene.settings, motion.q[e]), angle);
}

std::optional<PlasticState> BlockGroup::plastic_at(const SceneParts& scene, ElementIndex e, const BodiesMotion& motion,
                                                   Point start) const {
  const BlockYield* yield = yield_of(e);
  if (yield == nullptr || !yield->rock.law->may_yield) return std::nullopt;
  return plastic_state(memory_at(e, motion, start), angle_of(*scene.model.elements[e].basis, motion.q[e]));
}

void BlockGroup::add_plastic(const BodiesMotion& motion, PlasticTotals& totals) const {
  for (std::size_t i = 0; i < yields_.size(); ++i)
    if (yields_[i] && yields_[i]->rock.law->may_yield) totals.add(yields_[i]->rock.area, motion.points.blocks[i]);
}

double BlockGroup::plastic_work(const BodiesMotion& before, const BodiesMotion& after) const {
  double sum = 0;
  for (std::size_t i = 0; i < yields_.size(); ++i) {
    if (!yields_[i]) continue;
    const Eigen::Vector3d strain = yields_[i]->strain_at(after.q[ElementIndex{static_cast<int>(i)}]);
    sum += yields_[i]->rock.plastic_work(strain, before.points.blocks[i], after.points.blocks[i]);
  }
  return sum;
}

// The velocity is that of the block's mass, whose points lie where they would without strain.
std::vector<FieldPoint> BlockGroup::field_over(const SceneParts& scene, ElementIndex e,
                                               std::span<const std::vector<Point>> region, int degree,
                                               const BodiesMotion& motion) const {
  const Basis& basis = *scene.model.elements[e].basis;
  const Point centroid = scene.reference.centroids[e];
  const Unknowns& q = motion.q[e];
  const bool moves = q.size() > 0;
  Unknowns unstrained = q;
  if (moves) unstrained.tail(q.size() - kRigidUnknowns).setZero();
  std::vector<FieldPoint> field;
  for (const AreaPoint& point : polygon_rule(region, std::max(degree + 1, 2))) {
    FieldPoint& of = field.emplace_back(FieldPoint{point.at, point.weight, point.at, {}});
    if (!moves) continue;
    const BlockMap map(basis, q, centroid);
    of.place = map.place(point.at - centroid);
    of.gradient = map.gradient();
    const Eigen::Vector2d v = jacobian(basis, unstrained, point.at - centroid) * motion.v[e];
    of.velocity = {v.x(), v.y()};
  }
  return field;
}

void BlockGroup::carry(const SceneParts& scene, const BodiesBefore& before, BodiesMotion& carried) const {
  for (ElementIndex e : indices(before.parents)) {
    if (!has(e)) continue;
    const ElementIndex old = before.parents[e];
    const BodyGroup& group = before.groups.of(old);
    YieldState* memory = yield_of(e) ? &carried.points.blocks[static_cast<std::size_t>(e.value)] : nullptr;
    if (dynamic_cast<const BlockGroup*>(&group) != nullptr) {
      if (memory) *memory = group.memory_at(old, before.motion, {});
      carry_block(scene, e, before, carried);
      continue;
    }
    const auto loops = loops_of(scene.model, e);
    const std::vector<FieldPoint> field = group.field_over(before.scene, old, loops, 1, before.motion);
    carry_field(scene, e, field, carried);
    if (memory) *memory = carried_memory(old, field, before);
  }
}

}  // namespace keyblock
