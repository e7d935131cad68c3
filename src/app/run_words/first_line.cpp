// Counts bodies in the first scene of the run, and steps in all of its stages.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/run_words/first_line.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <vector>

#include "base/counted.hpp"
#include "problem/units/readable.hpp"
#include "run/ahead/plausible_units.hpp"

namespace keyblock {
namespace {

// Counts blocks with at least two fixed points; a block can rotate about a single one.
std::size_t fixed_blocks(const Model& model) {
  std::map<std::size_t, int> points;
  for (const CarriedPoint& point : model.fixed_points) ++points[point.element.value];
  return static_cast<std::size_t>(std::ranges::count_if(points, [](const auto& entry) { return entry.second > 1; }));
}

std::string bodies_in_words(const Model& model) {
  if (!model.nodes.empty()) return counted(model.elements.size(), "element");
  const std::string blocks = counted(model.elements.size(), "block");
  const std::size_t fixed = fixed_blocks(model);
  return fixed == 0 ? blocks : fmt::format("{} ({} fixed)", blocks, fixed);
}

bool starts_each_step_from_rest(const Settings& settings) {
  return settings.velocity_carry_over.common == 0;
}

std::string steps_in_words(const Scene& first, const Units& units) {
  const Settings& settings = first.settings;
  const std::vector<const Scene*> scenes = scenes_of(first);
  const bool may_end_early =
      std::ranges::any_of(scenes, [](const Scene* scene) { return scene->end.equilibrium.has_value(); });
  const std::string steps = (may_end_early ? "at most " : "") + counted(static_cast<std::size_t>(settings.step_count),
                                                                        is_statics(settings) ? "load step" : "step");
  const std::string stages = scenes.size() > 1 ? fmt::format(" in {} stages", scenes.size()) : "";
  if (is_statics(settings)) return steps + stages;
  const std::string size = readable(settings.time_step, measures::kTime, units);
  return settings.step_control == StepControl::constant ? fmt::format("{} of {}{}", steps, size, stages)
                                                        : fmt::format("{}{}, the first of {}", steps, stages, size);
}

}  // namespace

std::string first_line(const std::string& file, const Prepared& prepared, const RunRecord& record) {
  const Settings& settings = prepared.scene.settings;
  std::vector<std::string> parts{bodies_in_words(prepared.scene.model),
                                 counted(static_cast<std::size_t>(prepared.requirements.unknowns), "unknown")};
  if (std::string size = size_of_scene(prepared.scene.model, record.units); !size.empty())
    parts.push_back(std::move(size));
  parts.emplace_back(is_statics(settings)                   ? "static"
                     : starts_each_step_from_rest(settings) ? "static (each step starts at zero velocity)"
                                                            : "dynamic");
  parts.push_back(steps_in_words(prepared.scene, record.units));
  parts.push_back("profile " + record.profile);
  return fmt::format("{}: {}", file, fmt::join(parts, ", "));
}

}  // namespace keyblock
