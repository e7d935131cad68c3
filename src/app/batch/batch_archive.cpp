// Reads every file of the archive once, in parallel.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/batch/batch_archive.hpp"

#include <fmt/format.h>

#include <new>

#include "base/bytes/sha256.hpp"
#include "base/context.hpp"
#include "base/parallel.hpp"
#include "formats/registry.hpp"
#include "job/files.hpp"
#include "study/batch/batch_check.hpp"

namespace keyblock {

namespace fs = std::filesystem;
using report::CatalogueFile;

namespace {

SeenFile see(const fs::path& root, const std::string& path, int largest_mebibytes) {
  SeenFile seen{{path, study::FileRole::unreadable, {}, std::nullopt}, {path, {}, {}}, {}};
  const fs::path file = study::place_of(root, path);
  std::error_code error;
  const auto size = fs::file_size(file, error);
  if (!error && size > static_cast<std::uintmax_t>(largest_mebibytes) << 20U) {
    seen.problem = fmt::format("{}: error: expected at most {} MiB, found {} bytes", path, largest_mebibytes, size);
    return seen;
  }
  try {
    const formats::Source source = formats::load(file.string());
    seen.record.sha256 = sha256(source.text);
    seen.file = study::look_at(source, path);
    seen.record.format = seen.file.format;
  } catch (const InputError& input_error) {
    seen.problem = fmt::format("{}: error: {}", path, input_error.sentence());
  } catch (const std::bad_alloc&) {
    seen.problem = fmt::format("{}: error: there is not enough memory for this", path);
  } catch (const std::exception& other_error) {
    seen.problem = fmt::format("{}: error: {}", path, other_error.what());
  }
  return seen;
}

}  // namespace

std::vector<CatalogueFile> FileTree::files_of(const study::BatchJob& job) const {
  std::vector<CatalogueFile> records;
  for (const std::string& path : job.files) records.push_back(files.at(path).record);
  const auto expected = files.find((fs::path(job.files.front()).parent_path() / "expected.csv").generic_string());
  if (job.kind == study::JobKind::whole && expected != files.end()) records.push_back(expected->second.record);
  return records;
}

std::string FileTree::problem_of(const study::BatchJob& job) const {
  for (const std::string& path : job.files)
    if (!files.at(path).problem.empty()) return files.at(path).problem;
  return {};
}

FileTree survey(const fs::path& root, const fs::path& left_out, int largest_mebibytes, int threads) {
  study::FoundFiles found = study::files_below(root, left_out);
  const std::vector<std::string>& paths = found.files;
  std::vector<SeenFile> seen(paths.size());
  for_each_in_parallel(paths.size(), threads, [&](std::size_t i) { seen[i] = see(root, paths[i], largest_mebibytes); });
  FileTree archive;
  archive.passed_over = std::move(found.passed_over);
  if (context().is_stopped()) return archive;
  std::vector<study::BatchFile> files;
  for (SeenFile& file : seen) {
    files.push_back(file.file);
    archive.files.emplace(file.record.path, std::move(file));
  }
  archive.jobs = study::pair_files(files, [&](const study::BatchFile& geometry, const study::BatchFile& analysis) {
    return study::fit_together(root, geometry, analysis);
  });
  return archive;
}

}  // namespace keyblock
