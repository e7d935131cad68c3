// Finds columns by name, and fills or empties them from the front.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/archive.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace keyblock {

Archive::Archive() : root_(std::make_unique<ArchiveNode>()), here_(root_.get()), restoring_(false) {}

Archive::Archive(std::string file, std::unique_ptr<ArchiveNode> root)
    : file_(std::move(file)), root_(std::move(root)), here_(root_.get()), restoring_(true) {}

void Archive::refuse(std::string_view name, const std::string& sentence) const {
  throw InputError({file_, 0, 0},
                   fmt::format("{} ({}{}{})", sentence, here_->name, here_->name.empty() ? "" : ": ", name));
}

ArchiveNode& Archive::child(std::string_view name) {
  const std::size_t count = here_->children.size();
  for (std::size_t looked = 0; looked < count; ++looked) {
    const std::size_t at = (here_->next + looked) % count;
    if (here_->children[at]->name != name) continue;
    here_->next = at + 1;
    return *here_->children[at];
  }
  if (restoring_) refuse(name, "expected a saved value, found none");
  here_->children.push_back(std::make_unique<ArchiveNode>());
  here_->children.back()->name = name;
  here_->next = count + 1;
  return *here_->children.back();
}

template <class T>
T Archive::through(std::string_view name, T value) {
  ArchiveNode& node = child(name);
  if (restoring_) {
    auto* column = std::get_if<std::vector<T>>(&node.column);
    if (!column) refuse(name, "expected a saved value of another kind");
    if (node.taken == column->size())
      refuse(name, fmt::format("expected more than {} values, found no more", node.taken));
    return (*column)[node.taken++];
  }
  if (node.column.index() == 0) node.column = std::vector<T>();
  std::get<std::vector<T>>(node.column).push_back(value);
  return value;
}

std::int64_t Archive::bounded(std::string_view name, std::int64_t number, std::int64_t least, std::int64_t most) {
  number = through(name, number);
  if (restoring_ && (number < least || number > most))
    refuse(name, fmt::format("expected a number from {} to {}, found {}", least, most, number));
  return number;
}

void Archive::value(std::string_view name, double& number) {
  number = through(name, number);
}

void Archive::value(std::string_view name, int& number) {
  number = static_cast<int>(bounded(name, number, std::numeric_limits<int>::min(), std::numeric_limits<int>::max()));
}

void Archive::value(std::string_view name, bool& flag) {
  flag = bounded(name, flag ? 1 : 0, 0, 1) == 1;
}

void Archive::value(std::string_view name, std::string& text) {
  text = through(name, text);
}

void Archive::value(std::string_view name, std::size_t& number) {
  number = static_cast<std::size_t>(
      bounded(name, static_cast<std::int64_t>(number), 0, std::numeric_limits<std::int64_t>::max()));
}

std::size_t Archive::size(std::size_t now) {
  value("count", now);
  return now;
}

void Archive::same_size(std::size_t wanted) {
  const std::size_t found = size(wanted);
  if (found != wanted) refuse("count", fmt::format("expected {} as in the model, found {}", wanted, found));
}

void Archive::values(std::string_view name, std::span<double> numbers) {
  group(name, [&] {
    same_size(numbers.size());
    for (double& number : numbers) value("values", number);
  });
}

void Archive::numbers(std::string_view name, std::vector<double>& numbers) {
  list(name, numbers, [&](double& number) { value("values", number); });
}

}  // namespace keyblock
