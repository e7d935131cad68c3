// Saves and restores the state of the program: the same lines of code list the values for both directions.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "base/error.hpp"
#include "base/index.hpp"

namespace keyblock {

/// Tree of named columns. The rows of a list append one after another to the same columns.
struct ArchiveNode {
  using Column = std::variant<std::monostate, std::vector<double>, std::vector<std::int64_t>, std::vector<std::string>>;

  std::string name;
  Column column;  ///< in a leaf
  std::vector<std::unique_ptr<ArchiveNode>> children;
  std::size_t taken = 0;  ///< number of restored values of the column
  std::size_t next = 0;   ///< the child to try first: members come in the same order every time
};

/// Saves values passed to it, or replaces them by the saved ones, bit for bit. Restoring throws InputError, with the
/// file and the column, if a value is missing, of another kind or out of its bounds.
class Archive {
 public:
  Archive();
  Archive(std::string file, std::unique_ptr<ArchiveNode> root);

  bool is_restoring() const { return restoring_; }
  const ArchiveNode& root() const { return *root_; }

  void value(std::string_view name, double& number);
  void value(std::string_view name, int& number);
  void value(std::string_view name, bool& flag);
  void value(std::string_view name, std::string& text);
  void value(std::string_view name, std::size_t& number);

  /// Saves or restores an enumeration from 0 to `last`.
  template <class E>
  void choice(std::string_view name, E& chosen, E last) {
    chosen = static_cast<E>(bounded(name, static_cast<std::int64_t>(chosen), 0, static_cast<std::int64_t>(last)));
  }

  /// Saves or restores an index; a restored one must be unset or below `end`.
  template <class I>
  void index(std::string_view name, I& index, I end) {
    index.value = static_cast<int>(bounded(name, index.value, -1, end.value - 1));
  }

  /// Saves or restores all numbers of an item whose size the model gives; another size is an error.
  void values(std::string_view name, std::span<double> numbers);

  /// Saves or restores a list of numbers with its size.
  void numbers(std::string_view name, std::vector<double>& numbers);

  template <class Members>
  void group(std::string_view name, const Members& members) {
    ArchiveNode* const above = here_;
    here_ = &child(name);
    members();
    here_ = above;
  }

  /// Saves or restores rows of an item whose length the model gives; another length is an error.
  template <class Rows, class Describe>
  void table(std::string_view name, Rows& rows, const Describe& describe_row) {
    group(name, [&] {
      same_size(rows.size());
      for (auto& row : rows) describe_row(row);
    });
  }

  /// Saves or restores rows with their number. Memory grows row by row, as long as there are values for them.
  template <class Rows, class Describe>
  void list(std::string_view name, Rows& rows, const Describe& describe_row) {
    group(name, [&] {
      const std::size_t count = size(rows.size());
      if (restoring_) rows.clear();
      for (std::size_t i = 0; i < count; ++i) {
        if (restoring_) rows.emplace_back();
        describe_row(rows[i]);
      }
    });
  }

  /// Saves or restores the entries of a map.
  template <class Map, class Describe>
  void map(std::string_view name, Map& entries, const Describe& describe_entry) {
    group(name, [&] {
      const std::size_t count = size(entries.size());
      const Map saved = restoring_ ? Map{} : entries;
      if (restoring_) entries.clear();
      auto next = saved.begin();
      for (std::size_t i = 0; i < count; ++i) {
        auto key = restoring_ ? typename Map::key_type{} : next->first;
        auto mapped = restoring_ ? typename Map::mapped_type{} : next->second;
        describe_entry(key, mapped);
        if (restoring_)
          entries.emplace(std::move(key), std::move(mapped));
        else
          ++next;
      }
    });
  }

  /// Throws InputError: `expected …, found …`.
  [[noreturn]] void refuse(std::string_view name, const std::string& sentence) const;

 private:
  ArchiveNode& child(std::string_view name);
  template <class T>
  T through(std::string_view name, T value);
  std::int64_t bounded(std::string_view name, std::int64_t number, std::int64_t least, std::int64_t most);
  std::size_t size(std::size_t now);
  void same_size(std::size_t wanted);

  std::string file_;
  std::unique_ptr<ArchiveNode> root_;
  ArchiveNode* here_;
  bool restoring_;
};

}  // namespace keyblock
