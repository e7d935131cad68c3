// Divides jobs into shards by their names: each shard can run on another machine, without a coordinator.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace keyblock {

/// Shard k of n; 1 of 1 has all jobs.
struct Shard {
  int k = 1;
  int n = 1;

  bool is_whole() const { return n == 1; }
  /// Returns true if the job belongs to the shard, by a hash of its name.
  bool has(const std::string& job) const;
  /// Returns the name of its journal: journal.jsonl, or journal-3-of-8.jsonl.
  std::string journal_name() const;
};

/// Parses "3/8". Throws UsageError.
Shard shard_of(const std::string& text);

/// Returns the journals in a folder of results, sorted by name.
std::vector<std::filesystem::path> journals_in(const std::filesystem::path& folder);

}  // namespace keyblock
