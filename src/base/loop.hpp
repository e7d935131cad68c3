// Runs loops over blocks and contacts on several threads, with the same result for any number of them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

#include "base/index.hpp"

namespace keyblock {

/// Returns the number of threads of the calling thread's context.
int loop_threads();

/// Entries per range. Ranges do not depend on threads, so sums over them do not either.
inline constexpr std::size_t kLoopRange = 256;

inline std::size_t range_count(std::size_t count) {
  return (count + kLoopRange - 1) / kLoopRange;
}

/// Cost of an entry: `heavy` is a tenth of a microsecond and more (a product of blocks, a contact), `light` a few
/// nanoseconds (a sum of vectors). The caller alone handles fewer ranges than `worth_waking`, because waking threads
/// would take as long.
enum class Work { heavy, light };
constexpr std::size_t worth_waking(Work weight) {
  return weight == Work::light ? 32 : 4;
}

/// Calls `work(range, begin, end)` for all ranges of 0 … count − 1, in any order and in parallel. After all are done it
/// rethrows the exception of the lowest range. `base/parallel` is for whole jobs instead: files, runs.
void for_ranges(std::size_t count, const std::function<void(std::size_t, std::size_t, std::size_t)>& work,
                Work weight = Work::heavy);

/// Calls `work(i)` for 0 … count − 1; calls must not depend on each other.
template <class Each>
void for_each_entry(std::size_t count, const Each& each, Work weight = Work::heavy) {
  if (range_count(count) < worth_waking(weight)) {  // most loops of small scenes: wraps no function
    for (std::size_t i = 0; i < count; ++i) each(i);
    return;
  }
  for_ranges(
      count,
      [&](std::size_t, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) each(i);
      },
      weight);
}

/// Calls `each` for all indices of a table.
template <class I, class T, class Each>
void for_each_index(const Table<I, T>& table, const Each& each) {
  for_each_entry(table.size(), [&](std::size_t i) { each(I{static_cast<int>(i)}); });
}

/// Returns several sums over `term(i)`, an array of `N` each, with one order of addition. A term may write data of its
/// own i.
template <std::size_t N, class Term>
std::array<double, N> sums_over(std::size_t count, const Term& term, Work weight = Work::heavy) {
  const auto sum_of = [&](std::size_t begin, std::size_t end) {
    std::array<double, N> sum{};
    for (std::size_t i = begin; i < end; ++i) {
      const std::array<double, N> one = term(i);
      for (std::size_t k = 0; k < N; ++k) sum[k] += one[k];
    }
    return sum;
  };
  std::array<double, N> all{};
  const auto add = [&](const std::array<double, N>& part) {
    for (std::size_t k = 0; k < N; ++k) all[k] += part[k];
  };
  if (count <= kLoopRange) {
    add(sum_of(0, count));
    return all;
  }
  std::vector<std::array<double, N>> parts(range_count(count));
  for_ranges(
      count, [&](std::size_t range, std::size_t begin, std::size_t end) { parts[range] = sum_of(begin, end); }, weight);
  for (const std::array<double, N>& part : parts) add(part);
  return all;
}

}  // namespace keyblock
