// Reads files in parts, because tables may be large.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "job/folder/made_by.hpp"

#include <fmt/format.h>

#include <fstream>

#include "base/bytes/build_id.hpp"
#include "base/bytes/sha256.hpp"
#include "base/bytes/source_facts.hpp"
#include "base/error.hpp"

namespace keyblock {

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
  std::string part(1 << 20, '\0');
  while (input.read(part.data(), static_cast<std::streamsize>(part.size())) || input.gcount() > 0)
    digest.add(std::string_view(part).substr(0, static_cast<std::size_t>(input.gcount())));
  if (!input.eof()) throw OutputError(fmt::format("cannot read {} again", file.string()));
  return digest.text();
}

}  // namespace keyblock
