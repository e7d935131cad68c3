// Keeps copies of the input files of runs, so that a comparison can name the inputs that changed.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "serve/child.hpp"
#include "serve/served_folder.hpp"

namespace keyblock::serve {

inline constexpr std::uintmax_t kMostBytesOfCopies = 256U << 20U;

/// Copies of files by their SHA-256, as long as the server runs. The newest ones are kept: at most 1,000, and
/// `most_in_all` bytes.
class InputCopies {
 public:
  /// Refers to both.
  InputCopies(const ServedFolder& folder, const Drafts& drafts, std::uintmax_t most_in_all = kMostBytesOfCopies)
      : folder_(folder), drafts_(drafts), most_in_all_(most_in_all) {}

  /// Keeps the file, or the files of the folder, as they are now. Leaves out files that cannot be read, and those above
  /// 16 MiB.
  void keep(const std::filesystem::path& path) const;

  /// Returns the differences of the input files of two runs, from their records: path, first, second. Files are
  /// compared by their values (JSON) or by their lines. If a file was moved or changed since its run and no copy was
  /// kept, one difference says so.
  nlohmann::ordered_json differences(const nlohmann::ordered_json& first, const nlohmann::ordered_json& second) const;

 private:
  std::filesystem::path copy_of(const std::string& digest) const;
  std::optional<std::string> text_of(const nlohmann::ordered_json& input) const;

  void drop_oldest() const;

  const ServedFolder& folder_;
  const Drafts& drafts_;
  std::uintmax_t most_in_all_;
};

}  // namespace keyblock::serve
