// Compares a run with each of its limits and writes one sentence per exceeded limit.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "job/run_doubts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/counted.hpp"
#include "base/words/plain_number.hpp"
#include "fracture/near_tip_field.hpp"
#include "fracture/tip_report.hpp"
#include "geometry/shared_area.hpp"
#include "job/verdict/end_of_motion.hpp"
#include "job/verdict/energy_scale.hpp"
#include "material/elastic.hpp"
#include "run/verdict/far_from_drawing.hpp"

namespace keyblock {
namespace {

std::string law_of(const Prepared& prepared, int number) {
  const Model& first = prepared.scene.model;
  if (number >= first.elements.end_index().value || !first.elements[ElementIndex{number}].is_on_covers()) return {};
  const int material = first.elements[ElementIndex{number}].material;
  if (prepared.scene.settings.standard.elastic_law.of(material) != ElasticLaw::st_venant_kirchhoff) return {};
  return fmt::format(
      "; the St. Venant-Kirchhoff law softens below a stretch of {:.2g}, elastic_law=logarithmic does not",
      kSofteningStretch);
}

/// Names a possible cause of spurious energy. Strains of blocks are damped; those of NMM bodies only if the case
/// requests it.
std::string undamped_covers(const Prepared& prepared) {
  const Settings& settings = prepared.scene.settings;
  for (const Scene* scene : scenes_of(prepared.scene))
    for (const Element& element : scene->model.elements)
      if (element.is_on_covers() && settings.stiffness_damping.of(element.material).value_or(0) == 0)
        return fmt::format("; sliding NMM bodies may flutter, stiffness_damping={:.2g} (two steps) damps them",
                           2 * settings.time_step);
  return {};
}

std::string name_of(const Model& model, int number) {
  return fmt::format("{} {}", model.nodes.empty() ? "block" : "element", number + 1);
}

void add_penetration(Judgement& judgement, const Prepared& prepared, double share, const Frame& last,
                     const Place& place) {
  Warnings& found = judgement.doubts;
  const double limit = prepared.scene.settings.trust.penetration;
  if (!(share <= limit)) {
    found.push_back(
        {"sunk_beyond_limit", place,
         fmt::format("blocks overlapped by {:.3g} of the size of the smaller; limit {:.3g} (penetration_limit)", share,
                     limit)});
    return;
  }
  std::vector<Loops> bodies;
  for (const ElementFrame& element : last.elements) bodies.push_back(element.loops);
  const SharedArea shared = shared_area(bodies, limit);
  if (shared.pairs == 0 && !shared.is_complete)
    judgement.remarks.push_back(
        {"overlaps_not_looked_for", place,
         "so many corners lie close together that not all were checked for overlaps at the end"});
  if (shared.pairs == 0) return;
  const Model& model = prepared.scene.model;
  found.push_back(
      {"sunk_beyond_limit", place,
       fmt::format("{} and {} share {:.3g} of the smaller one's area at the end; limit {:.3g} (penetration_limit)",
                   name_of(model, number_of(last, static_cast<std::size_t>(shared.first))),
                   name_of(model, number_of(last, static_cast<std::size_t>(shared.second))), shared.share, limit)});
}

// An initial state closes gaps and strains blocks. A displacement as large as this has lifted a block out of another.
// NMM bodies are left out: they bend, and a static start compares their place with the drawing itself.
void add_start(Warnings& found, const Prepared& prepared, const Frame& first, const Place& place) {
  const double limit = prepared.scene.settings.trust.penetration;
  for (std::size_t e = 0; e < first.elements.size(); ++e) {
    const double way = length(first.elements[e].displacement);
    const double size = std::sqrt(first.elements[e].area);
    if (way <= limit * size || prepared.scene.model.elements[{static_cast<int>(e)}].is_on_covers()) continue;
    found.push_back(
        {"moved_by_start", place,
         fmt::format("the initial state moves {} by {:.3g}, {:.3g} of its size; limit {:.3g} (penetration_limit)",
                     name_of(prepared.scene.model, number_of(first, e)), way, way / size, limit)});
    return;
  }
}

void add_crushing(Warnings& found, const Prepared& prepared, const StepTotals& totals, const Place& place) {
  const Model& model = prepared.scene.model;
  const double limit = prepared.scene.settings.trust.crushing;
  const int number = totals.crushed_element;
  if (prepared.scene.is_untouched && !may_yield(prepared.scene)) {
    if (!(totals.area_share > 0))
      found.push_back(
          {"crushed_beyond_limit", place,
           fmt::format("{} is turned inside out: the loads are too large for linear statics", name_of(model, number))});
    return;
  }
  if (!(totals.area_share >= limit))
    found.push_back(
        {"crushed_beyond_limit", place,
         fmt::format("{} was compressed to {:.4g} of its area{}; limit {:.4g} (crushing_limit)", name_of(model, number),
                     totals.area_share, may_yield(prepared.scene) ? "" : law_of(prepared, number), limit)});
}

// rad: linear statics stretches a rotating body by half the square of the angle, 0.5 % here.
constexpr double kLinearRotation = 0.1;

void add_rotation(Warnings& remarks, const Prepared& prepared, const Frame& last, const Place& place) {
  if (!prepared.scene.is_untouched || may_yield(prepared.scene) || last.elements.empty()) return;
  const auto angle = [](const ElementFrame& element) { return std::abs(element.rotation); };
  const auto most = std::ranges::max_element(last.elements, {}, angle);
  if (angle(*most) <= kLinearRotation) return;
  const int number = number_of(last, static_cast<std::size_t>(most - last.elements.begin()));
  remarks.push_back(
      {"rotated_beyond_linear", place,
       fmt::format("{} rotates by {:.3g} rad; linear statics stretches it by {:.2g} %, and results hold for small "
                   "displacements only",
                   name_of(prepared.scene.model, number), angle(*most), 50 * angle(*most) * angle(*most))});
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
  remarks.push_back(
      {"strained_beyond_linear", place,
       fmt::format(
           "{} carries a stress of {:.2g} of its modulus; in linear statics, results hold for small strains only",
           name_of(prepared.scene.model, number), strain(*most))});
}

// Returns the created energy over the largest stored energy. The divisor is at least the work of weight along a small
// displacement. The limit of 0.01 is then a lift of the scene by 1e-6 of a block. Blocks that slid farther than this,
// even slowly, are judged by their own energy.
double energy_created(const Prepared& prepared, const RunRecord& record, const Frame& first) {
  const double made = record.ledger_sums.energy_made(record.outcome.ledger_scope);
  if (made <= 0) return 0;
  const double least = work_of_weight(prepared, first);
  const double largest = record.ledger_sums.largest_stored;
  return largest < least ? made * largest / least : made;
}

void add_energy(Warnings& found, const Prepared& prepared, const RunRecord& record, const Frame& first,
                const Place& place) {
  if (!keeps_energy(record)) return;
  const double limit = prepared.scene.settings.trust.energy;
  const double share = energy_created(prepared, record, first);
  if (share <= limit) return;
  const double least = work_of_weight(prepared, first);
  const double largest = record.ledger_sums.largest_stored;
  found.push_back(
      {"energy_beyond_limit", place,
       fmt::format("energy came from nothing: {:.3g} of {}; limit {:.3g} (energy_limit){}", share,
                   largest < least ? fmt::format("the work of all weights over {:g} of a block's size", kWayOfWeight)
                                   : "the largest stored energy",
                   limit, undamped_covers(prepared))});
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
  remarks.push_back({"plastic_work_overstated", place,
                     fmt::format("steps are long for elastoplastic rock: `algorithmic` of ledger.csv is {:.3g}, {:.2g} "
                                 "% of the plastic work {:.4g}",
                                 flow.algorithmic, -100 * flow.algorithmic / flow.plastic, flow.plastic)});
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
  remarks.push_back(
      {"energy_lost_in_closing", place,
       fmt::format("contacts took {:.2g} of the largest energy as they closed (closing and clean_up of ledger.csv); in "
                   "impacts of NMM bodies this depends on the step, and later motion is too small",
                   taken / largest)});
}

// Fraction of steps that may be out of balance before a run is not trusted.
constexpr double kUnbalancedSteps = 0.1;
// Fewer steps are not judged in a short run: the first ones after a start are the hardest.
constexpr int kFewestUnbalanced = 4;

void add_imbalance(Warnings& found, const Prepared& prepared, const StepTotals& totals, const Place& place) {
  if (prepared.scene.settings.dynamics != Dynamics::standard) return;
  if (totals.unbalanced_steps < kFewestUnbalanced) return;
  if (!(totals.unbalanced_steps > kUnbalancedSteps * totals.steps)) return;
  found.push_back({"unbalanced_steps", place,
                   fmt::format("forces are out of balance by more than {:.0e} of the load in {} of {} steps, the worst "
                               "by {:.1e}; limit {:g} % of the steps",
                               kUnbalanced, totals.unbalanced_steps, totals.steps, totals.greatest_residual,
                               100 * kUnbalancedSteps)});
}

// In statics an equilibrium answers a question about the drawing only if it lies near the drawing.
void add_distance(Judgement& judgement, const Prepared& prepared, const RunRecord& record, const Frame& last,
                  const Place& place) {
  const Settings& settings = prepared.scene.settings;
  const bool seeks_equilibrium = record.is_static && settings.dynamics == Dynamics::standard &&
                                 settings.standard.motion != MotionRule::dynamic && !prepared.scene.is_untouched;
  if (!seeks_equilibrium || record.outcome.end != RunEnd::finished) return;
  const Model& model = scenes_of(prepared.scene).back()->model;
  const auto in_words = [&](const CarriedBlock& block) {
    return fmt::format(
        "{} near ({}, {}) moved by {}, {:.2g} of its width {}",
        block.is_body ? fmt::format("the body of element {}", block.number + 1) : name_of(model, block.number),
        plain(block.drawn.x), plain(block.drawn.y), plain(block.way, 3), block.share(), plain(block.width, 3));
  };
  const auto farthest = farthest_carried(model, last, record.outcome.field);
  if (farthest && farthest->share() > kFarFromDrawing) {
    judgement.doubts.push_back({"equilibrium_far_away", place,
                                fmt::format("the equilibrium lies far from the drawing: {}; limit {:g}",
                                            in_words(*farthest), kFarFromDrawing)});
    return;
  }
  const auto loose = farthest_carried(model, last, record.outcome.field, true);
  if (farthest && farthest->share() > kSeenFromDrawing)
    judgement.remarks.push_back({"equilibrium_moved", place,
                                 fmt::format("the equilibrium is not quite that of the drawing: {}; gaps closed, parts "
                                             "are soft, or the scene is near its limit",
                                             in_words(*farthest))});
  else if (loose && loose->share() > kFarFromDrawing)
    judgement.remarks.push_back(
        {"equilibrium_moved", place, fmt::format("a small loose block found another place: {}", in_words(*loose))});
}

// Warns of stages that did not reach the equilibrium required before the next stage.
void add_stages(Warnings& found, const RunOutcome& outcome, const Place& place) {
  for (std::size_t i = 0; i < outcome.scenes.size(); ++i) {
    const SceneReport& scene = outcome.scenes[i];
    if (!scene.asks_equilibrium || scene.is_balanced) continue;
    found.push_back({"stage_not_balanced", place,
                     fmt::format("stage {}{} ends after step {} without the required equilibrium", i + 1,
                                 scene.name.empty() ? "" : fmt::format(" ({})", scene.name), scene.last_step)});
  }
}

// Under given loads a tip that cannot be judged does not extend. In statics each step sees one increment.
void add_tips(Judgement& judgement, const Prepared& prepared, const Frame& last, const Place& place) {
  const CrackGrowth* growth = prepared.scene.growth.get();
  if (growth == nullptr || growth->plan.loads != GrowthLoads::given) return;
  const bool is_at_rest = is_statics(prepared.scene.settings);
  const auto number_of = [&](const TipState& tip) { return &tip - last.tips.data() + 1; };
  for (const TipState& tip : last.tips) {
    if (!tip.has_room && !tip.goes_on && tip.toughness > 0) {
      judgement.doubts.push_back({"tip_without_room", place,
                                  fmt::format("tip {} at {}, {} has no stress intensity factors, because every domain "
                                              "about it contains other lines; whether it extends is unknown",
                                              number_of(tip), plain(tip.at.x), plain(tip.at.y))});
      return;
    }
    if (is_at_rest && tip.goes_on) {
      judgement.doubts.push_back({"tips_still_go_on", place,
                                  fmt::format("tip {} at {}, {} still extends under the loads of the last step",
                                              number_of(tip), plain(tip.at.x), plain(tip.at.y))});
      return;
    }
  }
}

// Tables contain stress intensity factors that may be wrong, for the tips at the start of the run. Elastoplastic
// rock has none. For tips that may extend, `add_tips` reports one without room.
void add_factors(Warnings& remarks, const Prepared& prepared, const Frame& last, const Place& place) {
  const auto& continuum = prepared.scene.model.continuum;
  if (last.tips.empty() || !continuum || continuum->cracks.empty()) return;  // no table has their factors
  const auto put = [&](const char* name, const std::string& sentence) {
    if (std::ranges::count(remarks, name, &Warning::name) == 0) remarks.push_back({name, place, sentence});
  };
  for (const CrackTip& tip : continuum->manifold.tips) {
    const int element = element_of(continuum->manifold, tip);
    if (element < 0 || continuum->material(element).is_nonlinear()) continue;
    const auto state = std::ranges::find(last.tips, tip.at, &TipState::at);
    if (state != last.tips.end() && !state->has_room) {
      if (!prepared.scene.growth)
        put("tip_without_factors",
            fmt::format(
                "tip {} at {}, {} has no K and no J: every domain about it contains other lines, loads or edges",
                state - last.tips.begin() + 1, plain(tip.at.x), plain(tip.at.y)));
      continue;
    }
    if (const std::string why = coarse_mesh_at(*continuum, tip); !why.empty())
      put("coarse_tip", fmt::format("at the tip {}, {} the mesh is coarse for the factors of tips.csv: {}",
                                    plain(tip.at.x), plain(tip.at.y), why));
  }
}

// Warns of cracks that start where the mesh does not resolve the stress over the length of the rock.
void add_coarse_starts(Warnings& found, const CrackNotes::Start& start, const Place& place) {
  if (start.count == 0) return;
  found.push_back(
      {"crack_start_on_coarse_mesh", place,
       fmt::format(
           "{} started in a mesh too coarse for the stress, the first at {}, {} in step {}: sides are {:.3g} there, "
           "the length (K_Ic/strength)²/π is {:.3g}, with a strength of {:.4g}, {}; refine to sides of {:.3g}",
           counted(static_cast<std::size_t>(start.count), "crack"), plain(start.at.x), plain(start.at.y), start.step,
           start.side, start.length, start.strength,
           start.strength == start.of_rock
               ? "that of the rock"
               : fmt::format("for a corner that is near and the rock's {:.4g}", start.of_rock),
           start.length / 2)});
}

// Warns of tips whose faces overlap, at the end or when they extended.
void add_overlapping(Warnings& found, const Prepared& prepared, const CrackNotes::AtTip& went_on, const Frame& last,
                     const Place& place) {
  const auto put = [&](Point at, const std::string& when, double ratio) {
    found.push_back({"faces_overlap_at_tip", place,
                     fmt::format("the faces overlap at the tip {}, {}{}: K_I is {:.2g} of K, below 0", plain(at.x),
                                 plain(at.y), when, ratio)});
  };
  if (went_on.step > 0) return put(went_on.at, fmt::format(", which extended in step {}", went_on.step), went_on.ratio);
  // Joints that end in a body are cracks too; contact closes the faces of those.
  const auto& continuum = prepared.scene.model.continuum;
  if (!prepared.scene.is_untouched && (!continuum || continuum->cracks.empty())) return;
  const auto overlaps = [](const TipState& tip) { return tip.has_room && faces_overlap({tip.mode_1, tip.mode_2}); };
  const auto tip = std::ranges::find_if(last.tips, overlaps);
  if (tip != last.tips.end()) put(tip->at, " at the end", tip->mode_1 / std::hypot(tip->mode_1, tip->mode_2));
}

// Largest K_II over K_I behind an increment. In benchmark fra-06 it reaches 0.10 with increments of 0.3, whose path
// ends 0.2 from that with half of them, and 0.055 with these.
constexpr double kMostBend = 0.08;

void add_bend(Warnings& remarks, const CrackNotes::AtTip& bent, const Place& place) {
  if (!(std::abs(bent.ratio) > kMostBend)) return;
  remarks.push_back(
      {"increments_too_long", place,
       fmt::format("crack {}: behind the increment of {:.3g} to {}, {} (step {}) K_II is {:.2g} of K_I; limit {:g}",
                   bent.crack + 1, bent.increment, plain(bent.at.x), plain(bent.at.y), bent.step, bent.ratio,
                   kMostBend)});
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
  add_stages(found, record.outcome, place);
  add_rotation(judgement.remarks, prepared, last, place);
  add_strain(judgement.remarks, prepared, last, place);
  add_plastic_work(judgement.remarks, record, place);
  add_closing(judgement.remarks, prepared, record, place);
  add_tips(judgement, prepared, last, place);
  add_coarse_starts(found, record.outcome.cracks.coarse_start, place);
  add_overlapping(found, prepared, record.outcome.cracks.overlapping, last, place);
  add_bend(judgement.remarks, record.outcome.cracks.bent, place);
  add_factors(judgement.remarks, prepared, last, place);
  return judgement;
}

void judge(RunRecord& record, const Prepared& prepared, StepWatch& watch, const Frame& first, const Frame& last,
           const Place& place) {
  record.warnings = joined(record.warnings, outcome_warnings(prepared, record.outcome, place));
  record.warnings = joined(record.warnings, broken_bolts(first, last, place));
  record.is_static = watch.is_static();
  if (keeps_energy(record)) record.energy_created = energy_created(prepared, record, first);
  const Judgement judgement = judged(prepared, record, first, last, place);
  record.doubts = judgement.doubts;
  if (record.outcome.end == RunEnd::finished)
    record.doubts = joined(record.doubts, watch.blocks().doubts(prepared.scene.settings, keeps_energy(record), place));
  record.warnings = joined(joined(record.warnings, judgement.remarks), record.doubts);
  if (record.outcome.end != RunEnd::failed) record.equilibrium_way = watch.equilibrium_way();
  if (record.totals.steps > 0) record.motion = end_of_motion(prepared, record, first, last);
}

}  // namespace keyblock
