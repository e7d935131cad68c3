// Table of the keys of joint sets, and the schema made of it.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/case_file/schema/joint_keys.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "formats/case_file/schema/limits.hpp"
#include "formats/text/demands.hpp"

namespace keyblock::formats {
namespace {

using Json = nlohmann::ordered_json;

constexpr Demand kAnyNumber{{}, "a number"};
constexpr Demand kDip{{-360, false, 360}, "-360 to 360 degrees"};
constexpr Demand kDipScatter{{0, false, 90}, "0 to 90 degrees"};
constexpr Demand kFaceAngle{{0, true, 90}, "above 0 to 90 degrees"};
constexpr Demand kSeed{{0}, "a whole number, 0 or more", true};
constexpr Demand kLifts{{1, false, 1000}, "a whole number from 1 to 1000", true};

constexpr bool kIsRequired = true;
constexpr bool kIsOptional = false;

constexpr std::array kJointKeys{
    JointKey{"specification", "rectangle", "Rectangle", "", nullptr, "", kIsOptional, "outline: a rectangle"},
    JointKey{"specification", "slope", "Slope", "", nullptr, "", kIsOptional,
             "outline: ground that rises to the right"},
    JointKey{"specification", "outline", "Outline", "", nullptr, "", kIsOptional,
             "outline: corners [x, y] in either direction; the first is not repeated"},
    JointKey{"specification", "tunnels", "Tunnels", "", nullptr, "", kIsOptional, "openings inside the outline"},
    JointKey{"specification", "sets", "Joint sets", "", nullptr, "", kIsOptional, "joint sets"},
    JointKey{"specification", "seed", "Seed", "none", &kSeed, "1", kIsOptional,
             "start of the random numbers; another seed draws the joints at other places"},
    JointKey{"specification", "boundary_joint", "Joint material of the outline", "none", &kAtLeastOne, "1", kIsOptional,
             "joint material of the outline and the tunnels, from 1"},
    JointKey{"specification", "edge_node_ratio", "Edge-node ratio", "none", &kEdgeNodeRatio, "0.001", kIsOptional,
             "distance over the extent of the drawing, below which crossings are merged"},
    JointKey{"specification", "fixed", "Fixed lines", "", nullptr, "", kIsOptional, "fixed lines [x1, y1, x2, y2]"},
    JointKey{"specification", "measured", "History points", "", nullptr, "", kIsOptional, "measured points [x, y]"},

    JointKey{"rectangle", "width", "Width", "L", &kPositive, "", kIsRequired, "width of the rectangle"},
    JointKey{"rectangle", "height", "Height", "L", &kPositive, "", kIsRequired, "height of the rectangle"},
    JointKey{"rectangle", "x", "x", "L", &kAnyNumber, "0", kIsOptional, "left side"},
    JointKey{"rectangle", "y", "y", "L", &kAnyNumber, "0", kIsOptional, "lower side"},

    JointKey{"slope", "height", "Height", "L", &kPositive, "", kIsRequired, "height of the face"},
    JointKey{"slope", "angle", "Angle", "deg", &kFaceAngle, "", kIsRequired, "angle of the face from the horizontal"},
    JointKey{"slope", "bench", "Bench", "L", &kNotNegative, "0", kIsOptional, "width of the level benches"},
    JointKey{"slope", "benches", "Lifts", "none", &kLifts, "1", kIsOptional, "number of lifts of the face"},
    JointKey{"slope", "toe", "Toe", "L", &kNotNegative, "the height", kIsOptional, "level ground before the face"},
    JointKey{"slope", "crest", "Crest", "L", &kNotNegative, "1.5 times the height", kIsOptional,
             "level ground behind the face"},
    JointKey{"slope", "base", "Base", "L", &kPositive, "half of the height", kIsOptional,
             "rock below the foot of the face"},
    JointKey{"slope", "x", "x", "L", &kAnyNumber, "0", kIsOptional, "foot of the face"},
    JointKey{"slope", "y", "y", "L", &kAnyNumber, "0", kIsOptional, "foot of the face"},

    JointKey{"tunnel", "shape", "Shape", "", nullptr, "", kIsRequired, "section of the tunnel"},
    JointKey{"tunnel", "width", "Width", "L", &kPositive, "", kIsRequired, "width of the tunnel"},
    JointKey{"tunnel", "height", "Height", "L", &kPositive, "the width", kIsOptional, "height of the tunnel"},
    JointKey{"tunnel", "x", "x", "L", &kAnyNumber, "", kIsRequired, "middle of the tunnel"},
    JointKey{"tunnel", "y", "y", "L", &kAnyNumber, "", kIsRequired, "middle of the tunnel"},

    JointKey{"set", "dip", "Dip", "deg", &kDip, "", kIsRequired, "angle from the x axis, counter-clockwise"},
    JointKey{"set", "spacing", "Spacing", "L", &kPositive, "", kIsRequired, "mean distance between rows of joints"},
    JointKey{"set", "trace", "Trace length", "L", &kPositive, "through the whole outline", kIsOptional,
             "mean length of a joint"},
    JointKey{"set", "gap", "Gap", "L", &kNotNegative, "0", kIsOptional,
             "mean length of rock between two traces of a row"},
    JointKey{"set", "scatter", "Scatter", "none", &kShare, "0", kIsOptional,
             "standard deviation over mean of spacing, trace and gap"},
    JointKey{"set", "dip_scatter", "Scatter of the dip as a share", "none", &kShare, "scatter", kIsOptional,
             "standard deviation of the dip over 90 degrees"},
    JointKey{"set", "dip_scatter_deg", "Scatter of the dip", "deg", &kDipScatter, "90 degrees times scatter",
             kIsOptional, "standard deviation of the dip"},
    JointKey{"set", "spacing_scatter", "Scatter of the spacing", "none", &kShare, "scatter", kIsOptional,
             "standard deviation over mean of the spacing"},
    JointKey{"set", "trace_scatter", "Scatter of the trace", "none", &kShare, "scatter", kIsOptional,
             "standard deviation over mean of the trace length"},
    JointKey{"set", "gap_scatter", "Scatter of the gap", "none", &kShare, "scatter", kIsOptional,
             "standard deviation over mean of the gap"},
    JointKey{"set", "distribution", "Distribution", "", nullptr, "lognormal", kIsOptional,
             "distribution of spacing, trace and gap"},
    JointKey{"set", "spacing_distribution", "Distribution of the spacing", "", nullptr, "distribution", kIsOptional,
             "distribution of the spacing"},
    JointKey{"set", "trace_distribution", "Distribution of the trace", "", nullptr, "distribution", kIsOptional,
             "distribution of the trace length"},
    JointKey{"set", "gap_distribution", "Distribution of the gap", "", nullptr, "distribution", kIsOptional,
             "distribution of the gap"},
    JointKey{"set", "joint", "Joint material", "none", &kAtLeastOne, "number of the set in the list", kIsOptional,
             "joint material of the set, from 1"},
    JointKey{"set", "seed", "Seed of the set", "none", &kSeed, "seed of the specification", kIsOptional,
             "start of the random numbers of the set"}};

constexpr std::array kJointWords{
    JointWord{"shape", "circle", "circle, or ellipse if width and height differ"},
    JointWord{"shape", "d", "half a circle on upright walls"},
    JointWord{"shape", "horseshoe", "half a circle on curved walls, with a level floor"},
    JointWord{"distribution", "normal", "normal distribution, cut off at 0"},
    JointWord{"distribution", "lognormal", "lognormal distribution"},
    JointWord{"distribution", "exponential", "exponential distribution; its scatter is 1"}};

Json number_of(std::string_view text) {
  return Json::accept(text) ? Json::parse(text) : Json();
}

/// Adds the default; one that depends on other keys is written in words.
void put_absent(Json& schema, const JointKey& key, const std::vector<std::string_view>& words) {
  if (key.absent.empty()) return;
  const Json number = number_of(key.absent);
  const bool is_word = std::ranges::find(words, key.absent) != words.end();
  if (number.is_number() || is_word)
    schema["default"] = is_word ? Json(key.absent) : number;
  else
    schema["x-default"] = key.absent;
}

Json schema_of(const JointKey& key) {
  const std::vector<std::string_view> words = joint_words_of(key.key);
  Json schema = Json::object();
  if (key.demand) schema["type"] = key.demand->whole ? "integer" : "number";
  if (!words.empty()) schema["enum"] = words;
  schema["title"] = key.title;
  schema["description"] = key.meaning;
  put_absent(schema, key, words);
  for (const JointWord& word : kJointWords)
    if (key.key.ends_with(word.key)) schema["x-words"][word.word] = word.meaning;
  if (!key.demand) return schema;
  schema["x-unit"] = key.unit;
  if (key.demand == &kAnyNumber) return schema;
  schema["description"] = fmt::format("{}. Permitted: {}", key.meaning, key.demand->wording);
  schema["x-permitted"] = key.demand->wording;
  put_limits(schema, key.demand->range);
  return schema;
}

Json object_of(std::string_view parent) {
  Json properties = Json::object(), required = Json::array();
  for (const JointKey& key : kJointKeys) {
    if (key.parent != parent) continue;
    properties[key.key] = schema_of(key);
    if (key.is_required) required.push_back(key.key);
  }
  Json schema = {{"type", "object"}, {"properties", properties}, {"additionalProperties", false}};
  if (!required.empty()) schema["required"] = required;
  return schema;
}

Json rows_of(std::size_t numbers) {
  return {
      {"type", "array"},
      {"items", {{"type", "array"}, {"items", {{"type", "number"}}}, {"minItems", numbers}, {"maxItems", numbers}}}};
}

}  // namespace

std::span<const JointKey> joint_keys() {
  return kJointKeys;
}

std::vector<std::string_view> joint_keys_of(std::string_view parent) {
  std::vector<std::string_view> keys;
  for (const JointKey& key : kJointKeys)
    if (key.parent == parent) keys.push_back(key.key);
  return keys;
}

const Demand& joint_demand(std::string_view parent, std::string_view key) {
  for (const JointKey& own : kJointKeys)
    if (own.parent == parent && own.key == key && own.demand) return *own.demand;
  throw std::logic_error(fmt::format("the table of joint sets has no number {} of {}", key, parent));
}

std::vector<std::string_view> joint_words_of(std::string_view key) {
  std::vector<std::string_view> words;
  for (const JointWord& word : kJointWords)
    if (key.ends_with(word.key)) words.push_back(word.word);
  return words;
}

std::string joint_schema() {
  Json schema = object_of("specification");
  Json& keys = schema["properties"];
  keys["rectangle"].update(object_of("rectangle"));
  keys["slope"].update(object_of("slope"));
  keys["outline"].update(rows_of(2));
  keys["fixed"].update(rows_of(4));
  keys["measured"].update(rows_of(2));
  keys["tunnels"].update({{"type", "array"}, {"items", object_of("tunnel")}});
  keys["sets"].update({{"type", "array"}, {"items", object_of("set")}});
  Json head = {{"$schema", "https://json-schema.org/draft/2020-12/schema"}, {"title", "Specification of joint sets"}};
  head.update(schema);
  return head.dump(1) + "\n";
}

}  // namespace keyblock::formats
