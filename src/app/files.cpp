// Files out, and their checksums.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files.hpp"

#include <fmt/format.h>
#include <openssl/evp.h>

#include <array>
#include <fstream>

#include "app/usage_error.hpp"

namespace keyblock {

namespace fs = std::filesystem;

void require_free(const fs::path& file, Overwrite overwrite) {
  if (overwrite == Overwrite::no && fs::exists(file))
    throw UsageError(fmt::format("{} exists; give another name, or --force to overwrite it", file.string()));
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

std::string sha256(const std::string& bytes) {
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned int size = 0;
  EVP_Digest(bytes.data(), bytes.size(), digest.data(), &size, EVP_sha256(), nullptr);
  std::string text;
  for (unsigned int i = 0; i < size; ++i) text += fmt::format("{:02x}", digest[i]);
  return text;
}

}  // namespace keyblock
