// Saves and restores member by member, then compares files, program and settings with those of the checkpoint.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "job/saved_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>

#include "base/bytes/build_id.hpp"
#include "base/error.hpp"
#include "result/describe.hpp"
#include "run/checkpoint.hpp"

namespace keyblock {

namespace fs = std::filesystem;

namespace {

void describe(Archive& archive, const char* name, std::vector<std::string>& texts) {
  archive.list(name, texts, [&](std::string& text) { archive.value("text", text); });
}

}  // namespace

void describe(Archive& archive, RunRequest& request) {
  archive.value("program", request.program);
  if (archive.is_restoring() && request.program != this_program())  // another build may lay out the rest differently
    archive.refuse("program", fmt::format("expected the build of keyblock that began the run, {}, found another, {}",
                                          request.program, this_program()));
  archive.value("folder", request.folder);
  archive.value("working_folder", request.working_folder);
  describe(archive, "files", request.files);
  archive.value("profile", request.profile);
  describe(archive, "sets", request.sets);
  archive.value("record_every", request.record_every);
  archive.value("has_trace", request.has_trace);
  describe(archive, "read", request.read);
  describe(archive, "digests", request.digests);
  describe(archive, "settings", request.settings);
  describe(archive, "histories", request.histories);
  archive.value("contacts", request.contacts);
  archive.value("field", request.field);
  archive.value("unit", request.unit);
  archive.value("join", request.join);
  archive.value("frames", request.frames);
  archive.value("has_pictures", request.has_pictures);
  archive.value("has_page", request.has_page);
  archive.value("checkpoint_every", request.checkpoint_every);
  describe(archive, "values", request.values);
}

std::string this_program() {
  return fmt::format("{}, build {}", KEYBLOCK_VERSION, build_id());
}

void describe_told(Archive& archive, RunFolder& folder, History& history, RunAccount& account) {
  archive.group("records", [&] {
    archive.list("history", history.rows, [&](HistoryRow& row) { describe(archive, row); });
    account.describe(archive);
  });
  archive.group("folder", [&] { folder.describe(archive); });
}

std::string bytes_before_steps(RunRequest& request) {
  Archive archive;
  archive.group("request", [&] { describe(archive, request); });
  return checkpoint_bytes(archive);
}

bool holds_steps(const Archive& saved) {
  return std::ranges::any_of(saved.root().children, [](const auto& child) { return child->name == "stepper"; });
}

std::string saved_bytes(RunRequest& request, RunFolder& folder, History& history, RunAccount& account,
                        Stepper& stepper) {
  Archive archive;
  archive.group("request", [&] { describe(archive, request); });
  describe_told(archive, folder, history, account);
  archive.group("stepper", [&] { stepper.save(archive); });
  return checkpoint_bytes(archive);
}

Archive read_checkpoint(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream && fs::exists(file.parent_path() / "run.json"))
    throw UsageError(
        fmt::format("nothing to resume: the run in {} has finished (run.json)", file.parent_path().string()));
  if (!stream)
    throw UsageError(fmt::format("nothing to resume: expected {}, found none; begin a new run there", file.string()));
  return archive_of_checkpoint(file.string(), {std::istreambuf_iterator<char>(stream), {}});
}

void require_own(const fs::path& checkpoint, const RunRequest& saved) {
  const fs::path folder = checkpoint.parent_path();
  std::error_code error;
  const bool is_moved =
      !fs::exists(checkpoint_in(saved.folder), error) && !fs::exists(fs::path(saved.folder) / "run.json", error);
  if (fs::equivalent(folder, saved.folder, error) || is_moved) return;
  throw InputError(
      {checkpoint.string(), 0, 0},
      fmt::format(
          "expected the checkpoint of the run in {}, found that of a run in {}, which still exists; resume that one",
          folder.string(), saved.folder));
}

void require_same(const fs::path& checkpoint, const RunRequest& saved, const RunRequest& now) {
  const auto refuse = [&](const std::string& sentence) { throw InputError({checkpoint.string(), 0, 0}, sentence); };
  if (saved.read != now.read || saved.digests.size() != saved.read.size())
    refuse("expected the files that the run began with, found others");
  for (std::size_t i = 0; i < saved.read.size(); ++i)
    if (saved.digests[i] != now.digests[i])
      throw InputError({saved.read[i], 0, 0},
                       fmt::format("expected the file that the run began with, SHA-256 {}, found "
                                   "another, SHA-256 {}",
                                   saved.digests[i], now.digests[i]));
  const auto [was, is] = std::ranges::mismatch(saved.settings, now.settings);
  if (was != saved.settings.end() || is != now.settings.end())
    refuse(fmt::format("expected the setting {}, found {}", was == saved.settings.end() ? "list's end" : *was,
                       is == now.settings.end() ? "the list's end" : *is));
}

}  // namespace keyblock
