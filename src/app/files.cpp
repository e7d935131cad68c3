// Files out.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <fstream>

#include "app/usage_error.hpp"

namespace keyblock {

namespace fs = std::filesystem;

void require_free(const fs::path& file, Overwrite overwrite) {
  if (overwrite == Overwrite::no && fs::exists(file))
    throw UsageError(fmt::format("{} exists; give another name, or --force to overwrite it", file.string()));
}

void require_folder_of(const fs::path& file) {
  if (const fs::path folder = file.parent_path(); !folder.empty() && !fs::is_directory(folder))
    throw UsageError(fmt::format("there is no folder {} for {}", folder.string(), file.filename().string()));
}

void require_not_input(const fs::path& output, const fs::path& input) {
  std::error_code error;
  if (!fs::exists(output, error)) return;
  if (!fs::is_regular_file(output, error)) throw UsageError(fmt::format("{} is no regular file", output.string()));
  if (fs::equivalent(output, input, error))
    throw UsageError(fmt::format("{} is an input; give another name", output.string()));
}

void require_not_below(const fs::path& input, const fs::path& folder) {
  std::error_code error;
  const fs::path parent = input.has_parent_path() ? input.parent_path() : fs::path(".");
  if (fs::equivalent(parent, folder, error))
    throw UsageError(fmt::format("{} lies in the folder for the results; give another folder", input.string()));
}

namespace {

fs::path draft_of(const fs::path& file) {
  return file.string() + ".part";
}

bool write_draft(const fs::path& file, const std::string& text) {
  std::ofstream stream(draft_of(file), std::ios::binary);
  stream.write(text.data(), static_cast<std::streamsize>(text.size()));
  stream.close();
  return !stream.fail();
}

[[noreturn]] void give_up(const fs::path& file) {
  std::error_code ignored;
  fs::remove(draft_of(file), ignored);
  throw OutputError(fmt::format("cannot write {}", file.string()));
}

}  // namespace

void write_file(const fs::path& file, const std::string& text) {
  std::error_code error;
  if (file.has_parent_path()) fs::create_directories(file.parent_path(), error);
  if (!write_draft(file, text)) give_up(file);
  fs::rename(draft_of(file), file, error);
  if (error) give_up(file);
}

void flush_to_disk(const fs::path& file_or_folder) {
  const int descriptor = open(file_or_folder.c_str(), O_RDONLY | O_CLOEXEC);
  const bool flushed = descriptor >= 0 && fsync(descriptor) == 0;
  if (descriptor >= 0) close(descriptor);
  if (!flushed) throw OutputError(fmt::format("cannot flush {} to the disk", file_or_folder.string()));
}

void write_durably(const fs::path& file, const std::string& bytes) {
  if (!write_draft(file, bytes)) give_up(file);
  flush_to_disk(draft_of(file));
  std::error_code error;
  fs::rename(draft_of(file), file, error);
  if (error) give_up(file);
  flush_to_disk(file.parent_path());
}

}  // namespace keyblock
