// Compares the tips of a run with the limits of their factors and increments.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "job/verdict/crack_doubts.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "fracture/near_tip_field.hpp"
#include "fracture/tip_report.hpp"

namespace keyblock {
namespace {

// Under given loads a tip that cannot be judged does not extend. In statics each step sees one increment.
void add_tips(Judgement& judgement, const Prepared& prepared, const Frame& last, const Place& place) {
  const CrackGrowth* growth = prepared.scene.growth.get();
  if (growth == nullptr || growth->plan.loads != GrowthLoads::given) return;
  const bool is_at_rest = is_statics(prepared.scene.settings);
  const auto number_of = [&](const TipState& tip) { return static_cast<double>(&tip - last.tips.data() + 1); };
  const auto put = [&](const char* form, const TipState& tip) {
    add(judgement.doubts, place, {form, {{{"tip", number_of(tip)}}, {}, {}, {spot(tip.at)}}});
  };
  for (const TipState& tip : last.tips) {
    if (!tip.has_room && !tip.goes_on && tip.toughness > 0) return put("tip_without_room", tip);
    if (is_at_rest && tip.goes_on) return put("tips_still_go_on", tip);
  }
}

// Tables contain stress intensity factors that may be wrong, for the tips at the start of the run. Elastoplastic
// rock has none. For tips that may extend, `add_tips` reports one without room.
void add_factors(Warnings& remarks, const Prepared& prepared, const Frame& last, const Place& place) {
  const auto& continuum = prepared.scene.model.continuum;
  if (last.tips.empty() || !continuum || continuum->cracks.empty()) return;  // no table has their factors
  const auto put = [&](const char* name, Facts facts) {
    if (std::ranges::count(remarks, name, &Warning::name) == 0) add(remarks, place, {name, std::move(facts)});
  };
  for (const CrackTip& tip : continuum->manifold.tips) {
    const int element = element_of(continuum->manifold, tip);
    if (element < 0 || continuum->material(element).is_nonlinear()) continue;
    const auto state = std::ranges::find(last.tips, tip.at, &TipState::at);
    if (state != last.tips.end() && !state->has_room) {
      const auto number = static_cast<double>(state - last.tips.begin() + 1);
      if (!prepared.scene.growth) put("tip_without_factors", {{{"tip", number}}, {}, {}, {spot(state->at)}});
      continue;
    }
    if (const std::string why = coarse_mesh_at(*continuum, tip); !why.empty())
      put("coarse_tip", {{}, {{"why", why}}, {}, {spot(tip.at)}});
  }
}

// Warns of cracks that start where the mesh does not resolve the stress over the length of the rock.
void add_coarse_starts(Warnings& found, const CrackNotes::Start& start, const Place& place) {
  if (start.count == 0) return;
  add(found, place,
      {start.strength == start.of_rock ? "crack_start_on_coarse_mesh" : "crack_start_on_coarse_mesh:at_corner",
       {{{"count", start.count},
         {"step", start.step},
         {"side", start.side},
         {"length", start.length},
         {"strength", start.strength},
         {"of_rock", start.of_rock},
         {"needed", start.length / 2}},
        {},
        {},
        {spot(start.at)}}});
}

// Warns of tips whose faces overlap, at the end or when they extended.
void add_overlapping(Warnings& found, const Prepared& prepared, const CrackNotes::AtTip& went_on, const Frame& last,
                     const Place& place) {
  if (went_on.step > 0)
    return add(found, place,
               {"faces_overlap_at_tip:extended",
                {{{"step", went_on.step}, {"share", went_on.ratio}}, {}, {}, {spot(went_on.at)}}});
  // Joints that end in a body are cracks too; contact closes the faces of those.
  const auto& continuum = prepared.scene.model.continuum;
  if (!prepared.scene.is_untouched && (!continuum || continuum->cracks.empty())) return;
  const auto overlaps = [](const TipState& tip) { return tip.has_room && faces_overlap({tip.mode_1, tip.mode_2}); };
  const auto tip = std::ranges::find_if(last.tips, overlaps);
  if (tip == last.tips.end()) return;
  const double share = tip->mode_1 / std::hypot(tip->mode_1, tip->mode_2);
  add(found, place, {"faces_overlap_at_tip", {{{"share", share}}, {}, {}, {spot(tip->at)}}});
}

// Largest K_II over K_I behind an increment. In benchmark fra-06 it reaches 0.10 with increments of 0.3, whose path
// ends 0.2 from that with half of them, and 0.055 with these.
constexpr double kMostBend = 0.08;

void add_bend(Warnings& remarks, const CrackNotes::AtTip& bent, const Place& place) {
  if (!(std::abs(bent.ratio) > kMostBend)) return;
  add(remarks, place,
      {"increments_too_long",
       {{{"crack", bent.crack + 1},
         {"increment", bent.increment},
         {"step", bent.step},
         {"ratio", bent.ratio},
         {"limit", kMostBend}},
        {},
        {},
        {spot(bent.at)}}});
}

}  // namespace

void add_doubts_of_cracks(Judgement& judgement, const Prepared& prepared, const CrackNotes& cracks, const Frame& last,
                          const Place& place) {
  add_tips(judgement, prepared, last, place);
  add_coarse_starts(judgement.doubts, cracks.coarse_start, place);
  add_overlapping(judgement.doubts, prepared, cracks.overlapping, last, place);
  add_bend(judgement.remarks, cracks.bent, place);
  add_factors(judgement.remarks, prepared, last, place);
}

}  // namespace keyblock
