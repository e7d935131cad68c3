// Puts values into the texts of the table; see sentences.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/sentences/sentences.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <stdexcept>
#include <utility>

#include "base/counted.hpp"
#include "base/listed.hpp"
#include "base/words/plain_number.hpp"

namespace keyblock {
namespace {

std::optional<std::string_view> text_of(std::string_view form) {
  for (const std::span<const Sentence> part : {sentences_ahead(), sentences_of_cases(), sentences_of_cuts(),
                                               sentences_of_readers(), sentences_of_runs(), sentences_of_steps()})
    if (const auto row = std::ranges::lower_bound(part, form, {}, &Sentence::form);
        row != part.end() && row->form == form)
      return row->text;
  return std::nullopt;
}

std::optional<double> value_of(const Facts& facts, std::string_view name) {
  for (const auto& [known, value] : facts.numbers)
    if (known == name) return value;
  if (!facts.points.empty() && name == "x") return facts.points.front()[0];
  if (!facts.points.empty() && name == "y") return facts.points.front()[1];
  if (facts.points.size() > 1 && name == "x2") return facts.points[1][0];
  if (facts.points.size() > 1 && name == "y2") return facts.points[1][1];
  if (!facts.elements.empty() && name == "element") return facts.elements.front();
  if (facts.elements.size() > 1 && name == "other") return facts.elements[1];
  return std::nullopt;
}

std::string formatted(double value, std::string_view format) {
  if (format.empty()) return plain(value);
  if (format.front() == 'p') return plain(value, format.back() - '0');
  if (format.front() == '#') return counted(static_cast<std::size_t>(value), format.substr(1));
  if (format == "?") return {};
  if (format == "r") return fmt::format("{}", value);
  return fmt::format(fmt::runtime(fmt::format("{{:{}}}", format)), value);
}

/// Returns the value behind `name` or `name:format`; nothing if there is none.
std::optional<std::string> filled(const Facts& facts, std::string_view field) {
  const std::size_t colon = field.find(':');
  const std::string_view name = field.substr(0, colon);
  for (const auto* texts : {&facts.texts, &facts.names})
    for (const auto& [known, text] : *texts)
      if (known == name) return text;
  if (name == "elements") return listed(facts.elements);
  const std::optional<double> value = value_of(facts, name);
  if (!value) return std::nullopt;
  return formatted(*value, colon == std::string_view::npos ? std::string_view() : field.substr(colon + 1));
}

/// Returns the text with its values; nothing if one is not there.
std::optional<std::string> filled_text(const Facts& facts, std::string_view text) {
  std::string sentence;
  while (!text.empty()) {
    const std::size_t mark = std::min(text.find_first_of("{["), text.size());
    sentence += text.substr(0, mark);
    text.remove_prefix(mark);
    if (text.empty()) break;
    const std::size_t end = std::min(text.find(text.front() == '{' ? '}' : ']'), text.size() - 1);
    const std::string_view inner = text.substr(1, end - 1);
    if (text.front() == '[') {
      sentence += filled_text(facts, inner).value_or("");
    } else {
      const std::optional<std::string> value = filled(facts, inner);
      if (!value) return std::nullopt;
      sentence += *value;
    }
    text.remove_prefix(end + 1);
  }
  return sentence;
}

}  // namespace

std::string sentence_of(const Finding& finding) {
  const std::optional<std::string_view> text = text_of(finding.form);
  if (!text) throw std::logic_error("no sentence of the form " + finding.form);
  const std::optional<std::string> sentence = filled_text(finding.facts, *text);
  if (!sentence) throw std::logic_error("a value is missing in the sentence of the form " + finding.form);
  return *sentence;
}

std::string framed(std::string_view frame, const Facts& values, const Finding& why) {
  Facts facts = values;
  facts.texts.emplace_back("why", sentence_of(why));
  return sentence_of({std::string(frame), std::move(facts)});
}

Warning warning_of(Finding finding, const Place& place) {
  std::string sentence = sentence_of(finding);
  return {finding.code(), place, std::move(sentence), std::move(finding.facts)};
}

}  // namespace keyblock
