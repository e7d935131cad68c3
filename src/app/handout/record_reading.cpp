// Walks the record by keys; every miss is null.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/handout/record_reading.hpp"

#include <fmt/format.h>

#include "base/bytes/file_bytes.hpp"
#include "base/bytes/sound_json.hpp"
#include "base/error.hpp"
#include "base/words/plain_number.hpp"
#include "job/folder/output_files.hpp"
#include "problem/units/readable.hpp"

namespace keyblock {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kDigits = 6;

// Returns the path of a file in the folder. Throws InputError if the file is missing.
std::filesystem::path file_in(const std::filesystem::path& folder, const char* name) {
  std::filesystem::path file = folder / name;
  if (!std::filesystem::is_regular_file(file))
    throw InputError({folder.string()}, fmt::format("expected the folder of a run, with {}, found none", name));
  return file;
}

}  // namespace

ResultRecord::ResultRecord(const std::filesystem::path& file, const char* key, const char* what)
    : json_(sound_json(file_bytes(file.string()))) {
  if (!json_.is_object() || !json_.contains(key))
    throw InputError({file.string()}, fmt::format("expected the record of {}, found another file", what));
  units_ = {text("units.length"), text("units.mass"), text("units.time")};
}

RunRecordFile::RunRecordFile(const std::filesystem::path& folder)
    : ResultRecord(file_in(folder, kRecord), "outcome", "a run (JSON)") {}

const Json& ResultRecord::at(std::string_view path) const {
  const Json* here = &json_;
  while (!path.empty()) {
    const std::size_t dot = path.find('.');
    here = &member(*here, std::string(path.substr(0, dot)).c_str());
    path = dot == std::string_view::npos ? std::string_view() : path.substr(dot + 1);
  }
  return *here;
}

const Json& ResultRecord::list(std::string_view path) const {
  static const Json kNone = Json::array();
  const Json& found = at(path);
  return found.is_array() ? found : kNone;
}

std::string ResultRecord::text(std::string_view path) const {
  const Json& found = at(path);
  return found.is_string() ? found.get<std::string>() : std::string();
}

std::string ResultRecord::quantity(std::string_view path, const Measure& measure) const {
  const Json& found = at(path);
  return found.is_number() ? readable(found.get<double>(), measure, units_) : std::string();
}

std::string ResultRecord::unit_of(const std::string& path) const {
  const Json& all = at("unit_of");
  return all.is_object() && all.contains(path) && all[path].is_string() ? all[path].get<std::string>() : std::string();
}

const Json& member(const Json& of, const char* key) {
  static const Json kNone;
  const auto found = of.is_object() ? of.find(key) : of.end();
  return found == of.end() ? kNone : *found;
}

std::string plain_text(const Json& value) {
  if (value.is_string()) return value.get<std::string>();
  if (value.is_boolean()) return value.get<bool>() ? "yes" : "no";
  if (value.is_number_float()) return plain(value.get<double>(), kDigits);
  if (value.is_null()) return "";
  return value.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace keyblock
