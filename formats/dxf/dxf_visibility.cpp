// Reads the table LAYER; the rule is in the header.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/dxf/dxf_visibility.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <vector>

#include "base/sentences/sentences.hpp"
#include "formats/text/tokens.hpp"

namespace keyblock::formats {
namespace {

constexpr int kFrozenBit = 1;  // bit of group 70
constexpr std::size_t kMostHiddenListed = 10;

/// Folds the case: names of layers do not differ by it.
std::string folded_layer(std::string_view name) {
  std::string text(name);
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return text;
}

int layer_value(const DxfDocument& document, const DxfRecord& record, int code, std::string_view name) {
  const DxfGroup* group = record.find(code);
  return group == nullptr ? 0 : document.integer(*group, name, "LAYER");
}

}  // namespace

DxfVisibility::DxfVisibility(const DxfDocument& document, const LayerTable& shown) {
  std::set<std::string> named;
  for (const auto& [layer, part] : shown.rows) named.insert(folded_layer(layer));
  for (const DxfSection& section : document.sections()) {
    if (section.name != "TABLES") continue;
    for (const DxfRecord& record : section.records) {
      const DxfGroup* name = record.head.value == "LAYER" ? record.find(2) : nullptr;
      if (name == nullptr || named.contains(folded_layer(name->value))) continue;
      if (layer_value(document, record, 62, "the colour") < 0) off_.insert(folded_layer(name->value));
      if ((layer_value(document, record, 70, "the flags") & kFrozenBit) != 0) frozen_.insert(folded_layer(name->value));
    }
  }
}

bool DxfVisibility::is_hidden(std::string_view layer) const {
  if (off_.empty() && frozen_.empty()) return false;
  return off_.contains(folded_layer(layer)) || is_frozen(layer);
}

bool DxfVisibility::is_frozen(std::string_view layer) const {
  return !frozen_.empty() && frozen_.contains(folded_layer(layer));
}

void DxfHidden::add(std::string_view layer, const Place& place) {
  if (count == 0) first = place;
  ++count;
  layers.emplace(layer);
}

void DxfHidden::add_all(const DxfHidden& other) {
  if (count == 0) first = other.first;
  count += other.count;
  layers.insert(other.layers.begin(), other.layers.end());
}

Warnings DxfHidden::warnings() const {
  if (count == 0) return {};
  std::vector<std::string> quoted;
  Facts facts{{{"count", count}}};
  for (const std::string& layer : layers) {
    facts.names.emplace_back("layer", layer);
    if (quoted.size() < kMostHiddenListed) quoted.push_back(in_quotes(layer));
  }
  if (layers.size() > quoted.size()) facts.numbers.emplace_back("more", layers.size() - quoted.size());
  facts.texts = {{"entities", count == 1 ? "1 entity" : fmt::format("{} entities", count)},
                 {"are", count == 1 ? "is" : "are"},
                 {"layers", fmt::format("{}", fmt::join(quoted, ", "))}};
  return {warning_of({"dxf_hidden_layers", std::move(facts)}, first)};
}

}  // namespace keyblock::formats
