// Sums over blocks, one small vector each.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/groups/block_group.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "base/loop.hpp"
#include "base/worse.hpp"
#include "geometry/quadrature.hpp"
#include "material/mean_memory.hpp"
#include "step/bodies/step_equations.hpp"
#include "step/groups/yielding_blocks.hpp"

namespace keyblock {
namespace {

double half_square(const UnknownBlock& matrix, const Unknowns& x) {
  return x.dot(matrix * x) / 2;
}

// ½ A σᵀ D⁻¹ σ, written in unknowns: a force f of the initial stress makes ½ (q − K⁻¹f)ᵀ K (q − K⁻¹f).
double strain_energy(const Body& body, const Unknowns& q) {
  const Eigen::Index strains = body.strain_count();
  if (strains == 0) return 0;
  const double without_initial = q.dot(body.elastic_force(q)) / 2;
  if (body.initial_stress.isZero(0)) return without_initial;
  const Unknowns force = body.initial_stress.tail(strains);
  return without_initial - body.initial_stress.dot(q) + force.dot(body.stiffness.llt().solve(force)) / 2;
}

double size_of_force(const Unknowns& force, double size) {
  if (force.size() == 0) return 0;
  return worse(force.head<2>().stableNorm(),
               force.tail(force.size() - 2).cwiseAbs().maxCoeff<Eigen::PropagateNaN>() / size);
}

// pᵀ M Δv/dt + (dt v̄ + p)ᵀ M r of `account_of`, from velocities and accelerations alone: that they fit the increments
// is what the closure checks.
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

double greatest(const Unknowns& change, double size) {
  return worse(change.head<2>().maxCoeff<Eigen::PropagateNaN>() / size,
               change.tail(change.size() - 2).maxCoeff<Eigen::PropagateNaN>());
}

std::vector<std::vector<Point>> loops_of(const Model& model, ElementIndex e) {
  std::vector<std::vector<Point>> loops;
  VertexIndex v = model.elements[e].first_vertex;
  for (const int size : model.elements[e].loop_sizes) {
    loops.emplace_back();
    for (int i = 0; i < size; ++i, ++v.value)
      loops.back().push_back(model.start_vertices[static_cast<std::size_t>(v.value)]);
  }
  return loops;
}

}  // namespace

BlockGroup::BlockGroup(Bodies bodies, std::vector<bool> of_others, std::vector<std::optional<BlockYield>> yields)
    : bodies_(std::move(bodies)), of_others_(std::move(of_others)), yields_(std::move(yields)) {
  for (const Body& body : bodies_)
    if (body.mass.rows() > 0) size_ = std::max(size_, body.size);
}

bool BlockGroup::has_supports() const {
  for (ElementIndex e : indices(bodies_))
    if (has(e) && bodies_[e].mass.rows() == 0) return true;
  return false;
}

void BlockGroup::add_to(MassRange& range, double contact_stiffness) const {
  for (const Body& body : bodies_) {
    const Eigen::Index last = body.mass.rows() - 1;
    if (last < 0) continue;
    range.lightest = std::min(range.lightest, body.mass(0, 0));
    range.heaviest = std::max(range.heaviest, body.mass(0, 0));
    range.all_strain = range.all_strain && body.slowest_frequency > 0;
    if (body.strain_count() > 0)
      range.slowest =
          std::min(range.slowest, std::sqrt(body.stiffness.diagonal().tail<1>()[0] / body.mass(last, last)));
    if (contact_stiffness > 0) range.slowest = std::min(range.slowest, std::sqrt(contact_stiffness / body.mass(0, 0)));
  }
}

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

void BlockGroup::carry_over(const SceneParts& scene, UnknownsTable& v) const {
  for (ElementIndex e : indices(v)) v[e] *= scene.settings.velocity_carry_over.of(scene.model.elements[e].material);
}

void BlockGroup::put_weight(UnknownsTable& loads) const {
  loads.reserve(bodies_.size());
  for (const Body& body : bodies_) loads.push_back(body.weight);
}

void BlockGroup::add_inertia(Point acceleration, UnknownsTable& loads) const {
  for (ElementIndex e : indices(loads))
    if (loads[e].size() > 0)
      loads[e].head<2>() += bodies_[e].mass(0, 0) * Eigen::Vector2d(acceleration.x, acceleration.y);
}

void BlockGroup::add_to(Scales& scales, const UnknownsTable& loads, const UnknownsTable&,
                        const UnknownsTable& v) const {
  for (ElementIndex e : indices(loads)) {
    if (loads[e].size() == 0) continue;
    const Body& body = bodies_[e];
    const double mass = body.mass(0, 0);
    const double force = std::hypot(loads[e][0], loads[e][1]) + std::abs(loads[e][2]) / body.size;
    scales.force = std::max(scales.force, force);
    scales.acceleration = std::max(scales.acceleration, force / mass);
    scales.momentum = std::max(scales.momentum, mass * (v[e].head<2>().norm() + body.size * std::abs(v[e][2])));
    scales.size = std::max(scales.size, body.size);
  }
}

void BlockGroup::put_mass_inverse(Flexibility& flexibility) const {
  flexibility.blocks = mass_inverses(bodies_);
}

void BlockGroup::put_momentum(const UnknownsTable& v, UnknownsTable& momentum) const {
  momentum.resize(v.size());
  for (ElementIndex e : indices(v)) momentum[e] = bodies_[e].mass * v[e];
}

double BlockGroup::kinetic_energy(const UnknownsTable& v) const {
  double energy = 0;
  for (ElementIndex e : indices(v))
    if (v[e].size() > 0) energy += half_square(bodies_[e].mass, v[e]);
  return energy;
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
        sum_of(rule.strain, dq, step.start, e) - dq / 2;  // what the elastic force sees beside its mean
    flow.damping += body.mass_damping * dq.dot(body.mass * sum_of(rule.damping, dq, step.start, e)) +
                    body.stiffness_damping * dq.dot(body.elastic_force(rate));
    flow.algorithmic += inertia_loss(body, step, e) + dq.dot(body.elastic_force(beyond));
    if (yield_of(e)) add_yield_flow(step, e, flow);
  }
}

// A change of inelastic strain bears k D times it less than elasticity alone would have, of which b/dt is damping that
// does not come about, and the stored energy is less by its own; the rest of its work is plastic, but for what a step
// of this size makes of it.
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

double BlockGroup::largest_momentum(const UnknownsTable& v) const {
  double largest = 0;
  for (ElementIndex e : indices(v))
    if (v[e].size() > 0) largest = std::max(largest, (bodies_[e].mass * v[e]).head<2>().norm());
  return largest;
}

double BlockGroup::largest_load(const UnknownsTable& loads) const {
  double largest = 0;
  for (ElementIndex e : indices(loads)) {
    const Body& body = bodies_[e];
    largest = std::max({largest, size_of_force(loads[e], body.size), size_of_force(body.initial_stress, body.size)});
  }
  return largest;
}

void BlockGroup::look_at_forces(const UnknownsTable& a, const SeenForce& seen) const {
  for (ElementIndex e : indices(a))
    if (has(e)) seen(e, size_of_force(bodies_[e].mass * a[e], bodies_[e].size));
}

void BlockGroup::look_at_bodies(const SceneParts& scene, const UnknownsTable& q, const UnknownsTable& forces,
                                const SeenBody& seen) const {
  for (ElementIndex e : indices(bodies_)) {
    const Body& body = bodies_[e];
    if (body.mass.rows() == 0) continue;
    WholeBody whole{body.mass(0, 0), body.mass(2, 2), body.size,
                    scene.reference.centroids[e] + Point{q[e][0], q[e][1]}};
    whole.resultant = forces[e].head<3>();
    whole.gross = whole.resultant.head<2>().norm();
    seen(whole);
  }
}

double BlockGroup::fastest_centre(const UnknownsTable& v) const {
  double fastest = 0;
  for (const Unknowns& of : v)
    if (of.size() > 0) fastest = std::max(fastest, of.head<2>().norm());
  return fastest;
}

double BlockGroup::fastest_point(const UnknownsTable& v) const {
  double top = 0;
  for (ElementIndex e : indices(v)) {
    const Eigen::Index n = v[e].size();
    if (n == 0) continue;
    double speed = std::hypot(v[e][0], v[e][1]);
    for (Eigen::Index i = 2; i < n; ++i) speed += bodies_[e].size * std::abs(v[e][i]);
    top = std::max(top, speed);
  }
  return top;
}

double BlockGroup::greatest_change(const UnknownsTable& a, const UnknownsTable& b) const {
  double change = 0;
  for (ElementIndex e : indices(a))
    if (a[e].size() > 0) change = worse(change, greatest((a[e] - b[e]).cwiseAbs(), bodies_[e].size));
  return change;
}

double BlockGroup::step_error(const BodiesMotion& before, const BodiesMotion& after, const StepRule& rule,
                              double dt) const {
  double largest = 0;
  for (ElementIndex e : indices(before.q)) {
    if (before.q[e].size() == 0) continue;
    const Unknowns change = after.a[e] - before.a[e];
    const Unknowns mean = rule.carries_acceleration() ? Unknowns(before.a[e] + change / 2) : after.a[e];
    const Unknowns jump = after.v[e] - before.v[e] - dt * mean;
    const Unknowns error =
        dt * dt * (rule.error_of_change * change.cwiseAbs() + rule.error_of_acceleration * mean.cwiseAbs()) +
        dt * jump.cwiseAbs();
    largest = worse(largest, error.head<2>().norm() / bodies_[e].size);
    largest = worse(largest, error.tail(error.size() - 2).maxCoeff<Eigen::PropagateNaN>());
  }
  return largest;
}

std::unique_ptr<EstimatedStep> BlockGroup::begin(const BodiesMotion& start, const UnknownsTable& loads,
                                                 const StepRule& rule, double dt, FreeStep& step) const {
  const std::size_t count = bodies_.size();
  step.flexibility.blocks.resize(count);
  if (rule.judging_inertia > 0) step.judging.blocks.resize(count);
  for (UnknownsTable* table : {&step.increments, &step.known_velocity, &step.known_acceleration}) table->resize(count);
  auto yielding = yields_.empty() ? nullptr : std::make_unique<YieldingBlocks>(bodies_, yields_, start, rule, dt);
  for_each_entry(count, [&](std::size_t i) {
    const ElementIndex e{static_cast<int>(i)};
    StepEquations equations = step_equations(bodies_[e], {start.q[e], start.v[e], start.a[e]}, loads[e], rule);
    if (yielding) yielding->put_elastic(e, equations);
    step.flexibility.blocks[e] = std::move(equations.inverse);
    if (!step.judging.blocks.empty()) step.judging.blocks[e] = std::move(equations.judging);
    step.increments[e] = std::move(equations.free);
    step.known_velocity[e] = std::move(equations.known_velocity);
    step.known_acceleration[e] = std::move(equations.known_acceleration);
  });
  return yielding;
}

// The centroid is an unknown; moments are those of the polygon as it lies.
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

// The velocity is that which the mass of the block has, whose points lie where they would without strain.
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

// The affine field nearest to that of the mass: its mean, and the least squares of what differs from it, keep momentum
// and angular momentum.
void BlockGroup::carry_field(const SceneParts& scene, ElementIndex e, const std::vector<FieldPoint>& field,
                             BodiesMotion& carried) const {
  const Basis& basis = *scene.model.elements[e].basis;
  Unknowns& q = carried.q[e];
  Unknowns& v = carried.v[e];
  if (q.size() == 0 || basis.rotation_unknown < 0) return;
  const Point centroid = scene.reference.centroids[e];
  double area = 0;
  Eigen::Vector2d shift = Eigen::Vector2d::Zero();
  Eigen::Vector2d velocity = Eigen::Vector2d::Zero();
  Eigen::Matrix2d places = Eigen::Matrix2d::Zero();  // Σ x Xᵀ, X from the centroid
  Eigen::Matrix2d rates = places;
  Eigen::Matrix2d moments = places;
  for (const FieldPoint& point : field) {
    const Eigen::Vector2d arm(point.start.x - centroid.x, point.start.y - centroid.y);
    const Eigen::Vector2d way(point.place.x - point.start.x, point.place.y - point.start.y);
    const Eigen::Vector2d rate(point.velocity.x, point.velocity.y);
    area += point.area;
    shift += point.area * way;
    velocity += point.area * rate;
    places += point.area * (arm + way) * arm.transpose();
    rates += point.area * rate * arm.transpose();
    moments += point.area * arm * arm.transpose();
  }
  const Eigen::Matrix2d f = places * moments.inverse();
  const double angle = std::atan2(f(1, 0) - f(0, 1), f(0, 0) + f(1, 1));
  const Eigen::Matrix2d turn = Eigen::Rotation2Dd(angle).toRotationMatrix();
  const Eigen::Matrix2d stretch = turn.transpose() * f;
  const Eigen::Matrix2d rate = turn.transpose() * rates * moments.inverse();
  q.setZero();
  v.setZero();
  q.head<3>() << shift / area, angle;
  v.head<3>() << velocity / area, (rate(1, 0) - rate(0, 1)) / 2;
  if (q.size() != kMostUnknowns) return;
  q.tail<3>() << stretch(0, 0) - 1, stretch(1, 1) - 1, stretch(0, 1) + stretch(1, 0);
  v.tail<3>() << rate(0, 0), rate(1, 1), rate(0, 1) + rate(1, 0);
}

// The mean over the block; its elastic strain is what the strain at hand leaves.
void BlockGroup::carry_memory(ElementIndex e, const std::vector<FieldPoint>& field, const BodiesBefore& before,
                              BodiesMotion& carried) const {
  const ElementIndex old = before.parents[e];
  MeanMemory mean;
  for (const FieldPoint& point : field)
    mean.add(point.area, before.groups.of(old).memory_at(old, before.motion, point.start));
  YieldState memory = mean.over(mean.weight());
  memory.elastic.setZero();
  carried.points.blocks[static_cast<std::size_t>(e.value)] = memory;
}

// The affine field of a block about the centroid of its piece; its velocity as the mass of the block has it, whose
// points lie where they would without strain: kinetic energy is kept to round-off.
void BlockGroup::carry(const SceneParts& scene, const BodiesBefore& before, BodiesMotion& carried) const {
  for (ElementIndex e : indices(before.parents)) {
    if (!has(e)) continue;
    const ElementIndex old = before.parents[e];
    const BodyGroup& group = before.groups.of(old);
    if (dynamic_cast<const BlockGroup*>(&group) == nullptr) {
      const auto loops = loops_of(scene.model, e);
      const std::vector<FieldPoint> field = group.field_over(before.scene, old, loops, 1, before.motion);
      carry_field(scene, e, field, carried);
      if (yield_of(e)) carry_memory(e, field, before, carried);
      continue;
    }
    if (yield_of(e)) carried.points.blocks[static_cast<std::size_t>(e.value)] = group.memory_at(old, before.motion, {});
    const Basis& basis = *before.scene.model.elements[old].basis;
    const Eigen::Index count = std::min(before.motion.q[old].size(), carried.q[e].size());
    if (count == 0) continue;
    const Point centroid = scene.reference.centroids[e];
    const Point offset = centroid - before.scene.reference.centroids[old];
    carried.q[e].head(count) = before.motion.q[old].head(count);
    carried.v[e].setZero();
    carried.v[e].head(count) = before.motion.v[old].head(count);
    if (offset == Point{}) continue;
    const Point place = point_at(before.scene.model, before.scene.reference, before.motion.q, old, centroid);
    carried.q[e].head<2>() << place.x - centroid.x, place.y - centroid.y;
    Unknowns unstrained = before.motion.q[old];
    unstrained.tail(unstrained.size() - kRigidUnknowns).setZero();
    carried.v[e].head<2>() = jacobian(basis, unstrained, offset) * before.motion.v[old];
  }
}

}  // namespace keyblock
