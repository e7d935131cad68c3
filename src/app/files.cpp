// Files out.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files.hpp"

#include <fmt/format.h>

#include <fstream>

#include "app/usage_error.hpp"

namespace keyblock {

namespace fs = std::filesystem;

void require_free(const fs::path& file, Overwrite overwrite) {
  if (overwrite == Overwrite::no && fs::exists(file))
    throw UsageError(fmt::format("{} exists; give another name, or --force to overwrite it", file.string()));
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

void write_file(const fs::path& file, const std::string& text) {
  std::error_code ignored;
  if (file.has_parent_path()) fs::create_directories(file.parent_path(), ignored);
  const fs::path draft = file.string() + ".part";
  std::ofstream stream(draft, std::ios::binary);
  stream.write(text.data(), static_cast<std::streamsize>(text.size()));
  stream.close();
  std::error_code error;
  if (stream) fs::rename(draft, file, error);
  if (!stream || error) {
    fs::remove(draft, ignored);
    throw OutputError(fmt::format("cannot write {}", file.string()));
  }
}

}  // namespace keyblock
