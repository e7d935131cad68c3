// Searches folders for cases, recursively.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "api/case_folder.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.hpp"

namespace keyblock {

namespace fs = std::filesystem;

namespace {

/// Returns true for a link to a folder that contains it.
bool leads_up(const fs::directory_entry& entry) {
  if (!entry.is_symlink()) return false;
  std::error_code error;
  const fs::path target = fs::canonical(entry.path(), error), from = fs::canonical(entry.path().parent_path(), error);
  return std::ranges::mismatch(target, from).in1 == target.end();
}

// Folders that may not be read hold no cases.
void visit(const fs::path& folder, const fs::path& root, std::vector<CaseFolder>& cases) {
  std::error_code error;
  const auto holds = [&](const char* file) { return fs::exists(folder / file, error); };
  const bool has_expected = holds("expected.csv");
  const bool is_of_a_run = holds("run.json");  // its trace is not an expected one
  const bool has_trace = !is_of_a_run && holds("steps.csv") && holds("blocks.csv");
  if (has_expected || has_trace) {
    const fs::path relative = folder.lexically_relative(root);
    const std::string name =
        relative == "." ? folder.lexically_normal().filename().string() : relative.generic_string();
    cases.push_back({folder, name, has_expected, has_trace});
  }
  std::vector<fs::path> inner;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error))
    if (entry.is_directory(error) && !leads_up(entry)) inner.push_back(entry.path());
  std::ranges::sort(inner);
  for (const fs::path& below : inner) visit(below, root, cases);
}

}  // namespace

fs::path whole_path(const fs::path& folder) {
  const fs::path whole = fs::absolute(folder).lexically_normal();
  return whole.has_filename() ? whole : whole.parent_path();
}

std::vector<std::string> CaseFolder::inputs() const {
  const std::string base = (folder / whole_path(folder).filename()).string();
  if (fs::exists(base + ".json")) return {base + ".json"};
  const auto either = [&](const char* native, const char* usual) {
    return base + (fs::exists(base + native) ? native : usual);
  };
  return {either(".blk", ".geo"), either(".df", ".ana")};
}

std::vector<CaseFolder> find_cases(const std::vector<std::string>& paths) {
  std::vector<CaseFolder> cases;
  for (const std::string& path : paths) {
    fs::path root = fs::path(path).lexically_normal();
    if (!root.has_filename()) root = root.parent_path();
    if (!fs::is_directory(root))
      throw InputError(
          {path, 0, 0},
          "expected a folder with cases, found none (without a name, compare takes legacy_cases in this folder)");
    const std::size_t before = cases.size();
    visit(root, root, cases);
    if (cases.size() == before)
      throw InputError(
          {path, 0, 0},
          "expected a case (expected.csv, or steps.csv with blocks.csv), found none below it; `keyblock batch` runs a "
          "folder of files");
  }
  return cases;
}

CaseFolder the_case_in(const std::string& path) {
  const std::vector<CaseFolder> folders = find_cases({path});
  // Results of runs may lie below a case.
  const auto itself =
      std::ranges::find_if(folders, [&](const CaseFolder& folder) { return fs::equivalent(folder.folder, path); });
  if (itself != folders.end()) return *itself;
  if (folders.size() != 1)
    throw InputError({path, 0, 0}, fmt::format("expected one case, found {} below it", folders.size()));
  return folders.front();
}

}  // namespace keyblock
