// Hashes names by SHA-256, so that every machine finds the same shards.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/batch/shard.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "base/bytes/sha256.hpp"
#include "base/error.hpp"

namespace keyblock {

bool Shard::has(const std::string& job) const {
  if (is_whole()) return true;
  constexpr std::size_t kDigits = 12;
  const std::string digest = sha256(job).substr(0, kDigits);
  unsigned long long number = 0;
  std::from_chars(digest.data(), digest.data() + digest.size(), number, 16);
  return number % static_cast<unsigned long long>(n) + 1 == static_cast<unsigned long long>(k);
}

std::string Shard::journal_name() const {
  return is_whole() ? "journal.jsonl" : fmt::format("journal-{}-of-{}.jsonl", k, n);
}

Shard shard_of(const std::string& text) {
  Shard shard{0, 0};
  const char* const end = text.data() + text.size();
  const auto first = std::from_chars(text.data(), end, shard.k);
  const bool has_slash = first.ec == std::errc() && first.ptr != end && *first.ptr == '/';
  const auto second = has_slash ? std::from_chars(first.ptr + 1, end, shard.n) : first;
  if (!has_slash || second.ec != std::errc() || second.ptr != end || shard.k < 1 || shard.k > shard.n)
    throw UsageError(fmt::format("--shard: expected K/N with K from 1 to N, found \"{}\"", text));
  return shard;
}

std::vector<std::filesystem::path> journals_in(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> journals;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
    const std::string name = entry.path().filename().string();
    if (name == "journal.jsonl" || (name.starts_with("journal-") && name.ends_with(".jsonl")))
      journals.push_back(entry.path());
  }
  std::ranges::sort(journals);
  return journals;
}

}  // namespace keyblock
