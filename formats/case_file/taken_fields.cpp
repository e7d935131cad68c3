// Takes requested keys in turn and reports the remaining ones; see taken_fields.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/case_file/taken_fields.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "base/nearest.hpp"

namespace keyblock::formats {

TakenFields::TakenFields(JsonValue value, std::string_view noun) : from_(value), noun_(noun) {
  if (value.kind() == JsonKind::array) in_row_ = value.begin();
}

std::string TakenFields::nearest_of(std::string_view name) const {
  const std::string found = nearest(name, {known_.begin(), known_.end()});
  return found.empty() ? found : fmt::format(" (did you mean \"{}\"?)", found);
}

void TakenFields::finish() const {
  if (in_row_) {
    if (*in_row_ != from_.end()) (**in_row_).fail(fmt::format("the end of {}: {}", noun_, fmt::join(known_, ", ")));
    return;
  }
  std::vector<std::string_view> seen;
  for (auto i = from_.begin(); i != from_.end(); ++i) {
    const JsonValue key = *i;
    ++i;
    const std::string_view name = key.string();
    if (std::ranges::find(known_, name) == known_.end())
      key.fail(fmt::format("a key of {}{}: {}", noun_, nearest_of(name), fmt::join(known_, ", ")));
    if (std::ranges::find(seen, name) != seen.end()) key.fail(fmt::format("each key of {} once", noun_));
    seen.push_back(name);
  }
  if (!missing_.empty()) from_.fail_missing(missing_);
}

bool TakenFields::take(std::string_view name) {
  known_.push_back(name);
  if (in_row_) {
    if (*in_row_ == from_.end())
      throw InputError(from_.place(),
                       fmt::format("expected {} of {} as value {} of the row ({}), found a row of {}", name, noun_,
                                   known_.size(), fmt::join(known_, ", "), known_.size() - 1));
    value_ = **in_row_;
    ++*in_row_;
    return true;
  }
  value_ = from_.member(name);
  return value_.has_value();
}

const JsonValue& TakenFields::of_kind(JsonKind kind, std::string_view name) const {
  if (value_->kind() != kind)
    value_->fail(fmt::format("{} of {}: an {}", name, noun_, kind == JsonKind::array ? "array" : "object"));
  return *value_;
}

std::size_t TakenFields::size_of(const JsonValue& array) {
  std::size_t size = 0;
  for (auto i = array.begin(); i != array.end(); ++i) ++size;
  return size;
}

void TakenFields::require(std::string_view name, std::size_t size, std::optional<std::size_t> least) {
  if (!least) return;
  if (value_ && size < *least) value_->fail(fmt::format("{} of {}: {} or more", name, noun_, *least));
  if (!value_ && missing_.empty()) missing_ = fmt::format("the key {} of {}: an array", name, noun_);
}

}  // namespace keyblock::formats
