// `keyblock joints`: draws statistical joint sets in an outline, and writes a drawing file.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/command.hpp"
#include "base/error.hpp"
#include "formats/berkeley/ddaml.hpp"
#include "formats/case_file/joint_spec.hpp"
#include "formats/case_file/keyblock_case.hpp"
#include "formats/dxf/dxf.hpp"
#include "formats/registry.hpp"
#include "formats/shi/dda_geometry.hpp"
#include "job/files.hpp"

namespace keyblock {
namespace {

using formats::PlacedJson;
using Kind = PlacedJson::Kind;

// Place of a value that is neither in a file nor in a single option.
constexpr const char* kCommandLine = "the command line";

struct JointsOptions {
  std::string specification;
  std::string output;
  std::vector<std::string> sets, tunnels, fixed, measured;
  std::string rectangle, slope;
  std::optional<int> seed;
  std::optional<double> edge_node_ratio;
  bool fixes_sides = false;
  bool may_overwrite = false;
  bool as_json = false;
};

PlacedJson list_of(const std::string& option, std::vector<PlacedJson> items) {
  return {Kind::list, "a list", 0, std::move(items), {}, {option}};
}

PlacedJson objects_of(const std::string& option, const std::vector<std::string>& texts) {
  std::vector<PlacedJson> items;
  for (const std::string& text : texts) items.push_back(formats::json_of_option(option, text));
  return list_of(option, std::move(items));
}

/// Parses lists of numbers separated by commas.
PlacedJson rows_of(const std::string& option, const std::vector<std::string>& texts) {
  std::vector<PlacedJson> rows;
  for (const std::string& text : texts) {
    std::vector<PlacedJson> numbers;
    for (std::string_view rest = text; !rest.empty();) {
      const std::string_view word = rest.substr(0, rest.find(','));
      numbers.push_back(formats::json_of_word(option, word));
      rest.remove_prefix(std::min(word.size() + 1, rest.size()));
    }
    rows.push_back(list_of(option, std::move(numbers)));
  }
  return list_of(option, std::move(rows));
}

void put(PlacedJson& object, const std::string& key, PlacedJson value) {
  const auto found = std::ranges::find(object.keys, key);
  if (found != object.keys.end()) {
    object.items[static_cast<std::size_t>(found - object.keys.begin())] = std::move(value);
  } else {
    object.keys.push_back(key);
    object.items.push_back(std::move(value));
  }
}

PlacedJson number_of(const std::string& option, double value) {
  return {Kind::number, fmt::format("{}", value), value, {}, {}, {option}};
}

/// Returns the file, or an object made of the options; the seed of an option overrides that of the file.
PlacedJson specification_of(const JointsOptions& options) {
  PlacedJson all{Kind::object, "an object", 0, {}, {}, {kCommandLine}};
  if (!options.specification.empty()) all = formats::read_json(formats::load(options.specification));
  if (all.kind != Kind::object) return all;
  if (!options.rectangle.empty()) put(all, "rectangle", formats::json_of_option("--rectangle", options.rectangle));
  if (!options.slope.empty()) put(all, "slope", formats::json_of_option("--slope", options.slope));
  if (!options.tunnels.empty()) put(all, "tunnels", objects_of("--tunnel", options.tunnels));
  if (!options.sets.empty()) put(all, "sets", objects_of("--set", options.sets));
  if (!options.fixed.empty()) put(all, "fixed", rows_of("--fixed", options.fixed));
  if (!options.measured.empty()) put(all, "measured", rows_of("--measured", options.measured));
  if (options.edge_node_ratio) put(all, "edge_node_ratio", number_of("--edge-node-ratio", *options.edge_node_ratio));
  if (options.seed) put(all, "seed", number_of("--seed", *options.seed));
  return all;
}

// Selects by the ending; files of Shi's programs have none of their own.
const formats::Format& format_of(const std::string& output) {
  if (output.ends_with(".dxf")) return formats::kDxf;
  if (output.ends_with(".json")) return formats::kKeyblockCase;
  if (output.ends_with(".xml")) return formats::kDdaml;
  return formats::kDdaGeometry;
}

struct Drawn {
  JointScene scene;
  Drawing drawing;
};

/// Adds fixed lines along the base and the vertical sides of the outline, a little inside so that they cross blocks.
void fix_base_and_sides(Drawing& drawing) {
  constexpr double kInside = 5e-4;  // of the size
  constexpr double kBeyond = 0.01;
  Point low = drawing.joints.front().segment.start, high = low;
  for (std::size_t i = 0; i < drawing.boundary_count; ++i)
    for (const Point p : {drawing.joints[i].segment.start, drawing.joints[i].segment.end}) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
  const double size = std::max(high.x - low.x, high.y - low.y);
  const double inside = kInside * size, beyond = kBeyond * size;
  const auto fix = [&](Point from, Point to) { drawing.fixed_lines.push_back({{from, to}, drawing.place}); };
  fix({low.x - beyond, low.y + inside}, {high.x + beyond, low.y + inside});
  for (const auto& [side, shift] : {std::pair{low.x, inside}, {high.x, -inside}}) {
    double top = low.y;
    for (std::size_t i = 0; i < drawing.boundary_count; ++i) {
      const Segment& edge = drawing.joints[i].segment;
      if (edge.start.x == side && edge.end.x == side) top = std::max({top, edge.start.y, edge.end.y});
    }
    if (top > low.y) fix({side + shift, low.y - beyond}, {side + shift, top + beyond});
  }
}

// A wrong option is an error of the command line, not of an input.
Drawn drawn(const JointsOptions& options) {
  try {
    const JointScene scene = formats::joint_scene_of(specification_of(options));
    return {scene, drawing_of(scene)};
  } catch (const InputError& error) {
    const std::string& place = error.place().file;
    if (place == kCommandLine) throw UsageError(error.sentence());
    if (place.starts_with("--")) throw UsageError(fmt::format("{}: {}", place, error.sentence()));
    throw;
  }
}

ExitCode make_joints(const JointsOptions& options) {
  require_writable({options.output}, {options.specification}, overwrite_if(options.may_overwrite));
  auto [scene, drawing] = drawn(options);
  if (options.fixes_sides) fix_base_and_sides(drawing);
  write_output(options.output, format_of(options.output).write({drawing, std::nullopt, std::nullopt}),
               overwrite_if(options.may_overwrite));
  if (options.as_json) {
    const nlohmann::ordered_json json = {{"output", options.output},
                                         {"joint_lines", drawing.joints.size() - drawing.boundary_count},
                                         {"boundary_lines", drawing.boundary_count},
                                         {"joint_sets", scene.sets.size()},
                                         {"tunnels", scene.tunnels.size()}};
    fmt::print("{}\n", json.dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
    return ExitCode::ok;
  }
  fmt::print("{}: {} joint lines, {} boundary lines; joint sets: {}, tunnels: {}\n", options.output,
             drawing.joints.size() - drawing.boundary_count, drawing.boundary_count, scene.sets.size(),
             scene.tunnels.size());
  return ExitCode::ok;
}

}  // namespace

Action configure_joints(CLI::App& app) {
  auto options = std::make_shared<JointsOptions>();
  auto* file =
      app.add_option("SPEC", options->specification,
                     "JSON file instead of the options (docs/slope.json): rectangle, slope or outline, sets, tunnels, "
                     "fixed, measured, seed, boundary_joint, edge_node_ratio, with the keys of the options below");
  app.add_option("-o,--output", options->output,
                 "drawing to write: DXF (.dxf), case file (.json), DDAML (.xml), else geometry file")
      ->type_name("FILE")
      ->required();
  const auto add = [&](const char* name, auto& value, const char* help) {
    return app.add_option(name, value, help)->excludes(file);
  };
  add("--set", options->sets,
      "joint set: dip=60,spacing=1,trace=5,gap=0.5,scatter=0.1,dip_scatter_deg=5,distribution=lognormal,joint=2; "
      "scatter: standard deviation over mean of spacing, trace and gap (and, without dip_scatter_deg, of the dip over "
      "90 degrees); may be repeated");
  add("--rectangle", options->rectangle, "outline: width=20,height=10,x=0,y=0");
  add("--slope", options->slope,
      "outline with the foot of its face at x = 0, y = 0: height=10,angle=60,bench=3,benches=2,toe=10,crest=15,base=5");
  add("--tunnel", options->tunnels, "shape=circle|d|horseshoe,width=4,height=4,x=10,y=5; may be repeated");
  add("--fixed", options->fixed, "fixed line: x1,y1,x2,y2; may be repeated");
  add("--measured", options->measured, "measured point: x,y; may be repeated");
  add("--edge-node-ratio", options->edge_node_ratio,
      "distance over the extent of the drawing, below which crossings are merged (default: 0.001)");
  app.add_flag("--fix-sides", options->fixes_sides, "fix the base and the vertical sides of the outline");
  app.add_option("--seed", options->seed, "seed of the random numbers, overrides that of SPEC (default: 1)");
  app.add_flag("--force", options->may_overwrite, "overwrite the file if it exists");
  app.add_flag("--json", options->as_json, "print the counts as JSON");
  return [options] { return make_joints(*options); };
}

}  // namespace keyblock
