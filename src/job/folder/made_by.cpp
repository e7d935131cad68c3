// Reads files in parts, because tables may be large.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "job/folder/made_by.hpp"

#include <fmt/format.h>

#include <fstream>
#include <memory>

#include "base/bytes/build_id.hpp"
#include "base/bytes/sha256.hpp"
#include "base/bytes/source_facts.hpp"
#include "base/error.hpp"

namespace keyblock {
namespace {

constexpr std::size_t kPart = 1 << 16;  // bytes read at a time

}  // namespace

nlohmann::ordered_json made_by_json(const nlohmann::ordered_json& seed) {
  std::error_code error;  // the folder may have been removed
  return {{"commit", source_commit()},
          {"compiler", compiler_words()},
          {"build", build_id()},
          {"command", words_of_command()},
          {"folder", std::filesystem::current_path(error).string()},
          {"seed", seed}};
}

std::string checksum_of(const std::filesystem::path& file) {
  std::ifstream input(file, std::ios::binary);
  Sha256 digest;
  const auto part = std::make_unique_for_overwrite<char[]>(kPart);  // a run reads a dozen small files
  while (input.read(part.get(), kPart) || input.gcount() > 0)
    digest.add({part.get(), static_cast<std::size_t>(input.gcount())});
  if (!input.eof()) throw OutputError(fmt::format("cannot read {} again", file.string()));
  return digest.text();
}

}  // namespace keyblock
