// `keyblock formats`: lists the formats with the evidence for each layout, and prints the layout of the case file.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/command.hpp"
#include "base/error.hpp"
#include "base/nearest.hpp"
#include "formats/case_file/keyblock_case.hpp"
#include "formats/case_file/material_library.hpp"
#include "formats/case_file/schema/joint_keys.hpp"
#include "formats/registry.hpp"

namespace keyblock {
namespace {

using Json = nlohmann::ordered_json;

struct FormatsOptions {
  std::string name;
  bool wants_schema = false;
  bool wants_joint_schema = false;
  bool wants_materials = false;
  bool as_json = false;
};

const char* yes_or_no(bool value) {
  return value ? "yes" : "no";
}

void print_table() {
  fmt::print("{:<22} {:<6} {:<6} {:<52} {}\n", "format", "reads", "writes", "holds", "known from");
  for (const formats::Format* format : formats::all_formats())
    fmt::print("{:<22} {:<6} {:<6} {:<52} {}\n", format->name, yes_or_no(format->read), yes_or_no(format->write),
               format->title, format->evidence);
}

Json json_of(const formats::Format& format) {
  return {{"name", format.name},
          {"title", format.title},
          {"reads", format.read != nullptr},
          {"writes", format.write != nullptr},
          {"evidence", format.evidence},
          {"sample", format.sample}};
}

/// Returns the values in SI, as for a case that declares m, kg and s.
Json library_json() {
  const Units units{"m", "kg", "s"};
  Json rocks = Json::array(), joints = Json::array();
  for (const std::string& name : formats::library_names(BlockMaterial{})) {
    BlockMaterial rock;
    formats::take_from_library(name, units, rock);
    rocks.push_back({{"like", name},
                     {"density", rock.density},
                     {"youngs_modulus", rock.youngs_modulus},
                     {"poissons_ratio", rock.poissons_ratio}});
  }
  for (const std::string& name : formats::library_names(JointMaterial{})) {
    JointMaterial joint;
    formats::take_from_library(name, units, joint);
    joints.push_back({{"like", name}, {"friction_angle_deg", joint.friction_angle_deg}});
  }
  return {{"units", {{"length", "m"}, {"mass", "kg"}, {"time", "s"}}},
          {"block_materials", rocks},
          {"joint_materials", joints}};
}

[[noreturn]] void refuse_format(const std::string& name) {
  std::string lower = name;
  std::ranges::transform(lower, lower.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  std::vector<std::string> names;
  for (const formats::Format* format : formats::all_formats()) names.emplace_back(format->name);
  throw UsageError(
      fmt::format("there is no format \"{}\"{}; `keyblock formats` lists them", name, nearest_words(lower, names)));
}

ExitCode list(const FormatsOptions& options) {
  if (options.wants_schema) {
    fmt::print("{}", formats::case_schema());
  } else if (options.wants_joint_schema) {
    fmt::print("{}", formats::joint_schema());
  } else if (options.wants_materials) {
    fmt::print("{}", options.as_json ? library_json().dump(1) + "\n" : formats::library_tables());
  } else if (!options.name.empty()) {
    const formats::Format* format = formats::find_format(options.name);
    if (!format) refuse_format(options.name);
    if (options.as_json) {
      fmt::print("{}\n", json_of(*format).dump(1));
    } else {
      fmt::print("{}: {}\nreads: {}, writes: {}\nknown from: {}\n", format->name, format->title,
                 yes_or_no(format->read), yes_or_no(format->write), format->evidence);
      if (!format->sample.empty()) fmt::print("a sample:\n\n{}", format->sample);
    }
  } else if (options.as_json) {
    Json all = Json::array();
    for (const formats::Format* format : formats::all_formats()) all.push_back(json_of(*format));
    fmt::print("{}\n", all.dump(1));
  } else {
    print_table();
  }
  return ExitCode::ok;
}

}  // namespace

Action configure_formats(CLI::App& app) {
  const auto options = std::make_shared<FormatsOptions>();
  CLI::Option* const parts[] = {
      app.add_option("NAME", options->name, "print one format with a sample")->check([](const std::string& name) {
        return name.empty() ? "expected the name of a format, found an empty one" : std::string();
      }),
      app.add_flag("--schema", options->wants_schema, "print the JSON Schema of the case file"),
      app.add_flag("--joint-schema", options->wants_joint_schema,
                   "print the JSON Schema of the file of keyblock joints"),
      app.add_flag("--materials", options->wants_materials,
                   "print the library of rocks and joints for the key `like`")};
  for (CLI::Option* part : parts)
    for (CLI::Option* other : parts)
      if (part != other) part->excludes(other);
  app.add_flag("--json", options->as_json, "print as JSON");
  return [options] { return list(*options); };
}

}  // namespace keyblock
