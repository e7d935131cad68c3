// Reads and writes the case file and checks its references; keys in case_fields.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/case_file/keyblock_case.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <span>
#include <stdexcept>

#include "base/sentences/sentences.hpp"
#include "formats/case_file/fields/case_checks.hpp"
#include "formats/case_file/case_fields.hpp"
#include "formats/case_file/case_reading.hpp"
#include "formats/case_file/case_sample.hpp"
#include "formats/case_file/case_values.hpp"
#include "formats/case_file/case_writing.hpp"
#include "formats/case_file/yaml_text.hpp"
#include "material/crack_closure.hpp"
#include "material/strength.hpp"
#include "problem/units/unit_conversion.hpp"

namespace keyblock::formats {
namespace {

constexpr std::string_view kMark = "\"keyblock\"";
constexpr Demand kVersion{{kCaseVersion, false, kCaseVersionOfToday}, "version 1 or 2", true};
constexpr double kGravityOfToday = 9.81;  // m/s2

Recognition recognise(const Source& source) {
  using Fit = Recognition::Fit;
  if (is_yaml_case(source.text)) return {Fit::exact, "YAML with the key keyblock"};
  const std::string_view text = without_bom(source.text);
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos ||
      (text[first] != '{' && text.substr(first, 2) != "//" && text.substr(first, 2) != "/*"))
    return {};
  if (text.find(kMark) == std::string_view::npos)
    return {Fit::damaged, "it begins like JSON, without the key \"keyblock\""};
  return {Fit::exact, "JSON with the key \"keyblock\""};
}

// Stores the places of the profile and of each setting.
void place_choices(RunChoices& choices, const JsonValue& run) {
  if (const auto profile = run.member("profile")) choices.profile_place = profile->place();
  const auto settings = run.member("set");
  if (!settings) return;
  for (auto i = settings->begin(); i != settings->end(); ++i) {
    choices.setting_places.push_back((*i).place());
    ++i;
  }
}

// Stores the place of each row of a table of layers.
void place_layers(LayerTable& layers, const JsonValue& from) {
  for (auto i = from.begin(); i != from.end(); ++i) {
    layers.places.push_back((*i).place());
    ++i;
  }
}

Warnings take_default_ratio(Drawing& drawing, const JsonValue& from) {
  if (from.member("edge_node_ratio")) return {};
  drawing.edge_node_ratio = kDefaultEdgeNodeRatio;
  return {warning_of({"default_edge_node_ratio", {{{"edge_node_ratio", kDefaultEdgeNodeRatio}}}}, from.place())};
}

// Warns of weightless rock, which is seldom intended.
Warnings weightless_materials(const Analysis& analysis, const JsonValue& from) {
  Warnings warnings;
  const auto materials = from.member("block_materials");
  if (analysis.gravity || !materials) return warnings;
  for (const JsonValue material : *materials)
    if (!material.member("unit_weight"))
      add_warning(warnings, warning_of({"default_unit_weight", {{{"unit_weight", 0}}}}, material.place()));
  return warnings;
}

// Sets the defaults of version 2 for missing keys, with one warning for the whole file.
Warnings take_defaults_of_today(Content& content, const JsonValue& from) {
  Analysis& analysis = *content.analysis;
  std::vector<std::string> taken;
  Facts facts;
  const auto take = [&](const char* key, double number, const char* value) {
    if (from.member(key)) return;
    facts.numbers.emplace_back(key, number);
    taken.push_back(fmt::format("{} {}", key, value));
  };
  take("velocity_carry_over", 1, "1 (motion in time)");
  take("plane_strain", 1, "true");
  take("allowed_displacement_ratio", 0.01, "0.01");
  const bool has_weight =
      std::ranges::any_of(analysis.block_materials, [](const BlockMaterial& m) { return m.unit_weight != 0; });
  if (!analysis.gravity && !has_weight) {
    const std::optional<double> factor = si_factor(content.units.value_or(Units{}), kAcceleration);
    analysis.gravity = kGravityOfToday / factor.value_or(1);
    facts.numbers.emplace_back("gravity", *analysis.gravity);
    taken.push_back(fmt::format("gravity {:.6g}{}", *analysis.gravity, factor ? "" : " (no units are declared)"));
  }
  if (taken.empty()) return {};
  facts.texts = {{"taken", fmt::format("{}", fmt::join(taken, ", "))}};
  return {warning_of({"defaults_taken", std::move(facts)}, from.place())};
}

// Units come first: values are converted into them before fields are read.
MaterialNames resolve(JsonText& text) {
  if (const auto declared = text.root().member("units"); declared && declared->kind() == JsonKind::object) {
    CaseReading fields(*declared, "units");
    Units units;
    describe(fields, units);
    fields.finish();
    require_sound(units, declared->place());
    text.declare(units);
  }
  return resolve_names(text);
}

// Largest plausible closure strain of cracks in rock.
constexpr double kLargeClosure = 0.1;

Warnings doubtful_strengths(const Analysis& analysis) {
  Warnings warnings;
  for (const BlockMaterial& material : analysis.block_materials) {
    if (material.strength)
      for (const Finding& doubt : doubts_of(*material.strength))
        add_warning(warnings, warning_of(doubt, material.place));
    const double closure = material.crack_closure ? material.crack_closure->closure_strain : 0;
    if (closure > kLargeClosure)
      add_warning(warnings,
                  warning_of({"implausible_closure_strain", {{{"closure_strain", closure}, {"most", kLargeClosure}}}},
                             material.place));
  }
  return warnings;
}

template <class Part>
void require_sound_part(const std::optional<Part>& part) {
  if (part) require_sound(*part);
}

template <class Part>
void name_file(std::optional<Part>& part, const std::string& file) {
  if (part) part->place = {file};
}

Reading read_case(const Source& source, const ReadHint&) {
  std::optional<JsonText> parsed;
  if (is_yaml_case(source.text))
    read_yaml(parsed.emplace(source, JsonText::Unread{}), source);
  else
    parsed.emplace(source);
  JsonText& text = *parsed;
  if (text.root().kind() != JsonKind::object) text.root().fail("an object");
  Reading reading;
  Content& content = reading.content;
  content.names = resolve(text);
  content.is_own_case = true;
  CaseReading fields(text.root(), "the case file");
  int version = 0;
  fields.integer("keyblock", version, kVersion);
  if (version == kCaseVersionOfToday) fields.take_defaults_of_today();
  describe(fields, content);
  fields.finish();
  const int geometries = (content.drawing ? 1 : 0) + (content.blocks ? 1 : 0) + (content.cover ? 1 : 0);
  if (geometries > 1) text.root().fail("one of drawing, blocks and cover");
  if (!fits_a_case(content))
    reading.warnings.push_back({"empty_case", text.root().place(), "the case file holds nothing but its version"});
  if (content.choices) place_choices(*content.choices, *text.root().member("run"));
  if (!content.layers.rows.empty()) place_layers(content.layers, *text.root().member("layers"));
  if (content.outputs) require_sound(*content.outputs);
  if (content.drawing) reading.warnings = take_default_ratio(*content.drawing, *text.root().member("drawing"));
  if (content.analysis && version == kCaseVersionOfToday)
    reading.warnings =
        joined(std::move(reading.warnings), take_defaults_of_today(content, *text.root().member("analysis")));
  if (content.analysis)
    reading.warnings =
        joined(std::move(reading.warnings), weightless_materials(*content.analysis, *text.root().member("analysis")));
  if (content.analysis) reading.warnings = joined(std::move(reading.warnings), doubtful_strengths(*content.analysis));
  if (content.analysis)
    if (const auto step = text.root().member("analysis")->member("time_step"))
      content.analysis->time_step_place = step->place();
  if (content.units) require_sound(*content.units, text.root().member("units")->place());
  require_sound_part(content.drawing);
  require_sound_part(content.blocks);
  require_sound_part(content.cover);
  require_sound_part(content.covers);
  require_sound_part(content.loads);
  require_sound_part(content.analysis);
  if (content.covers && content.analysis) check_joints_of_cracks(*content.covers, *content.analysis);
  require_sound(content.stages);
  const int stages = static_cast<int>(content.stages.size());
  if (content.covers) check_stages_of(*content.covers, stages);
  if (content.loads) check_stages_of(*content.loads, stages);
  if (!content.frames.empty()) require_sound(content.frames, *text.root().member("frames"));
  name_file(content.drawing, source.name);
  name_file(content.blocks, source.name);
  name_file(content.cover, source.name);
  name_file(content.analysis, source.name);
  return reading;
}

std::string write_case(const Content& content) {
  if (!fits_a_case(content))
    throw std::invalid_argument("a case file needs a geometry, an analysis, a motion or results");
  std::string text;
  CaseWriting fields(text, CaseWriting::Shape::object, 0);
  fields.integer("keyblock", kCaseVersion, {});
  describe(fields, content);
  fields.finish();
  text += '\n';
  return text;
}

}  // namespace

bool fits_a_case(const Content& content) {
  return content.drawing || content.blocks || content.cover || content.covers || content.loads || content.analysis ||
         content.motion || content.units || content.choices || content.outputs || !content.layers.rows.empty() ||
         !content.stages.empty() || !content.frames.empty() || !content.tracks.empty();
}

const Format kKeyblockCase{
    .name = "keyblock-case",
    .title = "Keyblock case file",
    .recognise = recognise,
    .read = read_case,
    .write = write_case,
    .evidence = "documented here: formats/case_file/keyblock_case.hpp, `keyblock formats --schema`",
    .sample = kCaseSample};

}  // namespace keyblock::formats
