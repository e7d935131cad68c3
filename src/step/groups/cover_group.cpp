// Forwards the group interface to the NMM bodies of a scene.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/groups/cover_group.hpp"

#include <algorithm>
#include <cmath>

#include "base/worse.hpp"
#include "step/bodies/cover_flexibility.hpp"
#include "step/groups/kept_covers.hpp"
#include "system/sparse_lu.hpp"

namespace keyblock {
namespace {

class CoverStep final : public EstimatedStep {
 public:
  explicit CoverStep(CoverEquations& equations) : equations_(equations) {}

  bool linearise(const UnknownsTable& estimate, FreeStep& step) override {
    bool has_factor = true;
    try {
      equations_.linearise(estimate.shared);
    } catch (const NotPositiveDefinite&) {
      has_factor = false;
    } catch (const SingularMatrix&) {
      has_factor = false;
    }
    step.flexibility.shared = flexibility_of(equations_);
    if (!step.judging.blocks.empty()) step.judging.shared = step.flexibility.shared;
    return has_factor;
  }

  void evaluate(const UnknownsTable& estimate, FreeStep& step) override {
    equations_.evaluate(estimate.shared);
    step.increments.shared = equations_.free_increment();
  }

  void put_end(const UnknownsTable& increments, UnknownsTable& v, UnknownsTable& a,
               PointMemories& points) const override {
    CoverMotion end = equations_.end(increments.shared);
    v.shared = std::move(end.v);
    a.shared = std::move(end.a);
    points.covers = std::move(end.points);
  }

 private:
  CoverEquations& equations_;
};

/// Returns, per NMM element, the element of `same` that it is a part of; -1 if that belongs to no NMM body.
std::vector<int> parents_in(const CoverScene& same, const std::vector<ElementIndex>& own, const BodiesBefore& before) {
  std::vector<int> parents;
  for (const ElementIndex e : own) {
    const ElementIndex parent = before.parents[e];
    parents.push_back(same.kinematics()->carries(parent) ? same.kinematics()->manifold_element(parent) : -1);
  }
  return parents;
}

std::vector<std::vector<FieldPoint>> fields_over(const ChangedPart& part, const CoverScene& bodies,
                                                 const std::vector<ElementIndex>& own, const BodiesBefore& before) {
  const Manifold& manifold = bodies.continuum().manifold;
  std::vector<std::vector<FieldPoint>> fields;
  for (const int e : part.elements) {
    const ElementIndex parent = before.parents[own[static_cast<std::size_t>(e)]];
    const auto region = manifold.polygon(manifold.elements[static_cast<std::size_t>(e)]);
    fields.push_back(
        before.groups.of(parent).field_over(before.scene, parent, region, bodies.basis().degree(), before.motion));
  }
  return fields;
}

/// Collects point memories for elements in new triangles and copies the memories of the others.
YieldStates carried_memories(const CoverScene& bodies, const CoverScene* same, const KeptCovers& kept,
                             const ChangedPart& part, std::span<const std::vector<FieldPoint>> fields,
                             const std::vector<ElementIndex>& own, const BodiesBefore& before) {
  std::vector<std::vector<CoverYield::Remembered>> remembered(own.size());
  for (std::size_t i = 0; i < part.elements.size(); ++i) {
    const auto e = static_cast<std::size_t>(part.elements[i]);
    const ElementIndex parent = before.parents[own[e]];
    if (kept.in_triangle[e] >= 0) continue;
    for (const FieldPoint& point : fields[i])
      remembered[e].push_back(
          {point.start, point.area, before.groups.of(parent).memory_at(parent, before.motion, point.start)});
  }
  YieldStates states = bodies.yield().gathered(remembered);
  for (std::size_t e = 0; e < own.size(); ++e)
    if (kept.in_triangle[e] >= 0)
      bodies.yield().carry(static_cast<int>(e), same->yield(), kept.in_triangle[e], before.motion.points.covers,
                           states);
  return states;
}

/// Returns the functions of all bodies with a chosen element.
std::vector<int> functions_of(const CoverScene& scene, const ChosenElements& chosen) {
  std::vector<bool> is_chosen(scene.at_start().size());
  for (std::size_t i = 0; i < chosen.size(); ++i)
    if (const ElementIndex e{static_cast<int>(i)}; chosen[i] && scene.kinematics()->carries(e))
      is_chosen[static_cast<std::size_t>(scene.body_of(e))] = true;
  std::vector<int> functions;
  for (std::size_t b = 0; b < is_chosen.size(); ++b) {
    const std::vector<int>& own = scene.bodies().rigid.functions()[b];
    if (is_chosen[b]) functions.insert(functions.end(), own.begin(), own.end());
  }
  return functions;
}

}  // namespace

CoverEquations& CoverGroup::equations() const {
  if (!equations_) equations_ = std::make_unique<CoverEquations>(bodies_->bodies());
  return *equations_;
}

std::optional<ElasticLaw> CoverGroup::law_of_large_strain(const SceneParts& scene, ElementIndex e) const {
  if (scene.model.material_of(scene.model.elements[e]).is_nonlinear()) return ElasticLaw::logarithmic;  // in CoverYield
  return scene.settings.standard.elastic_law.of(scene.model.elements[e].material);
}

void CoverGroup::add_to(MassRange& range, double) const {
  for (const WholeBody& body : bodies_->at_start()) {
    range.lightest = std::min(range.lightest, body.mass);
    range.heaviest = std::max(range.heaviest, body.mass);
  }
  range.slowest = std::min(range.slowest, bodies_->slow_frequency());
}

void CoverGroup::put_start(const SceneParts&, BodiesMotion& motion) const {
  motion.v.shared = bodies_->start_velocity();
  motion.q.shared = motion.a.shared = Eigen::VectorXd::Zero(motion.v.shared.size());
  motion.points.covers = bodies_->yield().start();
}

void CoverGroup::carry_over(const SceneParts&, UnknownsTable& v) const {
  v.shared = bodies_->carried_over(std::move(v.shared));
}

void CoverGroup::add_inertia(Point acceleration, UnknownsTable& loads) const {
  loads.shared += bodies_->inertia_of(acceleration);
}

void CoverGroup::add_to(Scales& scales, const UnknownsTable& loads, const UnknownsTable& q,
                        const UnknownsTable& v) const {
  const auto size_of = [](const WholeBody& body) {
    return body.resultant.head<2>().norm() + std::abs(body.resultant[2]) / body.size;
  };
  for (const WholeBody& body : bodies_->whole(q.shared, loads.shared)) {
    const double force = size_of(body);
    scales.force = std::max(scales.force, force);
    scales.acceleration = std::max(scales.acceleration, force / body.mass);
    scales.size = std::max(scales.size, body.size);
  }
  scales.force = std::max(scales.force, bodies_->largest_load(bodies_->initial_force()));
  for (const WholeBody& body : bodies_->whole(q.shared, bodies_->momentum(v.shared)))
    scales.momentum = std::max(scales.momentum, size_of(body));
}

void CoverGroup::put_momentum(const UnknownsTable& v, UnknownsTable& momentum) const {
  momentum.shared = bodies_->momentum(v.shared);
}

void CoverGroup::add_stored(const BodiesMotion& motion, StoredEnergy& stored) const {
  stored.strain += bodies_->strain_energy(motion.q.shared, motion.points.covers);
  stored.gravity -= bodies_->weight().dot(motion.q.shared);
}

// The sums are those of a block, with the elastic force of large rotations.
void CoverGroup::add_flow(const BodiesStep& step, EnergyFlow& flow) const {
  const StepRule& rule = step.rule;
  const Eigen::VectorXd dq = step.q.shared - step.start.q.shared;
  const Eigen::VectorXd dv = step.v.shared - step.start.v.shared;
  const Eigen::VectorXd da = step.a.shared - step.start.a.shared;
  const Eigen::VectorXd lead = rule.velocity_lead * dv + rule.acceleration_lead * da;
  const Eigen::VectorXd way = step.dt / 2 * (step.start.v.shared + step.v.shared) + lead;
  flow.external += (step.loads.shared - bodies_->weight()).dot(dq);
  flow.projection += bodies_->strain_energy(step.end.shared, step.points.covers) -
                     bodies_->strain_energy(step.q.shared, step.points.covers) -
                     bodies_->weight().dot(step.end.shared - step.q.shared);
  flow.damping += bodies_->damping_work(step.start.q.shared, step.q.shared,
                                        rule.damping.increment * dq + rule.damping.velocity * step.start.v.shared +
                                            rule.damping.acceleration * step.start.a.shared,
                                        step.dt);
  const CoverScene::StrainLoss lost = bodies_->strain_loss(
      {step.start.q.shared, step.start.points.covers, step.q.shared, rule.stiffness}, step.points.covers);
  flow.plastic += lost.plastic;
  flow.algorithmic +=
      lead.dot(bodies_->momentum(dv)) / step.dt + rule.inertia_lead * way.dot(bodies_->momentum(da)) + lost.algorithmic;
}

void CoverGroup::add_acceleration(const UnknownsTable& loads, const BodiesMotion& motion,
                                  const Flexibility& mass_inverse, UnknownsTable& a) const {
  a.shared += mass_inverse.shared->times(loads.shared - bodies_->elastic_force(motion.q.shared, motion.points.covers) -
                                         bodies_->damping_force(motion.v.shared));
}

double CoverGroup::largest_load(const UnknownsTable& loads) const {
  return std::max(bodies_->largest_load(loads.shared), bodies_->largest_load(bodies_->initial_force()));
}

void CoverGroup::look_at_forces(const UnknownsTable& a, const SeenForce& seen) const {
  for (const auto& [element, force] : bodies_->largest_forces(bodies_->momentum(a.shared))) seen(element, force);
}

void CoverGroup::look_at_bodies(const SceneParts&, const UnknownsTable& q, const UnknownsTable& forces,
                                const SeenBody& seen) const {
  for (const WholeBody& body : bodies_->whole(q.shared, forces.shared)) seen(body);
}

double CoverGroup::greatest_change(const UnknownsTable& a, const UnknownsTable& b) const {
  return bodies_->felt(a.shared - b.shared).maxCoeff<Eigen::PropagateNaN>() / bodies_->size();
}

double CoverGroup::step_error(const BodiesMotion& before, const BodiesMotion& after, const StepRule& rule,
                              double dt) const {
  const Eigen::VectorXd change = after.a.shared - before.a.shared;
  const Eigen::VectorXd mean =
      rule.carries_acceleration() ? Eigen::VectorXd(before.a.shared + change / 2) : after.a.shared;
  const Eigen::VectorXd error =
      dt * dt * (rule.error_of_change * bodies_->felt(change) + rule.error_of_acceleration * bodies_->felt(mean)) +
      dt * bodies_->felt(after.v.shared - before.v.shared - dt * mean);
  return error.maxCoeff<Eigen::PropagateNaN>() / bodies_->size();
}

void CoverGroup::unload(const ChosenElements& bodies, UnknownsTable& loads) const {
  for (const int f : functions_of(*bodies_, bodies)) loads.shared.segment<2>(2 * f).setZero();
}

void CoverGroup::put_back(const ChosenElements& bodies, const BodiesMotion& as, BodiesMotion& motion) const {
  for (const int f : functions_of(*bodies_, bodies)) motion.q.shared.segment<2>(2 * f) = as.q.shared.segment<2>(2 * f);
  if (!may_yield()) return;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const ElementIndex e{static_cast<int>(i)};
    if (!bodies[i] || !has(e)) continue;
    const int element = bodies_->kinematics()->manifold_element(e);
    bodies_->yield().carry(element, bodies_->yield(), element, as.points.covers, motion.points.covers);
  }
}

std::unique_ptr<EstimatedStep> CoverGroup::begin(const BodiesMotion& start, const UnknownsTable& loads,
                                                 const StepRule& rule, double dt, FreeStep& step) const {
  CoverEquations& equations = this->equations();
  equations.begin({start.q.shared, start.v.shared, start.a.shared, start.points.covers}, loads.shared, rule, dt);
  step.known_velocity.shared = equations.known_velocity();
  step.known_acceleration.shared = equations.known_acceleration();
  return std::make_unique<CoverStep>(equations);
}

ElementState CoverGroup::state_of(const SceneParts& scene, ElementIndex e, const BodiesMotion& motion,
                                  const Placement& placed) const {
  const MotionOfPoint now = motion_of_point(*bodies_, e, motion.q.shared, motion.v.shared, motion.points.covers,
                                            scene.reference.centroids[e]);
  return {placed.centroid, placed.moments, motion.v[e], motion.v[e], now.stress, now.rotation, now.velocity};
}

Stress CoverGroup::stress_at(const SceneParts&, ElementIndex e, const BodiesMotion& motion, Point start) const {
  return bodies_->stress(e, motion.q.shared, motion.points.covers, start);
}

std::optional<PlasticState> CoverGroup::plastic_at(const SceneParts&, ElementIndex e, const BodiesMotion& motion,
                                                   Point start) const {
  const int element = bodies_->kinematics()->manifold_element(e);
  if (!bodies_->continuum().material(element).strength) return std::nullopt;
  return bodies_->yield().plastic_state(motion.points.covers, element, start,
                                        bodies_->rotation(e, motion.q.shared, start));
}

void CoverGroup::add_plastic(const BodiesMotion& motion, PlasticTotals& totals) const {
  bodies_->yield().add_totals(motion.points.covers, totals);
}

double CoverGroup::plastic_work(const BodiesMotion& before, const BodiesMotion& after) const {
  if (!may_yield()) return 0;
  return bodies_->yield().plastic_work(after.q.shared, before.points.covers, after.points.covers);
}

std::vector<FieldPoint> CoverGroup::field_over(const SceneParts&, ElementIndex e,
                                               std::span<const std::vector<Point>> region, int degree,
                                               const BodiesMotion& motion) const {
  return keyblock::field_over(*bodies_, elements_[static_cast<std::size_t>(bodies_->body_of(e))], region, degree,
                              motion.q.shared, motion.v.shared);
}

// Elements in unchanged triangles copy their state. Other elements, and bodies that were DDA blocks, take it from
// points.
void CoverGroup::carry(const SceneParts&, const BodiesBefore& before, BodiesMotion& carried) const {
  const CoverScene* same = nullptr;
  for (const BodyGroups::Group& group : before.groups)
    if (const auto* one = dynamic_cast<const CoverGroup*>(group.get())) same = one->bodies_.get();
  std::vector<ElementIndex> own;
  for (ElementIndex e : indices(before.parents))
    if (has(e)) own.push_back(e);
  const KeptCovers kept = same ? kept_covers(*same, parents_in(*same, own, before), *bodies_) : nothing_kept(*bodies_);
  const ChangedPart part = changed_part(*bodies_, kept.elements);
  const std::vector<std::vector<FieldPoint>> fields = fields_over(part, *bodies_, own, before);
  const BodiesMotion& motion = before.motion;
  CarriedCovers covers =
      carried_covers({copied(kept, motion.q.shared), copied(kept, motion.v.shared)}, part, fields, *bodies_);
  if (may_yield()) carried.points.covers = carried_memories(*bodies_, same, kept, part, fields, own, before);
  carried.q.shared = std::move(covers.d);
  carried.v.shared = std::move(covers.v);
}

}  // namespace keyblock
