// Defines one index type per table, so that a vertex number cannot be used as an element number. Indices count from 0.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <compare>
#include <cstddef>
#include <utility>
#include <vector>

namespace keyblock {

/// Index into the one table that its tag names; unset by default.
template <class Tag>
struct Index {
  int value = -1;

  auto operator<=>(const Index&) const = default;
  explicit operator bool() const { return value >= 0; }
};

using ElementIndex = Index<struct ElementTag>;
using VertexIndex = Index<struct VertexTag>;

/// Vector that takes only its own kind of index.
template <class I, class T>
class Table : public std::vector<T> {
 public:
  using std::vector<T>::vector;

  T& operator[](I index) { return std::vector<T>::operator[](static_cast<std::size_t>(index.value)); }
  const T& operator[](I index) const { return std::vector<T>::operator[](static_cast<std::size_t>(index.value)); }
  /// Returns the index after the last.
  I end_index() const { return {static_cast<int>(this->size())}; }
};

/// Indices first … end-1, for range-based loops.
template <class I>
class IndexRange {
 public:
  IndexRange(I first, I end) : first_(first), end_(end) {}

  struct Iterator {
    I index;
    I operator*() const { return index; }
    Iterator& operator++() {
      ++index.value;
      return *this;
    }
    bool operator!=(const Iterator& other) const { return index != other.index; }
  };
  Iterator begin() const { return {first_}; }
  Iterator end() const { return {end_}; }
  int size() const { return end_.value - first_.value; }

 private:
  I first_;
  I end_;
};

template <class I, class T>
IndexRange<I> indices(const Table<I, T>& table) {
  return {I{0}, table.end_index()};
}

}  // namespace keyblock
