// Sets up statics, steps until a failure, and keeps states for pictures.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/strength/strength_trial.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <utility>

#include "base/context.hpp"
#include "base/counted.hpp"
#include "base/words/plain_number.hpp"
#include "geometry/polygon.hpp"
#include "run/record.hpp"
#include "run/settings_of.hpp"
#include "run/steppers.hpp"

namespace keyblock::study {
namespace {

// Greatest number of load increments that replace the steps of a dynamic case with NMM bodies.
constexpr int kLoadParts = 10;
// Halvings of a load step before a trial falls: the factor is bisected, not the load. Two of them take three times the
// iterations and do not change the factors of legacy_cases/strength_reduction.
constexpr int kLoadCuts = 0;

bool is_constant(const TimeCurve& curve) {
  return std::ranges::all_of(curve.values, [&](Point value) { return value == curve.values.front(); });
}

bool has_constant_loads(const Problem& problem, const Settings& settings) {
  const Analysis& analysis = *problem.analysis;
  return std::ranges::all_of(analysis.fixed_point_motions, is_constant) &&
         std::ranges::all_of(analysis.point_loads, is_constant) && is_constant(analysis.body_acceleration) &&
         is_constant(settings.body_acceleration.curve) && !problem.motion;
}

bool is_on_covers(const Problem& problem) {
  return problem.covers || std::holds_alternative<Cover>(problem.geometry);
}

// Slivers are left out: one that drops into a gap is not representative of the others.
double largest_displacement(const Stepper& stepper, const State& state) {
  const Model& model = stepper.model();
  double most = 0;
  for (const VertexIndex v : indices(model.vertices)) {
    const ElementIndex e = model.vertices[v].element;
    const double area = stepper.unloaded().elements[e].moments.area;
    if (!model.elements[e].is_on_covers() && area < kLooseArea * model.mean_area) continue;
    most = std::max(most, length(state.vertices[v] - stepper.unloaded().vertices[v]));
  }
  return most;
}

bool carries_a_point(const Blocks& blocks, int block) {
  const auto is_on = [&](const BlockPoint& point) { return point.block == block; };
  const auto holds = [&](const BlockBolt& bolt) { return bolt.first_block == block || bolt.second_block == block; };
  return std::ranges::any_of(blocks.fixed_points, is_on) || std::ranges::any_of(blocks.loading_points, is_on) ||
         std::ranges::any_of(blocks.measured_points, is_on) || std::ranges::any_of(blocks.bolts, holds);
}

double area_of(const BlockPolygon& block) {
  double sum = area(points_of(block.outer));
  for (const BlockLoop& hole : block.holes) sum += area(points_of(hole));  // clockwise
  return sum;
}

double area_of(const Blocks& blocks) {
  double sum = 0;
  for (const BlockPolygon& block : blocks.blocks) sum += area_of(block);
  return sum;
}

// Returns the blocks without some, which carry nothing; points and bolts follow the new numbers.
Blocks without(const Blocks& whole, const std::vector<int>& left_out) {
  Blocks rest = whole;
  rest.blocks.clear();
  std::vector<int> place(whole.blocks.size(), -1);
  for (std::size_t i = 0; i < whole.blocks.size(); ++i) {
    if (std::ranges::find(left_out, static_cast<int>(i)) != left_out.end()) continue;
    place[i] = static_cast<int>(rest.blocks.size());
    rest.blocks.push_back(whole.blocks[i]);
  }
  const auto moved = [&](int& block) { block = place[static_cast<std::size_t>(block)]; };
  for (auto* points : {&rest.fixed_points, &rest.loading_points, &rest.measured_points})
    for (BlockPoint& point : *points) moved(point.block);
  for (BlockBolt& bolt : rest.bolts) {
    moved(bolt.first_block);
    moved(bolt.second_block);
  }
  return rest;
}

// The stress is that of the last accepted state.
FieldFrame field_at(FieldFrame field, const Stepper& stepper, const State& state) {
  for (const ElementIndex e : indices(stepper.model().elements)) {
    FieldElement& out = field.elements[static_cast<std::size_t>(e.value)];
    out.middle.displacement = state.elements[e].centroid - out.middle.position;
    VertexIndex v = stepper.model().elements[e].first_vertex;
    for (auto& loop : out.loops)
      for (FieldCorner& corner : loop) {
        corner.displacement = state.vertices[v] - corner.position;
        ++v.value;
      }
  }
  return field;
}

StrengthState state_of(const Stepper& stepper) {
  StrengthState state{frame_of(stepper.model(), stepper.state(), stepper.unloaded(), stepper.settings()),
                      field_of(stepper.model(), stepper),
                      {}};
  put_point_stress(state.frame, stepper.model(), stepper);
  put_plastic(state.frame, stepper);
  for (const ElementIndex e : indices(stepper.model().elements)) {
    const std::optional<PlasticState> plastic = stepper.plastic_at(e, stepper.unloaded().elements[e].centroid);
    state.plastic_strains.push_back(plastic ? plastic->equivalent : 0);
  }
  return state;
}

// Returns a state out of balance as a frame. Its step is the one that failed.
Frame frame_at(const Stepper& stepper, const State& state) {
  Frame frame = frame_of(stepper.model(), state, stepper.unloaded(), stepper.settings());
  frame.step = stepper.state().step + 1;
  frame.time = stepper.state().time + stepper.settings().time_step;
  return frame;
}

/// Steps to the end of the scene, or to the first failure.
TrialOutcome stepped(std::unique_ptr<Stepper> stepper) {
  TrialOutcome made;
  while (stepper->state().step < stepper->settings().step_count && !stepper->is_done()) {
    leave_if_stopped();
    const auto step = stepper->advance();
    if (const auto* report = std::get_if<StepReport>(&step)) {
      made.told.rounds += report->passes;
      continue;
    }
    const auto& failure = std::get<StepFailure>(step);
    made.told.rounds += failure.passes;
    made.told.verdict = is_of_the_scene(failure.kind) ? Verdict::falls : Verdict::undecided;
    made.told.why = failure.reason;
    made.rock_yields = failure.rock_yields;
    for (const ElementIndex e : failure.elements) made.restless.push_back(stepper->model().number_of(e) - 1);
    const std::optional<State> attempted = stepper->attempted();
    made.told.displacement = largest_displacement(*stepper, attempted ? *attempted : stepper->state());
    made.state = state_of(*stepper);
    if (attempted) made.attempt = field_at(made.state.field, *stepper, *attempted);
    if (attempted) made.attempt_frame = frame_at(*stepper, *attempted);
    return made;
  }
  made.told.verdict = Verdict::stands;
  made.told.is_balanced = true;
  made.told.displacement = largest_displacement(*stepper, stepper->state());
  made.state = state_of(*stepper);
  made.told.farthest = farthest_carried(stepper->model(), made.state.frame, made.state.field).value_or(CarriedBlock());
  return made;
}

}  // namespace

std::string name_of(Verdict verdict) {
  constexpr std::array<const char*, 3> kNames{"stands", "falls", "undecided"};
  return kNames.at(static_cast<std::size_t>(verdict));
}

StrengthTrials::StrengthTrials(ConfiguredCase made, Reduced what, Exempt exempt)
    : made_(std::move(made)), what_(what), exempt_(std::move(exempt)) {
  require_exempt(exempt_, made_.problem);
  require_strength(made_.problem, what_, exempt_);
  if (made_.problem.analysis) {
    const Settings settings = settings_of(made_.problem, made_.profile.name, made_.overrides);
    if (settings.dynamics != Dynamics::standard)
      throw InputError(made_.problem.analysis->place,
                       "expected a profile with statics (standard, draft or reference), found legacy");
    const bool is_in_time = settings.standard.motion == MotionRule::dynamic;
    if (is_in_time) {
      replace_setting(settings, "motion", "static");
      notes_.emplace_back("dynamic case: the factor of safety is that of static equilibrium under the same loads");
    }
    if (is_in_time && made_.problem.stages.empty() && has_constant_loads(made_.problem, settings)) {
      const int steps = is_on_covers(made_.problem) ? std::min(settings.step_count, kLoadParts) : 1;
      replace_setting(settings, "steps", fmt::format("{}", steps));
    }
  }
  // The rock is elastic here, so that the mesh is the same at every factor.
  MeshByError found = with_mesh_found(made_.problem, made_.profile.name, made_.overrides);
  made_.problem = found.problem;
  ExemptCount held;
  prepared_ = prepared_at(1, &held);
  tell(found, prepared_);
  note_exempt(held);
  if (what_ == Reduced::joints && prepared_.scene.is_untouched)
    throw InputError(
        made_.problem.analysis->place,
        "expected bodies in contact, whose joints are to be reduced, found NMM bodies whose contact is ignored");
}

void StrengthTrials::replace_setting(const Settings& of_case, const char* name, const std::string& value) {
  const std::vector<SettingText> all = list(of_case);
  replaced_.push_back(*std::ranges::find(all, name, &SettingText::name));
  std::erase_if(made_.overrides, [&](const Override& o) { return o.first == name; });
  made_.overrides.emplace_back(name, value);
}

void StrengthTrials::note_exempt(const ExemptCount& held) {
  if (exempt_.is_empty()) return;
  std::string words = fmt::format("exempt from reduction: {}", fmt::join(exempt_.words, ", "));
  if (!exempt_.regions.empty()) {
    if (held.elements == 0 && held.edges == 0)
      throw std::invalid_argument(
          fmt::format("--exempt: expected a region that holds the centre of a block or element, or the middle of a "
                      "joint edge, found none in {}",
                      exempt_.regions.front().words));
    words +=
        fmt::format("; the regions hold {} and {}", counted(held.elements, made_.problem.covers ? "element" : "block"),
                    counted(held.edges, "joint edge"));
  }
  notes_.push_back(std::move(words));
}

Prepared StrengthTrials::prepared_at(double factor, ExemptCount* held) const {
  ConfiguredCase reduced = made_;
  reduced.problem = with_reduced_strength(made_.problem, what_, exempt_, factor);
  Prepared prepared = prepared_case(reduced);
  if (!exempt_.regions.empty() && made_.problem.analysis) {
    const ExemptCount count =
        exempt_regions(prepared, exempt_, static_cast<int>(made_.problem.analysis->block_materials.size()),
                       static_cast<int>(made_.problem.analysis->joint_materials.size()));
    if (held != nullptr) *held = count;
  }
  if (!whole_) return prepared;
  std::vector<Identity>& elements = prepared.scene.model.identities.elements;
  elements.clear();
  for (int i = 0; i < static_cast<int>(whole_->blocks.size()); ++i)
    if (std::ranges::find(left_out_, i) == left_out_.end()) elements.push_back({i, i});
  return prepared;
}

bool StrengthTrials::may_leave_out(const std::vector<int>& blocks) const {
  const Blocks& whole = whole_ ? *whole_ : prepared_.blocks;
  if (blocks.empty() || whole.blocks.empty() || is_on_covers(made_.problem) || !made_.problem.stages.empty())
    return false;
  const double all = area_of(whole);
  double sum = 0;
  for (const int block : left_out_) sum += area_of(whole.blocks[static_cast<std::size_t>(block)]);
  for (const int block : blocks) {
    const double own = area_of(whole.blocks[static_cast<std::size_t>(block)]);
    sum += own;
    if (own >= kLooseArea * all / static_cast<double>(whole.blocks.size()) || carries_a_point(whole, block))
      return false;
  }
  return sum <= kLooseInAll * all;
}

void StrengthTrials::leave_out(const std::vector<int>& blocks) {
  if (!whole_) whole_ = prepared_.blocks;
  const double mean = area_of(*whole_) / static_cast<double>(whole_->blocks.size());
  for (const int block : blocks) {
    const BlockPolygon& polygon = whole_->blocks[static_cast<std::size_t>(block)];
    const Point at = centroid(points_of(polygon.outer));
    notes_.push_back(
        fmt::format("block {} at {}, {} has no support and is small (area {}, {:.2g} % of the mean): it is left out, "
                    "so that the factor is that of the others",
                    block + 1, plain(at.x), plain(at.y), plain(area_of(polygon), 3), 100 * area_of(polygon) / mean));
  }
  left_out_.insert(left_out_.end(), blocks.begin(), blocks.end());
  made_.problem.geometry = without(*whole_, left_out_);
  prepared_ = prepared_at(1);
}

bool StrengthTrials::may_yield() const {
  return what_ != Reduced::joints &&
         std::ranges::any_of(made_.problem.analysis->block_materials,
                             [](const BlockMaterial& rock) { return rock.strength != nullptr; });
}

bool StrengthTrials::depends_on_mesh() const {
  return may_yield() && is_on_covers(made_.problem);
}

StrengthTrials StrengthTrials::on_coarser_mesh(double times) const {
  StrengthTrials coarser = *this;
  if (!made_.problem.covers || (made_.problem.covers->mesh.side == 0 && made_.problem.covers->mesh.half_rows < 2))
    throw InputError(made_.problem.analysis->place, "expected a mesh whose side is given, found none");
  MeshPlan& mesh = coarser.made_.problem.covers->mesh;
  mesh.side *= times;
  mesh.tip_side *= times;
  mesh.half_rows = mesh.half_rows > 0 ? std::max(1, static_cast<int>(std::lround(mesh.half_rows / times))) : 0;
  for (RefinedPoint& point : mesh.refined) point.side *= times;
  coarser.prepared_ = coarser.prepared_at(1);
  return coarser;
}

TrialOutcome StrengthTrials::run(double factor, std::optional<long long> most_systems) const {
  const Context trial = context().part({.systems = most_systems});
  try {
    const Under under(trial);
    TrialOutcome made = decided(factor);
    made.told.systems = trial.systems();
    return made;
  } catch (const StopRequested&) {
    if (context().is_stopped() || !most_systems || trial.systems() < *most_systems)
      throw;  // stops the search, not only this trial
    TrialOutcome given_up;
    given_up.told.factor = factor;
    given_up.told.systems = trial.systems();
    given_up.told.why = fmt::format("given up after {} linear solves (--trial-limit)", trial.systems());
    return given_up;
  }
}

TrialOutcome StrengthTrials::decided(double factor) const {
  Scene scene = prepared_at(factor).scene;
  scene.load_cuts = kLoadCuts;
  TrialOutcome made = stepped(stepper_for(std::move(scene)));
  // For elastoplastic rock, a search without equilibrium is the only available sign of failure. If no rock yields, the
  // cause is contact forces that did not converge, and nothing is decided.
  if (made.told.verdict == Verdict::undecided && may_yield() && made.rock_yields) made.told.verdict = Verdict::falls;
  made.told.factor = factor;
  return made;
}

}  // namespace keyblock::study
