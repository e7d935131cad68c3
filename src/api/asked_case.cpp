// Reads the folder, then the settings file, then adds the settings of the request. Values are changed after reading.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "api/asked_case.hpp"

#include <utility>

#include "api/named_files.hpp"
#include "base/context.hpp"
#include "formats/registry.hpp"
#include "run/settings_file.hpp"

namespace keyblock {

namespace fs = std::filesystem;

namespace {

// NAME stands for NAME.json or NAME.yaml if it names no file or folder itself.
std::string completed(const std::string& path) {
  std::error_code ignored;
  if (fs::exists(located(path), ignored) || fs::path(path).has_extension()) return path;
  for (const char* ending : {".json", ".yaml"})
    if (fs::is_regular_file(located(path + ending), ignored)) return path + ending;
  return path;
}

void put_files(AskedCase& asked, const std::vector<std::string>& paths) {
  for (const std::string& path : paths)
    if (path.empty()) throw InputError({"\"\""}, "expected the name of a file or a folder, found an empty one");
  if (paths.size() != 1 || !fs::is_directory(located(paths.front()))) {
    asked.files = paths.size() == 1 ? std::vector{completed(paths.front())} : paths;
    if (!paths.empty()) asked.name = fs::path(paths.front()).stem().string();
    return;
  }
  const CaseFolder folder = the_case_in(paths.front());
  const fs::path whole = whole_path(folder.folder);
  asked.name = (whole.parent_path().filename() / whole.filename()).string();  // cases share names such as "coarse"
  asked.folder = folder.folder;
  asked.file = read_case_file(folder);
  asked.files = folder.inputs();
}

void put_settings_file(AskedCase& asked, const std::string& path) {
  if (path.empty()) return;
  const SettingsFile file = read_settings(path, formats::load(path).text);
  if (asked.profile.empty()) asked.profile = file.profile;
  for (const auto& [name, value] : file.settings)
    asked.common.emplace_back(name, from_folder(fs::path(path).parent_path(), name, value));
}

}  // namespace

std::vector<Override> AskedCase::overrides(const std::string& under) const {
  std::vector<Override> all = file.overrides(under);
  all.insert(all.end(), common.begin(), common.end());
  return all;
}

AskedCase asked_case(const CaseRequest& request) {
  AskedCase asked;
  asked.profile = request.profile;
  asked.choices = request.choices;
  asked.values = request.values;
  put_files(asked, request.paths);
  put_settings_file(asked, request.settings_file);
  asked.common.insert(asked.common.end(), request.sets.begin(), request.sets.end());
  return asked;
}

const std::vector<formats::FileReading>& OpenCase::read_files() const {
  return unchanged_files.empty() ? input.files : unchanged_files;
}

void change_values(OpenCase& open, const std::vector<ChangedValue>& values) {
  formats::Case changed = with_values(open.input, values);
  if (open.unchanged_files.empty()) open.unchanged_files = std::move(open.input.files);
  open.input = std::move(changed);
}

OpenCase opened(AskedCase asked) {
  OpenCase open{std::move(asked), {}};
  open.input = formats::load_case(open.files, open.choices);
  if (!open.values.empty()) change_values(open, open.values);
  return open;
}

}  // namespace keyblock
