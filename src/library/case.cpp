// Reads a case, changes its values through its case file, writes it.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "formats/case_file/keyblock_case.hpp"
#include "formats/strict_json.hpp"
#include "job/files.hpp"
#include "library/parts.hpp"
#include "study/convert/convert.hpp"

namespace keyblock::api {

namespace {

using Json = nlohmann::ordered_json;

// A single case file is returned unchanged. If it has comments or trailing commas, or is YAML, it becomes strict JSON
// of the same values.
std::string text_of(const Case::Data& data) {
  const study::Conversion made =
      study::convert(data.open.input.files, study::target_named(formats::kKeyblockCase.name), study::Faults::none);
  const std::string& text = made.files.front().text;
  return Json::accept(text) ? text : formats::strict_json({data.open.input.files.front().path, text});
}

Json json_of(const Case::Data& data) {
  return Json::parse(text_of(data), nullptr, true, true);
}

Json::json_pointer pointer_in(const Json& json, std::string_view pointer) {
  try {
    Json::json_pointer at{std::string(pointer)};
    if (json.contains(at)) return at;
  } catch (const Json::exception&) {
  }
  throw SettingError(
      fmt::format("expected a pointer to a value of the case, such as /analysis/time_step, found {}", pointer));
}

// Files of Shi's programs keep their formats, with the rules that belong to them.
Case::Data changed(const Case::Data& before, const std::string& text) {
  Case::Data after{before.open, {}};
  formats::FileReading file;
  file.path = (std::filesystem::path(before.open.input.files.front().path).parent_path() / "changed case").string();
  file.source = {file.path, text};
  file.choice = formats::recognise(file.source);
  file.reading = formats::read_as(*file.choice, file.source);
  file.reading->content.is_own_case = before.open.input.problem.has_own_case;
  after.open.input = formats::case_of({std::move(file)});
  Warnings warnings = before.open.input.warnings;
  for (const keyblock::Warning& warning : after.open.input.warnings)
    if (std::ranges::none_of(warnings, [&](const auto& known) { return known.sentence == warning.sentence; }))
      warnings.push_back(warning);
  after.open.input.warnings = std::move(warnings);
  after.warnings = public_warnings(after.open.input.warnings);
  return after;
}

// Throws Error: an existing file is not a wrong setting.
void require_nothing_there(const std::filesystem::path& file) {
  try {
    require_free(file, Overwrite::no);
  } catch (const UsageError& error) {
    throw Error(error.what());
  }
}

}  // namespace

AskedCase asked_under(const Case& of, const Choices& choices) {
  AskedCase asked = of.data().open;
  if (!choices.profile.empty()) asked.profile = choices.profile;
  asked.common.insert(asked.common.end(), choices.set.begin(), choices.set.end());
  return asked;
}

inline namespace v1 {

Case Case::read(const std::vector<std::string>& paths) {
  return guarded([&] {
    if (paths.empty()) throw SettingError("expected the files of a case, or its folder, found none");
    auto data = std::make_shared<Data>();
    data->open = opened(asked_case({paths, {}, {}, {}}));
    data->warnings = public_warnings(data->open.input.warnings);
    return Case(std::move(data));
  });
}

const std::vector<Warning>& Case::warnings() const {
  return data_->warnings;
}

std::vector<std::string> Case::units() const {
  const Units& units = data_->open.input.problem.units;
  return {units.length, units.mass, units.time};
}

std::string Case::json() const {
  return guarded([&] { return text_of(*data_); });
}

std::string Case::get(std::string_view pointer) const {
  return guarded([&] {
    const Json json = json_of(*data_);
    return json.at(pointer_in(json, pointer)).dump();
  });
}

Case Case::with(std::string_view pointer, std::string_view value) const {
  return guarded([&] {
    Json json = json_of(*data_);
    const Json given = Json::parse(value, nullptr, false);
    if (given.is_discarded()) throw SettingError(fmt::format("expected a value as JSON, found {}", value));
    json[pointer_in(json, pointer)] = given;
    return Case(std::make_shared<const Data>(changed(*data_, json.dump(1))));
  });
}

Case Case::with(std::string_view pointer, double value) const {
  return with(pointer, Json(value).dump());
}

std::vector<std::string> Case::write(const std::string& path, std::string_view format) const {
  return guarded([&] {
    const study::Target& target = study::target_named(format);
    const study::Conversion made = study::convert(data_->open.input.files, target, study::Faults::none);
    std::vector<std::filesystem::path> files;
    for (const study::ConvertedFile& file : made.files) {
      std::filesystem::path name = path;
      if (target.parts.size() > 1) name += std::string(file.ending);
      require_nothing_there(name);
      files.push_back(std::move(name));
    }
    for (std::size_t i = 0; i < files.size(); ++i) write_output(files[i], made.files[i].text, Overwrite::no);
    std::vector<std::string> told;
    for (const study::Loss& loss : made.losses) told.push_back(fmt::format("{}: {}", loss.item, loss.sentence));
    for (const keyblock::Warning& warning : joined(made.warnings, made.changed_rules)) told.push_back(warning.sentence);
    return told;
  });
}

}  // namespace v1
}  // namespace keyblock::api
