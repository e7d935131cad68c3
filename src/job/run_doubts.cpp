// Compares a run with each of its limits and reports one finding per exceeded limit.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "job/run_doubts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "base/sentences/sentences.hpp"
#include "geometry/shared_area.hpp"
#include "job/verdict/crack_doubts.hpp"
#include "job/verdict/end_of_motion.hpp"
#include "job/verdict/energy_scale.hpp"
#include "material/elastic.hpp"
#include "run/verdict/far_from_drawing.hpp"

namespace keyblock {
namespace {

using Numbers = std::vector<std::pair<std::string, double>>;

bool softens(const Prepared& prepared, int number) {
  const Model& first = prepared.scene.model;
  if (number >= first.elements.end_index().value || !first.elements[ElementIndex{number}].is_on_covers()) return false;
  const int material = first.elements[ElementIndex{number}].material;
  return prepared.scene.settings.standard.elastic_law.of(material) == ElasticLaw::st_venant_kirchhoff;
}

/// Finds a possible cause of spurious energy. Strains of blocks are damped; those of NMM bodies only if the case
/// requests it.
bool has_undamped_covers(const Prepared& prepared) {
  const Settings& settings = prepared.scene.settings;
  for (const Scene* scene : scenes_of(prepared.scene))
    for (const Element& element : scene->model.elements)
      if (element.is_on_covers() && settings.stiffness_damping.of(element.material).value_or(0) == 0) return true;
  return false;
}

/// Returns facts about a block or element, counted from 0.
Facts about(const Model& model, int number, Numbers numbers) {
  return {std::move(numbers), {{"noun", model.nodes.empty() ? "block" : "element"}}, {number + 1}};
}

void add_penetration(Judgement& judgement, const Prepared& prepared, double share, const Frame& last,
                     const Place& place) {
  const double limit = prepared.scene.settings.trust.penetration;
  if (!(share <= limit))
    return add(judgement.doubts, place, {"sunk_beyond_limit", {{{"share", share}, {"limit", limit}}}});
  std::vector<Loops> bodies;
  for (const ElementFrame& element : last.elements) bodies.push_back(element.loops);
  const SharedArea shared = shared_area(bodies, limit);
  if (shared.pairs == 0 && !shared.is_complete) add(judgement.remarks, place, {"overlaps_not_looked_for"});
  if (shared.pairs == 0) return;
  Facts facts = about(prepared.scene.model, number_of(last, static_cast<std::size_t>(shared.first)),
                      {{"share", shared.share}, {"limit", limit}});
  facts.elements.push_back(number_of(last, static_cast<std::size_t>(shared.second)) + 1);
  add(judgement.doubts, place, {"sunk_beyond_limit:at_end", std::move(facts)});
}

// An initial state closes gaps and strains blocks. A displacement as large as this has lifted a block out of another.
// NMM bodies are left out: they bend, and a static start compares their place with the drawing itself.
void add_start(Warnings& found, const Prepared& prepared, const Frame& first, const Place& place) {
  const double limit = prepared.scene.settings.trust.penetration;
  for (std::size_t e = 0; e < first.elements.size(); ++e) {
    const double way = length(first.elements[e].displacement);
    const double size = std::sqrt(first.elements[e].area);
    if (way <= limit * size || prepared.scene.model.elements[{static_cast<int>(e)}].is_on_covers()) continue;
    add(found, place,
        {"moved_by_start", about(prepared.scene.model, number_of(first, e),
                                 {{"displacement", way}, {"share", way / size}, {"limit", limit}})});
    return;
  }
}

void add_crushing(Warnings& found, const Prepared& prepared, const StepTotals& totals, const Place& place) {
  const Model& model = prepared.scene.model;
  const double limit = prepared.scene.settings.trust.crushing;
  const int number = totals.crushed_element;
  if (prepared.scene.is_untouched && !may_yield(prepared.scene)) {
    if (!(totals.area_share > 0))
      add(found, place, {"crushed_beyond_limit:turned", about(model, number, {{"share", totals.area_share}})});
    return;
  }
  if (totals.area_share >= limit) return;
  Numbers numbers{{"share", totals.area_share}, {"limit", limit}};
  if (!may_yield(prepared.scene) && softens(prepared, number))
    numbers.emplace_back("softening_stretch", kSofteningStretch);
  add(found, place, {"crushed_beyond_limit", about(model, number, std::move(numbers))});
}

// rad: linear statics stretches a rotating body by half the square of the angle, 0.5 % here.
constexpr double kLinearRotation = 0.1;

void add_rotation(Warnings& remarks, const Prepared& prepared, const Frame& last, const Place& place) {
  if (!prepared.scene.is_untouched || may_yield(prepared.scene) || last.elements.empty()) return;
  const auto angle = [](const ElementFrame& element) { return std::abs(element.rotation); };
  const auto most = std::ranges::max_element(last.elements, {}, angle);
  if (angle(*most) <= kLinearRotation) return;
  const int number = number_of(last, static_cast<std::size_t>(most - last.elements.begin()));
  add(remarks, place,
      {"rotated_beyond_linear",
       about(prepared.scene.model, number,
             {{"rotation", angle(*most)}, {"stretch_percent", 50 * angle(*most) * angle(*most)}})});
}

// Linear statics neglects the square of a strain, which is a tenth of the strain here.
constexpr double kLinearStrain = 0.1;

void add_strain(Warnings& remarks, const Prepared& prepared, const Frame& last, const Place& place) {
  if (!prepared.scene.is_untouched || may_yield(prepared.scene) || last.elements.empty()) return;
  const auto strain = [&](const ElementFrame& element) {  // under uniaxial stress
    const Stress& s = element.stress;
    const double greatest = std::abs(s.xx + s.yy) / 2 + std::hypot((s.xx - s.yy) / 2, s.xy);
    const auto& materials = prepared.scene.model.block_materials;
    return greatest / materials[static_cast<std::size_t>(element.material)].youngs_modulus;
  };
  const auto most = std::ranges::max_element(last.elements, {}, strain);
  if (!(strain(*most) > kLinearStrain)) return;
  const int number = number_of(last, static_cast<std::size_t>(most - last.elements.begin()));
  add(remarks, place, {"strained_beyond_linear", about(prepared.scene.model, number, {{"strain", strain(*most)}})});
}

// Returns the created energy over the largest stored energy. The divisor is at least the energy of the initial stress,
// or the work of weight along a small displacement. The limit of 0.01 is then a lift of the scene by 1e-6 of a block.
// Blocks that slid farther than this, even slowly, are judged by their own energy.
double energy_created(const Prepared& prepared, const RunRecord& record, const Frame& first) {
  const double made = record.ledger_sums.energy_made(record.outcome.ledger_scope);
  if (made <= 0) return 0;
  const double least = least_energy(prepared, first);
  const double largest = record.ledger_sums.largest_stored;
  return largest < least ? made * largest / least : made;
}

void add_energy(Warnings& found, const Prepared& prepared, const RunRecord& record, const Frame& first,
                const Place& place) {
  if (!keeps_energy(record)) return;
  const double limit = prepared.scene.settings.trust.energy;
  const double share = energy_created(prepared, record, first);
  if (share <= limit) return;
  const double least = least_energy(prepared, first);
  const double largest = record.ledger_sums.largest_stored;
  const bool is_of_weight = largest < least && least == work_of_weight(prepared, first);
  Facts facts{{{"share", share}, {"limit", limit}}};
  if (is_of_weight) facts.numbers.emplace_back("way", kWayOfWeight);
  if (has_undamped_covers(prepared))
    facts.numbers.emplace_back("stiffness_damping", 2 * prepared.scene.settings.time_step);
  add(found, place, {is_of_weight ? "energy_beyond_limit:of_weight" : "energy_beyond_limit", std::move(facts)});
}

// Fraction of the plastic work that the forces of steps did not do. In a step the force has the mean stress of its
// start and end. The plastic strain is counted with the stress at the end; the difference is ½ (σ1 - σ0) · Δεᵖ.
constexpr double kMissedPlasticWork = 0.1;
// Fraction of the largest energy: less plastic work than this gives no remark.
constexpr double kLittlePlasticWork = 1e-3;

void add_plastic_work(Warnings& remarks, const RunRecord& record, const Place& place) {
  const LedgerScope& scope = record.outcome.ledger_scope;
  const LedgerRow* last = record.ledger.last();
  if (!scope.has_flows || !scope.may_yield || last == nullptr) return;
  const EnergyFlow& flow = last->flow;
  if (flow.plastic < kLittlePlasticWork * record.ledger_sums.largest_energy()) return;
  if (!(-flow.algorithmic > kMissedPlasticWork * flow.plastic)) return;
  add(remarks, place,
      {"plastic_work_overstated",
       {{{"algorithmic", flow.algorithmic},
         {"percent", -100 * flow.algorithmic / flow.plastic},
         {"plastic_work", flow.plastic}}}});
}

// Fraction of the largest energy that closing contacts of NMM bodies may dissipate. These bodies rebound by their own
// elasticity; any further loss depends on the step and the mesh.
constexpr double kTakenByClosing = 0.1;

void add_closing(Warnings& remarks, const Prepared& prepared, const RunRecord& record, const Place& place) {
  const auto is_on_covers = [](const Element& element) { return element.is_on_covers(); };
  const LedgerRow* last = record.ledger.last();
  if (!keeps_energy(record) || !record.outcome.ledger_scope.has_flows || last == nullptr) return;
  if (std::ranges::none_of(prepared.scene.model.elements, is_on_covers)) return;
  const EnergyFlow& flow = last->flow;
  const double taken = flow.closing + flow.clean_up;
  const double largest = record.ledger_sums.largest_energy();
  if (!(taken > kTakenByClosing * largest)) return;
  add(remarks, place, {"energy_lost_in_closing", {{{"share", taken / largest}}}});
}

// Fraction of steps that may be out of balance before a run is not trusted.
constexpr double kUnbalancedSteps = 0.1;
// Fewer steps are not judged in a short run: the first ones after a start are the hardest.
constexpr int kFewestUnbalanced = 4;

void add_imbalance(Warnings& found, const Prepared& prepared, const StepTotals& totals, const Place& place) {
  if (prepared.scene.settings.dynamics != Dynamics::standard) return;
  if (totals.unbalanced_steps < kFewestUnbalanced) return;
  if (!(totals.unbalanced_steps > kUnbalancedSteps * totals.steps)) return;
  add(found, place,
      {"unbalanced_steps",
       {{{"tolerance", kUnbalanced},
         {"concerned", totals.unbalanced_steps},
         {"steps", totals.steps},
         {"residual", totals.greatest_residual},
         {"limit_percent", 100 * kUnbalancedSteps}}}});
}

void add_moved(Warnings& list, const char* form, const Model& model, const CarriedBlock& block, double limit,
               const Place& place) {
  const char* const noun = block.is_body ? "the body of element" : model.nodes.empty() ? "block" : "element";
  add(list, place,
      {form,
       {{{"displacement", block.way}, {"share", block.share()}, {"width", block.width}, {"limit", limit}},
        {{"noun", noun}},
        {block.number + 1},
        {spot(block.drawn)}}});
}

// In statics an equilibrium answers a question about the drawing only if it lies near the drawing.
void add_distance(Judgement& judgement, const Prepared& prepared, const RunRecord& record, const Frame& last,
                  const Place& place) {
  const Settings& settings = prepared.scene.settings;
  const bool seeks_equilibrium = record.is_static && settings.dynamics == Dynamics::standard &&
                                 settings.standard.motion != MotionRule::dynamic && !prepared.scene.is_untouched;
  if (!seeks_equilibrium || record.outcome.end != RunEnd::finished) return;
  const Model& model = scenes_of(prepared.scene).back()->model;
  const auto farthest = farthest_carried(model, last, record.outcome.field);
  if (farthest && farthest->share() > kFarFromDrawing)
    return add_moved(judgement.doubts, "equilibrium_far_away", model, *farthest, kFarFromDrawing, place);
  const auto loose = farthest_carried(model, last, record.outcome.field, true);
  if (farthest && farthest->share() > kSeenFromDrawing)
    add_moved(judgement.remarks, "equilibrium_moved", model, *farthest, kSeenFromDrawing, place);
  else if (loose && loose->share() > kFarFromDrawing)
    add_moved(judgement.remarks, "equilibrium_moved:small", model, *loose, kFarFromDrawing, place);
}

// Returns the largest displacement of an outer vertex of a block between two frames of the same elements.
double way_between(const Frame& first, const Frame& last, int number) {
  double way = 0;
  for (std::size_t e = 0; e < first.elements.size(); ++e) {
    if (number_of(first, e) != number || first.elements[e].loops.empty() || last.elements[e].loops.empty()) continue;
    const std::vector<Point>& from = first.elements[e].loops.front();
    const std::vector<Point>& to = last.elements[e].loops.front();
    for (std::size_t i = 0; i < std::min(from.size(), to.size()); ++i) way = std::max(way, distance(from[i], to[i]));
  }
  return way;
}

// Blocks that nothing drives, and that come to rest near their place at the start but not in it, found another
// equilibrium. Friction permits several; a motion beyond `kFarFromDrawing` is plain to see.
void add_rest(Warnings& remarks, const Prepared& prepared, const RunRecord& record, const Frame& first,
              const Frame& last, const Place& place) {
  const Settings& settings = prepared.scene.settings;
  const Model& model = scenes_of(prepared.scene).back()->model;
  const bool is_at_rest = record.motion && record.motion->state == MotionState::at_rest && !record.is_static;
  if (!is_at_rest || settings.dynamics != Dynamics::standard || record.outcome.end != RunEnd::finished) return;
  const bool is_driven = scenes_of(prepared.scene).size() > 1 || !settings.body_acceleration.curve.times.empty() ||
                         last_change_of_loads(prepared.scene) > 0 ||
                         std::ranges::any_of(first.elements, [](const ElementFrame& e) {
                           return std::hypot(e.velocity.x, e.velocity.y, e.velocity.rotation) > 0;
                         });
  if (is_driven || first.elements.size() != last.elements.size()) return;
  const auto farthest = farthest_carried(model, last, record.outcome.field);
  if (!farthest || farthest->is_body || farthest->share() > kFarFromDrawing) return;
  if (way_between(first, last, farthest->number) > kSeenFromDrawing * farthest->width)
    add_moved(remarks, "equilibrium_moved:rest", model, *farthest, kSeenFromDrawing, place);
}

// Warns of stages that did not reach the equilibrium required before the next stage.
void add_stages(Warnings& found, const RunOutcome& outcome, const Place& place) {
  for (std::size_t i = 0; i < outcome.scenes.size(); ++i) {
    const SceneReport& scene = outcome.scenes[i];
    if (!scene.asks_equilibrium || scene.is_balanced) continue;
    Facts facts{{{"stage", i + 1}, {"step", scene.last_step}}};
    if (!scene.name.empty()) facts.texts.emplace_back("name", scene.name);
    add(found, place, {"stage_not_balanced", std::move(facts)});
  }
}

}  // namespace

bool keeps_energy(const RunRecord& record) {
  if (record.is_static || !record.ledger_sums.is_begun) return false;
  return record.outcome.ledger_scope.has_flows || record.outcome.ledger_scope.has_work;
}

Judgement judged(const Prepared& prepared, const RunRecord& record, const Frame& first, const Frame& last,
                 const Place& place) {
  Judgement judgement;
  Warnings& found = judgement.doubts;
  if (!prepared.scene.is_untouched) add_penetration(judgement, prepared, record.totals.penetration_share, last, place);
  add_crushing(found, prepared, record.totals, place);
  add_start(found, prepared, first, place);
  add_energy(found, prepared, record, first, place);
  add_imbalance(found, prepared, record.totals, place);
  add_distance(judgement, prepared, record, last, place);
  add_rest(judgement.remarks, prepared, record, first, last, place);
  add_stages(found, record.outcome, place);
  add_rotation(judgement.remarks, prepared, last, place);
  add_strain(judgement.remarks, prepared, last, place);
  add_plastic_work(judgement.remarks, record, place);
  add_closing(judgement.remarks, prepared, record, place);
  add_doubts_of_cracks(judgement, prepared, record.outcome.cracks, last, place);
  return judgement;
}

void judge(RunRecord& record, const Prepared& prepared, StepWatch& watch, const Frame& first, const Frame& last,
           const Place& place) {
  record.warnings = joined(record.warnings, outcome_warnings(prepared, record.outcome, place));
  record.warnings = joined(record.warnings, broken_bolts(first, last, place));
  record.is_static = watch.is_static();
  if (keeps_energy(record)) record.energy_created = energy_created(prepared, record, first);
  if (record.outcome.end != RunEnd::failed) record.equilibrium_way = watch.equilibrium_way();
  if (record.totals.steps > 0) record.motion = end_of_motion(prepared, record, first, last);
  const Judgement judgement = judged(prepared, record, first, last, place);
  record.doubts = judgement.doubts;
  if (record.outcome.end == RunEnd::finished)
    record.doubts = joined(record.doubts, watch.blocks().doubts(prepared.scene.settings, keeps_energy(record), place));
  record.warnings = joined(joined(record.warnings, judgement.remarks), record.doubts);
}

}  // namespace keyblock
