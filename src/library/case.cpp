// Reads a case, changes its values through its case file, writes it.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "formats/all_content.hpp"
#include "job/files.hpp"
#include "library/parts.hpp"
#include "study/convert/convert.hpp"

namespace keyblock::api {

namespace {

using Json = nlohmann::ordered_json;

std::string text_of(const Case::Data& data) {
  return formats::case_file_text(data.open.input.files);
}

// Throws Error: an existing file is not a wrong setting, and nothing here overwrites one.
void require_nothing_there(const std::filesystem::path& file) {
  try {
    require_free(file, Overwrite::no);
  } catch (const UsageError&) {
    throw Error(file.string() + " exists; give another name", ErrorCode::choice);
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

Case::Data::Data(OpenCase of) : open(std::move(of)), warnings(public_warnings(open.input.warnings)) {}

Case Case::read(const std::vector<std::string>& paths, const Drawing& drawing) {
  return guarded([&] {
    if (paths.empty()) throw Error("expected the files of a case, or its folder, found none", ErrorCode::choice);
    return Data::case_of(opened(asked_case({paths, {}, {}, {}, {drawing.unit, drawing.join}})));
  });
}

const std::vector<Warning>& Case::warnings() const {
  return data_->warnings;
}

std::vector<std::string> Case::units() const {
  const Units& units = data_->open.input.problem.units;
  return {units.length, units.mass, units.time};
}

std::string Case::profile() const {
  return guarded([&] { return profile_for(data_->open, data_->open.input.problem).name; });
}

std::string Case::json() const {
  return guarded([&] { return text_of(*data_); });
}

std::string Case::get(std::string_view pointer) const {
  return guarded([&] { return value_at(pointer, text_of(*data_)); });
}

std::vector<std::string> Case::pointers(std::string_view pointer) const {
  return guarded([&] { return pointers_to(pointer, text_of(*data_)); });
}

Case Case::with(std::string_view pointer, std::string_view value) const {
  return guarded([&] {
    if (!Json::accept(value))
      throw Error(fmt::format("{}: expected a value as JSON, found {}", pointer, value), ErrorCode::choice);
    OpenCase open = data_->open;
    const ChangedValue changed{std::string(pointer), std::string(value)};
    change_values(open, {changed});
    open.values.push_back(changed);
    return Data::case_of(std::move(open));
  });
}

Case Case::with(std::string_view pointer, double value) const {
  return with(pointer, Json(value).dump());
}

std::vector<std::string> Case::write(const std::string& path, std::string_view format) const {
  return guarded([&] {
    const study::Target& target = study::target_named(format);
    const study::Conversion made = study::convert(data_->open.input.files, target, study::Faults::none,
                                                  std::filesystem::absolute(path).parent_path());
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
    for (const auto& [name, value] : data_->open.overrides(profile_for(data_->open, data_->open.input.problem).name))
      told.push_back(fmt::format("setting {} = {} of case.json is not carried over", name, value));
    return told;
  });
}

}  // namespace v1
}  // namespace keyblock::api
