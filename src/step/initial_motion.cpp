// Chooses the method of the start for each lot, and joins the states and reports; see initial_motion.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/initial_motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/counted.hpp"
#include "model/body_load.hpp"
#include "step/lots.hpp"
#include "step/rest/compatible_start.hpp"
#include "step/rest/resting_start.hpp"
#include "step/rest/settled_start.hpp"
#include "step/rest/stressed_start.hpp"
#include "step/scene/contact_laws.hpp"
#include "step/scene/enforcement.hpp"
#include "step/scene/equilibrium.hpp"

namespace keyblock {
namespace {

// Rigid blocks have no strain, but their contacts bear the stress too.
bool has_initial_stress(const StandardScene& scene) {
  return std::ranges::any_of(scene.model.elements, [&](const Element& element) {
    return element.can_move() && scene.model.material_of(element).is_stressed();
  });
}

// Largest misfit of a compatible start. Forces whose gaps no shift can produce are not those of elastic blocks; a
// settled start replaces them.
constexpr double kMisfit = 1e-6;
// Largest number of touching pairs for a compatible start. Larger jointed masses settle at once, because multipliers
// between rigid blocks rarely converge there.
constexpr std::size_t kMostExact = 40;

// Returns a list such as "the weight and 2 point loads".
std::string loads_in_words(const StandardScene& scene) {
  std::size_t points = 0;
  for (const CarriedPoint& point : scene.model.loading_points) points += length(point.curve.at(0)) > 0 ? 1 : 0;
  const bool has_weight = std::ranges::any_of(
      scene.bodies(), [](const Body& body) { return body.weight.size() > 0 && !body.weight.isZero(0); });
  std::vector<std::string> loads;
  if (has_weight) loads.emplace_back("the weight");
  if (points > 0) loads.push_back(counted(points, "point load"));
  if (has_body_acceleration(scene.settings)) loads.emplace_back("the body acceleration");
  return fmt::format("{}", fmt::join(loads, " and "));
}

std::string balanced_by(const StandardScene& scene, const std::string& what) {
  const std::string loads = loads_in_words(scene);
  return loads.empty() ? loads
                       : fmt::format("at t = 0 {} fit {} and the first accelerations; start=sudden begins without them",
                                     what, loads);
}

InitialMotion settled_first(const StandardScene& scene, Motion motion, const std::string& why) {
  const bool is_stressed = has_initial_stress(scene);
  Settled made = settled(scene, std::move(motion));
  std::string unbalanced;
  if (made.left > 0)
    unbalanced = fmt::format("the search for the initial state used up its steps: bodies move by {:.2g} of free motion",
                             made.left);
  return {
      std::move(made.motion),
      {},
      {is_stressed ? "that of the initial stress, released" : "that of joints glued under the loads and then released",
       balanced_by(scene,
                   scene.model.bolts.empty() ? "contact forces and strains" : "contact forces, strains and bolts"),
       why, 0, made.unsolved_steps, unbalanced}};
}

std::string bodies(int count) {
  return count == 1 ? "1 body" : fmt::format("{} bodies", count);
}

InitialMotion resting_first(const StandardScene& scene, Motion motion) {
  RestingStart start = resting_start(scene, motion);
  StartReport report;
  report.unbalanced = start.unbalanced;
  if (!start.is_found && start.moving == 0) {
    report.made = start.unbalanced.empty() ? "as the file has it: all bodies move, or have no support"
                                           : "sudden, because no equilibrium exists";
    return {std::move(motion), {}, report};
  }
  const std::string moving = "first acceleration of " + bodies(start.moving);
  report.made = !start.is_found     ? moving
                : start.moving == 0 ? "static equilibrium"
                                    : "static equilibrium, and " + moving;
  if (largest_load(scene, loads_at(scene, start.motion.q, 0)) > 0)
    report.balanced =
        fmt::format("at t = 0 stresses and contact forces balance the loads{}{}; start=sudden begins without them",
                    start.moving > 0 ? " and the first accelerations" : "",
                    start.sudden > 0 ? fmt::format(" except those of {}, suddenly loaded", bodies(start.sudden)) : "");
  return {std::move(start.motion), {}, report};
}

bool begins_as_drawn(const StandardScene& scene) {
  const StandardChoices& choices = scene.settings.standard;
  return choices.motion == MotionRule::dynamic && choices.start == StartRule::sudden;
}

InitialMotion asked_motion(const StandardScene& scene) {
  Motion motion = start_motion(scene);
  const Scales scales = scales_at(scene, motion, 0);
  motion.bonds = bonds_at(scene, motion, scales);
  if (begins_as_drawn(scene)) return {std::move(motion), {}, {}};
  const bool is_in_time = scene.settings.standard.motion == MotionRule::dynamic;
  const bool slides_in_balance =
      std::ranges::all_of(scene.groups, [](const BodyGroups::Group& group) { return group->has_compatible_start(); });
  // Blocks that may yield have stress that forces alone do not give.
  if (!slides_in_balance)
    return is_in_time ? resting_first(scene, std::move(motion)) : InitialMotion{std::move(motion), {}, {}};
  const bool is_stressed = has_initial_stress(scene);
  if (is_stressed) motion.closed = stressed_contacts(scene, motion);
  std::vector<ElementPair> touching = touching_pairs(scene.model);
  const auto has_faces = [&](ElementIndex e) {
    return std::ranges::find(scene.with_faces, e) != scene.with_faces.end();
  };
  if (scene.with_faces.size() < scene.model.elements.size())
    std::erase_if(touching, [&](const ElementPair& pair) { return !has_faces(pair.lower) || !has_faces(pair.upper); });
  const bool is_jointed = has_ring(scene.model, touching);
  // In a jointed mass, friction can carry the load in several ways. Statics therefore begins from the same forces as
  // dynamics, so that both find the same scenes stable.
  if (!is_in_time) return {is_jointed ? settled(scene, motion).motion : motion, {}, {}};
  if (is_jointed && touching.size() > kMostExact)
    return settled_first(scene, std::move(motion),
                         fmt::format("more than {} pairs of blocks are in contact, some in rings", kMostExact));
  // Forces of stressed blocks, and of bonds with springs, depend on the strain of all blocks: statics finds them, and
  // `fos` judges them so.
  if (is_stressed || (!motion.bonds.empty() && scene.has_springs())) return resting_first(scene, std::move(motion));
  CompatibleStart start = compatible(scene, motion);
  if (is_jointed && !start.failure.empty()) return settled_first(scene, std::move(motion), start.failure);
  if (is_jointed && start.misfit > kMisfit)
    return settled_first(scene, std::move(motion),
                         fmt::format("shifts leave {:.1e} of the gaps of the compatible start", start.misfit));
  const std::string what = start.bolts == 0 ? "contact forces and strains"
                                            : fmt::format("contact forces, strains and the pull of {}",
                                                          counted(static_cast<std::size_t>(start.bolts), "bolt"));
  return {
      std::move(start.motion), std::move(start.failure), {"compatible", balanced_by(scene, what), {}, start.misfit, 0}};
}

// Adds a sentence unless it is there already.
void add_sentence(std::string& all, const std::string& more, const char* between) {
  if (more.empty() || all.find(more) != std::string::npos) return;
  all += (all.empty() ? "" : between) + more;
}

void add_report(StartReport& all, const StartReport& more) {
  add_sentence(all.made, more.made, "; heavier or more stressed blocks: ");
  add_sentence(all.balanced, more.balanced, "; ");
  add_sentence(all.why, more.why, "; ");
  add_sentence(all.unbalanced, more.unbalanced, "; ");
  all.misfit = std::max(all.misfit, more.misfit);
  all.unsolved_steps += more.unsolved_steps;
}

}  // namespace

InitialMotion initial_motion(const StandardScene& scene) {
  if (begins_as_drawn(scene)) return asked_motion(scene);
  InitialMotion all{start_motion(scene), {}, {}};
  const std::vector<ChosenElements> lots = lots_of(scene, all.motion, 0);
  if (lots.empty()) return asked_motion(scene);
  all.report.made.clear();
  for (const ChosenElements& chosen : lots) {
    const Lot lot(scene, chosen);
    InitialMotion own = asked_motion(lot.scene());
    if (!own.failure.empty()) return own;
    lot.put(own.motion, all.motion);
    add_report(all.report, own.report);
  }
  return one_meets_another(scene, lots, all.motion) ? asked_motion(scene) : all;
}

}  // namespace keyblock
