// Follows the events of the JSON reader and the number of characters it has taken.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/placed_json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>

#include "formats/numbers.hpp"
#include "formats/tokens.hpp"

namespace keyblock::formats {
namespace {

using Json = nlohmann::json;
using Kind = PlacedJson::Kind;

/// Walks over the text and tells how far it came.
class CountingIterator {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  CountingIterator(const char* at, std::size_t* taken) : at_(at), taken_(taken) {}
  reference operator*() const { return *at_; }
  CountingIterator& operator++() {
    ++at_;
    ++*taken_;
    return *this;
  }
  CountingIterator operator++(int) {
    const CountingIterator before = *this;
    ++*this;
    return before;
  }
  bool operator==(const CountingIterator& other) const { return at_ == other.at_; }

 private:
  const char* at_;
  std::size_t* taken_;
};

/// Builds the tree; the open lists and objects lie on a stack.
class TreeBuilder {
 public:
  TreeBuilder(const Source& source, std::string_view text, const std::size_t& taken)
      : text_(text), taken_(taken), map_(source.name, text), place_{source.name, 0, 0} {}

  bool null() { return add(Kind::null, "null"); }
  bool boolean(bool value) { return add(Kind::flag, value ? "true" : "false"); }
  bool number_integer(Json::number_integer_t value) { return add_number(static_cast<double>(value)); }
  bool number_unsigned(Json::number_unsigned_t value) { return add_number(static_cast<double>(value)); }
  bool number_float(Json::number_float_t value, const std::string&) { return add_number(value); }
  bool string(std::string& value) { return add(Kind::text, value); }
  bool binary(Json::binary_t&) { return false; }
  bool start_object(std::size_t) { return open(Kind::object, "an object"); }
  bool start_array(std::size_t) { return open(Kind::list, "a list"); }
  bool end_object() { return close(); }
  bool end_array() { return close(); }

  bool key(std::string& name) {
    place_ = place_of_key(name);
    PlacedJson& object = open_.back();
    if (std::ranges::find(object.keys, name) != object.keys.end())
      throw InputError(place_, fmt::format("expected each key once, found {} a second time", in_quotes(name)));
    object.keys.push_back(name);
    return true;
  }

  bool parse_error(std::size_t position, const std::string& token, const Json::exception&) {
    const bool is_end = token == "<end of file>" || position > text_.size();
    const std::size_t at = is_end ? text_.size() : position - std::min<std::size_t>(position, 1);
    throw InputError(map_.place(at),
                     fmt::format("expected well-formed JSON, found {}", is_end ? "end of file" : in_quotes(token)));
  }

  PlacedJson take() { return std::move(root_); }

 private:
  /// The key has just been taken with its closing quote. Its column is unknown where escapes stand in it.
  Place place_of_key(const std::string& name) const {
    const std::string written = '"' + name + '"';
    const std::size_t end = std::min(taken_, text_.size());
    const bool is_plain = end >= written.size() && text_.substr(end - written.size(), written.size()) == written;
    Place place = map_.place(is_plain ? end - written.size() : end);
    if (!is_plain) place.column = 0;
    return place;
  }

  bool add_number(double value) {
    add(Kind::number, format_real(value));
    last_->number = value;
    return true;
  }

  bool add(Kind kind, std::string text) {
    PlacedJson value{kind, std::move(text), 0, {}, {}, place_};
    if (open_.empty()) {
      root_ = std::move(value);
      last_ = &root_;
    } else {
      open_.back().items.push_back(std::move(value));
      last_ = &open_.back().items.back();
    }
    return true;
  }

  bool open(Kind kind, std::string text) {
    if (open_.size() == kDeepestJson)
      throw InputError(map_.place(taken_), fmt::format("expected JSON of {} levels at most, found more", kDeepestJson));
    const bool has_key = !open_.empty() && open_.back().kind == Kind::object;
    open_.push_back({kind, std::move(text), 0, {}, {}, has_key ? place_ : map_.place(taken_ - 1)});
    return true;
  }

  bool close() {
    PlacedJson done = std::move(open_.back());
    open_.pop_back();
    (open_.empty() ? root_ : open_.back().items.emplace_back()) = std::move(done);
    return true;
  }

  std::string_view text_;
  const std::size_t& taken_;
  TextMap map_;
  Place place_;
  std::vector<PlacedJson> open_;
  PlacedJson root_;
  PlacedJson* last_ = nullptr;
};

}  // namespace

PlacedJson read_json(const Source& source) {
  const std::string_view text = without_bom(source.text);
  std::size_t taken = 0;
  TreeBuilder builder(source, text, taken);
  const char* const begin = text.data();
  Json::sax_parse(CountingIterator(begin, &taken), CountingIterator(begin + text.size(), &taken), &builder);
  return builder.take();
}

PlacedJson json_of_word(const std::string& name, std::string_view word) {
  PlacedJson value{Kind::text, std::string(word), 0, {}, {}, {name}};
  if (const auto number = parse_real(word)) {
    value.kind = Kind::number;
    value.number = *number;
  }
  return value;
}

PlacedJson json_of_option(const std::string& name, std::string_view text) {
  PlacedJson object{Kind::object, "an object", 0, {}, {}, {name}};
  while (!text.empty()) {
    const std::string_view part = text.substr(0, text.find(','));
    text.remove_prefix(std::min(part.size() + 1, text.size()));
    const std::size_t equals = part.find('=');
    if (equals == std::string_view::npos || equals == 0)
      throw InputError({name}, fmt::format("expected key=value, found {}", in_quotes(part)));
    const std::string key(part.substr(0, equals));
    if (std::ranges::find(object.keys, key) != object.keys.end())
      throw InputError({name}, fmt::format("expected each key once, found {} a second time", in_quotes(key)));
    object.keys.push_back(key);
    object.items.push_back(json_of_word(name, part.substr(equals + 1)));
  }
  return object;
}

}  // namespace keyblock::formats
