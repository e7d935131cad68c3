// Compares the kinetic energy of a block over its mass with the work of weight, loads and strains; tension with weight.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "job/verdict/block_watch.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "base/sentences/sentences.hpp"
#include "material/material_stress.hpp"
#include "model/body_load.hpp"
#include "model/scene/scene.hpp"

namespace keyblock {
namespace {

// Levers and chains of falling masses transfer energy to lighter blocks. Ten times the speed of their driver is more
// than rock reaches.
constexpr double kPassedOn = 100;
// Loads may do all of their work on one block; the energy balance is of first order in the step.
constexpr double kBooks = 2;
// Fraction of the size of a block: a speed that lifts it by less does not count.
constexpr double kLift = 1e-3;
// Rotation within a step, rad, due to contacts: the places of a lever as long as the block are then unresolved.
constexpr double kTurned = 0.5;
// Tension over weight above which a block counts as hanging.
constexpr double kHangs = 0.5;
// Fraction of its size: a block that would fall by less during the run is not judged.
constexpr double kFall = 0.01;

struct BlockMotion {
  Point velocity;
  double spin = 0;
};

BlockMotion motion_of(const Model& model, const State& state, const Settings& settings, ElementIndex e) {
  const Element& element = model.elements[e];
  const ElementState& now = state.elements[e];
  const Unknowns rates = end_velocity(now, state, settings, element.material);
  const Eigen::Vector2d velocity = element.basis->constant * rates;  // of the centroid
  const int spin = element.basis->rotation_unknown;
  return {{velocity.x() + now.carried.x, velocity.y() + now.carried.y},
          now.carried.rotation + (spin < 0 ? 0 : rates[spin])};
}

double kinetic_over_mass(const BlockMotion& motion, const Moments& start) {
  const Point& v = motion.velocity;
  return (v.x * v.x + v.y * v.y + motion.spin * motion.spin * (start.xx + start.yy) / start.area) / 2;
}

// Bounds the strain energy from above by the square of all stresses.
double strain_over_mass(const Stress& s, const BlockMaterial& material) {
  const double squares = s.xx * s.xx + s.yy * s.yy + s.zz * s.zz + 2 * s.xy * s.xy;
  return squares * (1 + material.poissons_ratio) / (2 * material.youngs_modulus * material.density);
}

/// Returns true if the speed of the element is a source for others: the first one, or that of driven or NMM bodies.
bool is_source(const Model& model, const State& state, ElementIndex e) {
  return state.step == 0 || model.elements[e].is_on_covers() ||
         std::ranges::any_of(model.fixed_points, [&](const CarriedPoint& point) { return point.element == e; });
}

}  // namespace

void BlockWatch::look_at_turn(const Stepper& stepper, ElementIndex e, double spin) {
  const State& state = stepper.state();
  const double rotation = state.elements[e].rotation;
  const int number = stepper.model().identities.of_element(e.value).number;
  const auto i = static_cast<std::size_t>(number);
  if (i >= rotations_.size()) {
    rotations_.resize(i + 1, rotation);
    spins_.resize(i + 1, 0);
  }
  const double angle = std::abs(rotation - (rotations_[i] + state.dt * spins_[i]));
  if (angle > turned_.angle && !stepper.model().elements[e].is_on_covers())
    turned_ = {angle, number, state.step, state.elements[e].centroid};
  rotations_[i] = rotation;
  spins_[i] = spin;
}

void BlockWatch::look_at_sources(const Stepper& stepper, ElementIndex e, Point weight) {
  const Model& model = stepper.model();
  const ElementState& now = stepper.state().elements[e];
  const Point way = now.centroid - stepper.unloaded().elements[e].centroid;
  fallen_ = std::max(fallen_, dot(weight, way));
  const auto number = static_cast<std::size_t>(model.identities.of_element(e.value).number);
  if (number >= strained_.size()) strained_.resize(number + 1, 0);
  const BlockMaterial& material = model.material_of(model.elements[e]);
  const double strain = strain_over_mass(now.stress, material);
  strained_[number] = std::max(strained_[number], strain);
  if (stepper.state().step == 0) {  // the start may have relaxed the initial stress
    const double height = stepper.unloaded().elements[e].centroid.y;
    const Stress drawn = start_stress(material, material.stress_gradient, height, stepper.settings().plane);
    strained_[number] = std::max(strained_[number], strain_over_mass(drawn, material));
  }
  released_ = std::max(released_, strained_[number] - strain);
}

void BlockWatch::add(const Stepper& stepper) {
  const Model& model = stepper.model();
  const State& state = stepper.state();
  const Settings& settings = stepper.settings();
  const bool may_turn = settings.standard.motion == MotionRule::dynamic;
  const bool has_ledger = settings.ledger == Bookkeeping::on;
  if (!may_turn && !has_ledger) return;
  std::vector<Point> weights;  // of materials, over mass
  for (const BlockMaterial& material : model.block_materials) {
    const Eigen::Vector2d weight = weight_per_area(material, settings) / material.density;
    weights.push_back({weight.x(), weight.y()});
  }
  kinetic_.clear();
  for (const ElementIndex e : indices(model.elements)) {
    const BlockMotion motion = motion_of(model, state, settings, e);
    if (may_turn) look_at_turn(stepper, e, motion.spin);
    kinetic_.push_back(kinetic_over_mass(motion, stepper.unloaded().elements[e].moments));
    if (has_ledger) look_at_sources(stepper, e, weights[static_cast<std::size_t>(model.elements[e].material)]);
  }
  if (has_ledger) look_at_speeds(stepper, weights);
}

// Tests the sources common to all blocks first: those of one block are no smaller, and few blocks exceed them.
void BlockWatch::look_at_speeds(const Stepper& stepper, const std::vector<Point>& weights) {
  const Model& model = stepper.model();
  const State& state = stepper.state();
  for (const ElementIndex e : indices(model.elements))
    if (const double kinetic = kinetic_[static_cast<std::size_t>(e.value)];
        kinetic > begun_ && is_source(model, state, e))
      begun_ = kinetic;
  const double of_all = kPassedOn * (begun_ + fallen_ + released_);
  for (const ElementIndex e : indices(model.elements)) {
    const double kinetic = kinetic_[static_cast<std::size_t>(e.value)];
    if (!(kinetic > worst_.excess * of_all) || is_source(model, state, e)) continue;
    const Element& element = model.elements[e];
    const double mass = model.material_of(element).density * stepper.unloaded().elements[e].moments.area;
    const double sources =
        of_all + kBooks * work_ / mass +
        kLift * length(weights[static_cast<std::size_t>(element.material)]) * std::sqrt(state.elements[e].moments.area);
    if (!(kinetic > worst_.excess * sources)) continue;
    worst_ = {sources > 0 ? kinetic / sources : 0,
              model.identities.of_element(e.value).number,
              state.step,
              state.elements[e].centroid,
              std::sqrt(2 * kinetic),
              std::sqrt(2 * sources)};
  }
}

void BlockWatch::add(const LedgerRow& row) {
  const double tight = has_row_ ? 0 : row.stored.contact;
  has_row_ = true;
  work_ = std::max(work_ + tight, row.flow.external + row.flow.change + tight);
}

void BlockWatch::add(const Frame& frame, const ContactFrames& contacts, const Model& model, const Settings& settings) {
  if (settings.dynamics != Dynamics::shi || frame.step == 0) return;
  ++frames_;
  last_ = {};
  std::map<int, Hanging> hanging;  // by number; `share` is a force until it is divided by the weight
  std::map<int, Point> weights;
  std::map<int, double> falls;
  for (std::size_t i = 0; i < frame.elements.size(); ++i) {
    const ElementFrame& element = frame.elements[i];
    const BlockMaterial& material = model.block_materials[static_cast<std::size_t>(element.material)];
    const Eigen::Vector2d weight = element.mass / material.density * weight_per_area(material, settings);
    weights[number_of(frame, i)] = {weight.x(), weight.y()};
    falls[number_of(frame, i)] = weight.norm() / element.mass * frame.time * frame.time / 2 / std::sqrt(element.area);
  }
  const auto pull = [&](int number, int other, Point at, Point force) {
    const Point weight = weights[number];
    if (length(weight) == 0) return;
    Hanging& block = hanging[number];
    block.share -= dot(force, weight) / dot(weight, weight);
    block.number = number;
    block.other = other;
    block.at = at;
    block.fall = falls[number];
  };
  std::map<int, double> pressed;  // by number: sum of the compressive contact forces
  for (const ContactFrame& contact : contacts) {
    if (contact.normal_force > 0)
      for (const int number : {contact.element, contact.other}) pressed[number] += contact.normal_force;
    if (!(contact.normal_force < 0) || model.joint_material(contact.joint_material).tensile_strength > 0) continue;
    const Point force = contact.normal_force * contact.normal;
    pull(contact.element, contact.other, contact.position, force);
    pull(contact.other, contact.element, contact.position, -1 * force);
  }
  std::set<int> held;
  for (const PointFrame& point : frame.fixed_points) held.insert(point.element);
  for (const auto& [number, block] : hanging) {
    const bool is_wedged = pressed[number] > kHangs * length(weights[number]);  // other blocks may carry it
    if (held.contains(number) || is_wedged || !(block.share > kHangs)) continue;
    const auto i = static_cast<std::size_t>(number);
    if (i >= hung_.size()) hung_.resize(i + 1, 0);
    ++hung_[i];
    if (2 * hung_[i] > frames_ && block.share > last_.share) last_ = block;
  }
}

void BlockWatch::describe(Archive& archive) {
  archive.value("begun", begun_);
  archive.value("fallen", fallen_);
  archive.value("released", released_);
  archive.value("work", work_);
  archive.value("has_row", has_row_);
  archive.numbers("strained", strained_);
  archive.group("thrown", [&] {
    archive.value("excess", worst_.excess);
    archive.value("number", worst_.number);
    archive.value("step", worst_.step);
    archive.value("x", worst_.at.x);
    archive.value("y", worst_.at.y);
    archive.value("speed", worst_.speed);
    archive.value("accounted", worst_.accounted);
  });
  archive.numbers("rotations", rotations_);
  archive.numbers("spins", spins_);
  archive.group("turned", [&] {
    archive.value("angle", turned_.angle);
    archive.value("number", turned_.number);
    archive.value("step", turned_.step);
    archive.value("x", turned_.at.x);
    archive.value("y", turned_.at.y);
  });
  archive.value("frames", frames_);
  archive.numbers("hung", hung_);
  archive.group("hanging_last", [&] {
    archive.value("share", last_.share);
    archive.value("fall", last_.fall);
    archive.value("number", last_.number);
    archive.value("other", last_.other);
    archive.value("x", last_.at.x);
    archive.value("y", last_.at.y);
  });
}

Warnings BlockWatch::doubts(const Settings& settings, bool keeps_energy, const Place& place) const {
  Warnings found;
  if (keeps_energy && std::isfinite(settings.trust.energy) && worst_.excess > 1)
    found.push_back(warning_of({"block_thrown",
                                {{{"step", worst_.step}, {"speed", worst_.speed}, {"accounted", worst_.accounted}},
                                 {},
                                 {worst_.number + 1},
                                 {{worst_.at.x, worst_.at.y}}}},
                               place));
  constexpr double kDegrees = 180 / std::numbers::pi;
  if (turned_.angle > kTurned)
    found.push_back(warning_of(
        {"turned_in_a_step",
         {{{"step", turned_.step}, {"degrees", turned_.angle * kDegrees}, {"limit_degrees", kTurned * kDegrees}},
          {},
          {turned_.number + 1},
          {{turned_.at.x, turned_.at.y}}}},
        place));
  if (last_.share > kHangs && last_.fall > kFall)
    found.push_back(warning_of(
        {"tension_without_strength",
         {{{"share", last_.share}, {"concerned", hung_[static_cast<std::size_t>(last_.number)]}, {"frames", frames_}},
          {},
          {last_.number + 1, last_.other + 1},
          {{last_.at.x, last_.at.y}}}},
        place));
  return found;
}

}  // namespace keyblock
