// Finds, reads and writes files below one folder, and none outside of it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>

namespace keyblock::serve {

/// A path that is not served: outside of the folder, hidden, or of a wrong kind.
struct NotServed : std::runtime_error {
  using std::runtime_error::runtime_error;
};

class ServedFolder {
 public:
  /// Throws std::filesystem::filesystem_error if the folder does not exist.
  explicit ServedFolder(const std::filesystem::path& folder);

  const std::filesystem::path& root() const { return root_; }

  /// Returns the whole path of a relative one; links are followed. Throws NotServed if it is absolute, lies outside of
  /// the folder, or has a part that begins with a dot. The file need not exist, its folder must.
  std::filesystem::path whole(const std::string& path) const;

  /// Returns the path from the folder on.
  std::string name(const std::filesystem::path& whole) const;

  /// Returns the files of cases and drawings, and the result folders, that lie at most `kDeepest` folders below; at
  /// most `kMostEntries` of each. Counts those left out because their names are not UTF-8.
  nlohmann::ordered_json list() const;

 private:
  std::filesystem::path root_;
};

inline constexpr int kDeepest = 4;
inline constexpr std::size_t kMostEntries = 500;

}  // namespace keyblock::serve
