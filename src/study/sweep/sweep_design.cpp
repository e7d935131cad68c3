// Random numbers come from SplitMix64 (Steele et al. 2014), so that a seed gives the same rows with every library.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/sweep/sweep_design.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <stdexcept>

#include "base/bytes/sha256.hpp"
#include "base/error.hpp"

namespace keyblock::study {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kDigitsOfJob = 16;

class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  std::uint64_t next() {
    state_ += 0x9e3779b97f4a7c15U;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
    return z ^ (z >> 31U);
  }
  /// Returns a number above 0 and below 1.
  double fraction() { return (static_cast<double>(next() >> 11U) + 0.5) * 0x1p-53; }
  /// Returns a whole number below `end`, which is small beside 2^64.
  std::size_t below(std::size_t end) { return static_cast<std::size_t>(next() % end); }

 private:
  std::uint64_t state_;
};

Json value_at(const VariedKey& key, double p) {
  if (!key.distribution) {
    const auto index = static_cast<std::size_t>(p * static_cast<double>(key.values.size()));
    return key.values[std::min(index, key.values.size() - 1)];
  }
  const double number = key.distribution->quantile(p);
  const std::string& unit = key.distribution->unit;
  return unit.empty() ? Json(number) : Json(fmt::format("{} {}", number, unit));
}

std::vector<SweepRow> random_rows(const std::vector<VariedKey>& keys, const DesignAsked& asked) {
  Random random(asked.seed);
  std::vector<SweepRow> rows(asked.count, Json::object());
  for (const VariedKey& key : keys) {
    std::vector<std::size_t> parts(asked.count);
    for (std::size_t i = 0; i < parts.size(); ++i) parts[i] = i;
    for (std::size_t i = parts.size(); i > 1; --i) std::swap(parts[i - 1], parts[random.below(i)]);
    for (std::size_t i = 0; i < parts.size(); ++i)
      rows[i][key.key] =
          value_at(key, (static_cast<double>(parts[i]) + random.fraction()) / static_cast<double>(asked.count));
  }
  return rows;
}

std::vector<SweepRow> grid_rows(const std::vector<VariedKey>& keys) {
  std::vector<SweepRow> rows{Json::object()};
  for (const VariedKey& key : keys) {
    if (rows.size() * key.values.size() > kMostRows)
      throw std::invalid_argument(fmt::format("expected at most {} runs, found more", kMostRows));
    std::vector<SweepRow> longer;
    for (const SweepRow& row : rows)
      for (const Json& value : key.values) {
        longer.push_back(row);
        longer.back()[key.key] = value;
      }
    rows = std::move(longer);
  }
  return rows;
}

std::vector<SweepRow> zipped_rows(const std::vector<VariedKey>& keys) {
  std::vector<SweepRow> rows(keys.front().values.size(), Json::object());
  for (const VariedKey& key : keys) {
    if (key.values.size() != rows.size())
      throw std::invalid_argument(fmt::format("expected {} values of {} as of {}, found {}", rows.size(), key.key,
                                              keys.front().key, key.values.size()));
    for (std::size_t i = 0; i < rows.size(); ++i) rows[i][key.key] = key.values[i];
  }
  return rows;
}

}  // namespace

std::vector<SweepRow> sweep_rows(const std::vector<VariedKey>& keys, const DesignAsked& asked) {
  std::set<std::string> known;
  for (const VariedKey& key : keys) {
    if (!known.insert(key.key).second)
      throw std::invalid_argument(fmt::format("expected each key once, found {} twice", key.key));
    if (key.distribution && asked.design != Design::random)
      throw std::invalid_argument(
          fmt::format("expected values of {}, found a distribution, which belongs to a random design", key.key));
  }
  if (keys.empty()) throw std::invalid_argument("expected keys over which the sweep runs, found none");
  switch (asked.design) {
    case Design::grid:
      return grid_rows(keys);
    case Design::zipped:
      return zipped_rows(keys);
    case Design::random:
      if (asked.count < 1 || asked.count > kMostRows)
        throw std::invalid_argument(fmt::format("expected 1 to {} runs, found {}", kMostRows, asked.count));
      return random_rows(keys, asked);
  }
  return {};
}

std::vector<SweepRow> rows_of_file(const std::string& name, const std::string& text) {
  const Json json = Json::parse(text, nullptr, false, true);
  const auto is_row = [](const Json& row) { return row.is_object() && !row.empty(); };
  if (!json.is_array() || json.empty() || !std::ranges::all_of(json, is_row))
    throw InputError({name}, "expected a JSON list of objects, one per run, found another content");
  std::vector<SweepRow> rows;
  for (const Json& given : json) {
    SweepRow row = Json::object();
    for (const auto& [key, value] : json.front().items()) {
      if (!given.contains(key) || given.size() != json.front().size())
        throw InputError({name},
                         fmt::format("expected the same keys in all runs, found others in run {}", rows.size() + 1));
      row[key] = given.at(key);
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

std::string job_name(const SweepRow& row) {
  SweepRow plain = row;
  for (auto& [key, value] : plain.items())
    if (value.is_number_float()) value = number_json(value);
  return sha256(plain.dump(-1, ' ', false, Json::error_handler_t::replace)).substr(0, kDigitsOfJob);
}

bool is_job_name(std::string_view name) {
  return name.size() == kDigitsOfJob && name.find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

}  // namespace keyblock::study
