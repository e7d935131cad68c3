// Parses the words of parts, and the table line by line.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/dxf/dxf_layer_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <string>

#include "base/nearest.hpp"
#include "formats/text/tokens.hpp"

namespace keyblock::formats {
namespace {

constexpr std::string_view kHeader = "layer,part";
constexpr std::string_view kOthers = "*";
constexpr std::size_t kMostRows = 4096;  // more layers than any drawing has

struct PartWord {
  std::string_view word;
  DxfRole role;
  bool takes_number;
};

constexpr std::array<PartWord, 11> kParts{{{"boundary", DxfRole::boundary, true},
                                           {"outline", DxfRole::boundary, true},
                                           {"joint", DxfRole::joint, true},
                                           {"material", DxfRole::material, true},
                                           {"bolt", DxfRole::bolt, true},
                                           {"block", DxfRole::block, true},
                                           {"fixed", DxfRole::fixed, false},
                                           {"load", DxfRole::load, false},
                                           {"measured", DxfRole::measured, false},
                                           {"hole", DxfRole::hole, false},
                                           {"ignored", DxfRole::ignored, false}}};
constexpr std::string_view kAllParts =
    "boundary, joint N, material N, bolt N, block N, fixed, load, measured, hole or ignored";

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

std::string lower(std::string_view text) {
  std::string result(text);
  std::ranges::transform(result, result.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return result;
}

std::optional<int> number_of(std::string_view digits) {
  int number = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  if (error != std::errc{} || end != digits.data() + digits.size() || number < 1) return std::nullopt;
  return number;
}

/// Returns the part of the words; nothing if they name none.
std::optional<DxfLayer> part_of(std::string_view words) {
  const std::string text = lower(trimmed(words));
  const std::size_t end = std::min(text.find_first_of(" \t"), text.size());
  const auto part = std::ranges::find(kParts, std::string_view(text).substr(0, end), &PartWord::word);
  if (part == kParts.end()) return std::nullopt;
  const std::string_view digits = trimmed(std::string_view(text).substr(end));
  if (digits.empty()) return DxfLayer{part->role, 0, false};
  const std::optional<int> number = number_of(digits);
  if (!part->takes_number || !number) return std::nullopt;
  return DxfLayer{part->role, *number - 1, false};
}

std::string hint_for(std::string_view words) {
  std::vector<std::string> known;
  for (const PartWord& part : kParts) known.emplace_back(part.word);
  const std::string word = lower(trimmed(words));
  const std::string first = word.substr(0, word.find_first_of(" \t"));
  if (std::ranges::find(known, first) != known.end()) return {};
  return nearest_words(first, known);
}

Place place_of(const LayerTable& table, std::size_t row, const Place& file) {
  return row < table.places.size() ? table.places[row] : file;
}

std::string_view first_line(std::string_view text) {
  return trimmed(text.substr(0, text.find('\n')));
}

Recognition recognise_table(const Source& source) {
  std::string head = lower(first_line(without_bom(source.text)));
  std::erase(head, ' ');
  if (head != kHeader) return {};
  return {Recognition::Fit::exact, "its first line is layer,part"};
}

/// Returns a name before the last comma, with or without quotes.
std::string unquoted(std::string_view text) {
  text = trimmed(text);
  if (text.size() < 2 || text.front() != '"' || text.back() != '"') return std::string(text);
  std::string name;
  for (std::size_t i = 1; i + 1 < text.size(); ++i) {
    name += text[i];
    if (text[i] == '"' && text[i + 1] == '"') ++i;
  }
  return name;
}

Reading read_table(const Source& source, const ReadHint&) {
  Reading reading;
  LayerTable& table = reading.content.layers;
  std::string_view rest = without_bom(source.text);
  for (int line = 1; !rest.empty(); ++line) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    const std::string_view row = trimmed(rest.substr(0, end));
    rest.remove_prefix(std::min(end + 1, rest.size()));
    if (line == 1 || row.empty() || row.front() == '#') continue;
    const Place place{source.name, line, 1};
    const std::size_t comma = row.rfind(',');
    if (comma == std::string_view::npos)
      throw InputError(place, fmt::format("expected a row \"layer,part\", found {}", in_quotes(row)));
    if (table.rows.size() == kMostRows)
      throw InputError(place, fmt::format("expected at most {} layers, found more", kMostRows));
    table.rows.emplace_back(unquoted(row.substr(0, comma)), std::string(trimmed(row.substr(comma + 1))));
    table.places.push_back(place);
  }
  if (table.rows.empty())
    throw InputError({source.name}, "expected rows \"layer,part\" behind the first line, found none");
  check_layers(table, {source.name});
  return reading;
}

}  // namespace

void check_layers(const LayerTable& table, const Place& file) {
  std::vector<std::string> seen;
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const auto& [layer, part] = table.rows[i];
    if (layer.empty()) throw InputError(place_of(table, i, file), "expected the name of a layer, found none");
    if (!part_of(part))
      throw InputError(place_of(table, i, file),
                       fmt::format("expected a part for layer {}: {}, found {}{}", in_quotes(layer), kAllParts,
                                   in_quotes(part), hint_for(part)));
    seen.push_back(lower(layer));
  }
  std::vector<std::string> sorted = seen;
  std::ranges::sort(sorted);
  const auto twice = std::ranges::adjacent_find(sorted);
  if (twice == sorted.end()) return;
  const std::size_t first = static_cast<std::size_t>(std::ranges::find(seen, *twice) - seen.begin());
  const auto second = std::find(seen.begin() + static_cast<std::ptrdiff_t>(first) + 1, seen.end(), *twice);
  const auto row = static_cast<std::size_t>(second - seen.begin());
  throw InputError(place_of(table, row, file),
                   fmt::format("expected each layer once, found {} again", in_quotes(table.rows[row].first)));
}

LayerParts::LayerParts(const LayerTable& table) : table_(table), used_(table.rows.size(), false) {
  for (std::size_t i = 0; i < table.rows.size() && !other_; ++i)
    if (table.rows[i].first == kOthers) {
      other_ = part_of(table.rows[i].second);
      used_[i] = true;
    }
}

std::optional<DxfLayer> LayerParts::named(std::string_view layer) {
  const std::string wanted = lower(layer);
  std::optional<DxfLayer> found;
  for (std::size_t i = 0; i < table_.rows.size(); ++i) {
    if (lower(table_.rows[i].first) != wanted) continue;
    used_[i] = true;
    if (!found) found = part_of(table_.rows[i].second);
  }
  return found;
}

std::vector<std::size_t> LayerParts::unused() const {
  std::vector<std::size_t> rows;
  for (std::size_t i = 0; i < used_.size(); ++i)
    if (!used_[i]) rows.push_back(i);
  return rows;
}

constinit const Format kDxfLayers{
    .name = "dxf-layers",
    .title = "layers of a DXF drawing (table)",
    .recognise = recognise_table,
    .read = read_table,
    .evidence = "documented here: formats/dxf/dxf_layer_table.hpp",
    .sample = "layer,part\nOutline,boundary\nBedding,joint 2\nSupport,fixed\nTitle block,ignored\n*,joint 1\n"};

}  // namespace keyblock::formats
