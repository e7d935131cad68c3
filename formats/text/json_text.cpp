// Receives the events of nlohmann's parser and counts the characters that it reads.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/text/json_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>

#include "base/printable.hpp"

namespace keyblock::formats {
namespace {

constexpr std::size_t kDeepest = 12;  // a case file needs 8
constexpr std::size_t kLongest = std::numeric_limits<std::uint32_t>::max();
constexpr std::size_t kQuoted = 40;      // characters of the found text in a message
constexpr std::size_t kLeastOfNode = 2;  // least characters of a value and its separator
constexpr std::string_view kBetween = " \t\r\n,:";

/// Line ends and tabs. Within a string they are an error; between values any number of them counts as one.
bool is_control_space(char c) {
  return c == '\n' || c == '\r' || c == '\t';
}

/// Characters of the text for the parser, counted as it reads them. It gets one line end per run of them: its messages
/// repeat the characters before, with eight per line end.
struct CountedCharacters {
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  const char* at = nullptr;
  const char* last = nullptr;
  const char** reached = nullptr;

  reference operator*() const { return *at; }
  CountedCharacters& operator++() {
    const bool skips = is_control_space(*at++);
    while (skips && at != last && is_control_space(*at)) ++at;
    *reached = at;
    return *this;
  }
  CountedCharacters operator++(int) {
    const CountedCharacters before = *this;
    ++*this;
    return before;
  }
  bool operator==(const CountedCharacters& other) const { return at == other.at; }
  bool operator!=(const CountedCharacters& other) const { return at != other.at; }
};

bool is_of_number(char c) {
  return (c >= '0' && c <= '9') || c == '+' || c == '-' || c == '.' || c == 'e' || c == 'E';
}

// Returns the place after a string or comment that begins at `at`; `at` if neither does.
std::size_t behind_opaque(std::string_view text, std::size_t at) {
  if (text[at] == '"') {
    for (++at; at < text.size() && text[at] != '"'; ++at)
      if (text[at] == '\\') ++at;
    return std::min(at + 1, text.size());
  }
  if (text.substr(at, 2) == "//") return std::min(text.find('\n', at), text.size());
  if (text.substr(at, 2) == "/*") {
    const std::size_t end = text.find("*/", at + 2);
    return end == std::string_view::npos ? text.size() : end + 2;
  }
  return at;
}

// Replaces commas after the last value of a list by spaces, so that all places stay; returns nothing if there are none.
std::optional<std::string> without_last_commas(std::string_view text) {
  std::optional<std::string> changed;
  constexpr std::size_t kNone = std::string_view::npos;
  std::size_t comma = kNone;  // the last token, if it is a comma after a value
  bool follows_value = false;
  for (std::size_t at = 0; at < text.size();) {
    if (const std::size_t end = behind_opaque(text, at); end != at) {
      if (text[at] == '"') {
        comma = kNone;
        follows_value = true;
      }
      at = end;
      continue;
    }
    const char c = text[at++];
    if (c == ' ' || is_control_space(c)) continue;
    const bool closes = c == ']' || c == '}';
    if (closes && comma != kNone) {
      if (!changed) changed = text;
      (*changed)[comma] = ' ';
    }
    comma = c == ',' && follows_value ? at - 1 : kNone;
    follows_value = closes || (c != ',' && c != '[' && c != '{' && c != ':');
  }
  return changed;
}

std::string clipped(std::string_view text) {
  return printable(text.substr(0, kQuoted)) + (text.size() > kQuoted ? "…" : "");
}

}  // namespace

/// Listener of the parser: appends one node per value.
class JsonReader {
 public:
  JsonReader(JsonText& into, std::string_view text) : into_(into), text_(text), reached_(text.data()) {
    const auto parts = std::ranges::count_if(text, [](char c) { return c == ',' || c == '[' || c == '{' || c == ':'; });
    last_ = text.size() - without_bom(text).size();
    into_.nodes_.reserve(std::min(static_cast<std::size_t>(parts) + 1, text.size() / kLeastOfNode + 1));
  }

  bool read() {
    const char* const end = text_.data() + text_.size();
    const CountedCharacters first{text_.data(), end, &reached_};
    const CountedCharacters last{end, end, &reached_};
    return nlohmann::json::sax_parse(first, last, this, nlohmann::json::input_format_t::json, true, true);
  }

  bool null() { return add(JsonKind::null, 0, 4); }
  bool boolean(bool value) { return add(value ? JsonKind::yes : JsonKind::no, 0, value ? 4 : 5); }
  bool number_integer(std::int64_t value) { return add_number(static_cast<double>(value)); }
  bool number_unsigned(std::uint64_t value) { return add_number(static_cast<double>(value)); }
  bool number_float(double value, const std::string&) { return add_number(value); }
  bool string(std::string& value) { return add_string(value); }
  bool key(std::string& value) { return add_string(value); }
  bool binary(nlohmann::json::binary_t&) { return false; }
  bool start_object(std::size_t) { return open(JsonKind::object); }
  bool start_array(std::size_t) { return open(JsonKind::array); }
  bool end_object() { return close(); }
  bool end_array() { return close(); }

  bool parse_error(std::size_t, const std::string& last, const nlohmann::json::exception& error) {
    const std::size_t at = std::min(next_start(), text_.size());
    // 406: a number outside the range of a double.
    const bool is_number = error.id == 406;
    const std::string found = at == text_.size() ? "the end of the file" : "\"" + clipped(text_.substr(at)) + "\"";
    const bool is_hash = last.ends_with('#');
    const bool is_after_comma = is_behind_comma(at);
    throw InputError(
        into_.map_.place(at),
        fmt::format(
            "expected {}, found {}{}", is_number ? "a number of double precision" : "sound JSON",
            is_number || last.empty() || at == text_.size() ? found : "\"" + clipped(without_line_ends(last)) + "\"",
            is_hash          ? "; comments begin with // in JSON, with # in YAML"
            : is_after_comma ? "; numbers have a decimal point, a comma parts values"
                             : ""));
  }

 private:
  // Finds a digit, a comma and another digit before the place, as in 0,001.
  bool is_behind_comma(std::size_t at) const {
    const auto is_digit = [&](std::size_t i) { return i < text_.size() && text_[i] >= '0' && text_[i] <= '9'; };
    while (at > 0 && is_digit(at - 1)) --at;
    return is_digit(at) && at > 1 && text_[at - 1] == ',' && is_digit(at - 2);
  }

  // The parser shows control characters as <U+000A>, but line ends within a value unchanged.
  static std::string without_line_ends(std::string text) {
    std::erase_if(text, [](unsigned char c) { return c < ' '; });
    return text;
  }

  // Returns the start of the next value, after separators and comments.
  std::size_t next_start() const {
    std::size_t at = last_;
    for (;;) {
      at = text_.find_first_not_of(kBetween, at);
      if (at == std::string_view::npos) return text_.size();
      const bool closes = text_[at] == ']' || text_[at] == '}';
      if (closes && at < taken()) {
        ++at;
      } else if (text_.substr(at, 2) == "//") {
        at = std::min(text_.find('\n', at), text_.size());
      } else if (text_.substr(at, 2) == "/*") {
        const std::size_t end = text_.find("*/", at + 2);
        at = end == std::string_view::npos ? text_.size() : end + 2;
      } else {
        return at;
      }
    }
  }
  std::size_t taken() const { return static_cast<std::size_t>(reached_ - text_.data()); }

  bool add(JsonKind kind, double number, std::size_t length) {
    const std::size_t start = next_start();
    JsonText::Node node{};
    node.offset = start;
    node.kind = static_cast<std::uint8_t>(kind);
    node.number = number;
    into_.nodes_.push_back(node);
    last_ = start + length;
    return true;
  }
  bool add_number(double value) {
    const std::size_t start = next_start();
    std::size_t end = start;
    while (end < text_.size() && is_of_number(text_[end])) ++end;
    return add(JsonKind::number, value, end - start);
  }
  bool add_string(std::string& value) {
    add(JsonKind::string, 0, 0);
    last_ = taken();
    into_.nodes_.back().string = {static_cast<std::uint32_t>(value.size()),
                                  static_cast<std::uint32_t>(into_.strings_.size())};
    into_.strings_ += value;
    return true;
  }
  bool open(JsonKind kind) {
    open_.push_back(into_.nodes_.size());
    add(kind, 0, 1);
    if (open_.size() > kDeepest)
      throw InputError(into_.map_.place(last_ - 1),
                       fmt::format("expected at most {} levels of brackets, found another", kDeepest));
    return true;
  }
  bool close() {
    into_.nodes_[open_.back()].end = into_.nodes_.size();
    open_.pop_back();
    last_ = taken();
    return true;
  }

  JsonText& into_;
  std::string_view text_;
  const char* reached_;
  std::size_t last_ = 0;  ///< end of the last value
  std::vector<std::size_t> open_;
};

JsonText::JsonText(const Source& source) : map_(source.name, source.text), size_(source.text.size()) {
  if (source.text.size() > kLongest)
    throw InputError({source.name},
                     fmt::format("expected at most {} bytes of JSON, found {}", kLongest, source.text.size()));
  const std::optional<std::string> text = without_last_commas(source.text);
  JsonReader(*this, text ? std::string_view(*text) : std::string_view(source.text)).read();
}

JsonText::JsonText(const Source& source, Unread /*unread*/)
    : map_(source.name, source.text), size_(source.text.size()) {}

void JsonText::replace(const JsonValue& string, double number) {
  Node& node = nodes_[string.node_];
  node.kind = static_cast<std::uint8_t>(JsonKind::number);
  node.number = number;
}

JsonKind JsonValue::kind() const {
  return static_cast<JsonKind>(static_cast<std::uint8_t>(text_->nodes_[node_].kind));
}

Place JsonValue::place() const {
  return text_->map_.place(text_->nodes_[node_].offset);
}

std::size_t JsonValue::file_size() const {
  return text_->size_;
}

const Units& JsonValue::units() const {
  return text_->units_;
}

double JsonValue::number() const {
  return text_->nodes_[node_].number;
}

std::string_view JsonValue::string() const {
  const JsonText::Node& node = text_->nodes_[node_];
  return std::string_view(text_->strings_).substr(node.string.first, node.string.length);
}

JsonValue::Iterator& JsonValue::Iterator::operator++() {
  const JsonText::Node& node = text_->nodes_[node_];
  const bool has_parts = node.kind == static_cast<std::uint8_t>(JsonKind::array) ||
                         node.kind == static_cast<std::uint8_t>(JsonKind::object);
  node_ = has_parts ? node.end : node_ + 1;
  return *this;
}

JsonValue::Iterator JsonValue::end() const {
  const bool has_parts = kind() == JsonKind::array || kind() == JsonKind::object;
  return {*text_, has_parts ? text_->nodes_[node_].end : node_ + 1};
}

std::optional<JsonValue> JsonValue::member(std::string_view key) const {
  for (Iterator i = begin(); i != end(); ++i) {
    const JsonValue name = *i;
    ++i;
    if (name.string() == key) return *i;
  }
  return std::nullopt;
}

void JsonValue::fail_missing(std::string_view expected) const {
  throw InputError(place(), fmt::format("expected {}, found none", expected));
}

void JsonValue::fail(std::string_view expected) const {
  const auto found = [&]() -> std::string {
    switch (kind()) {
      case JsonKind::null:
        return "null";
      case JsonKind::no:
        return "false";
      case JsonKind::yes:
        return "true";
      case JsonKind::number:
        return fmt::format("{}", number());
      case JsonKind::string:
        return "\"" + clipped(string()) + "\"";
      case JsonKind::array:
        return "an array";
      case JsonKind::object:
        return "an object";
    }
    return {};
  };
  throw InputError(place(), fmt::format("expected {}, found {}", expected, found()));
}

}  // namespace keyblock::formats
