// Holds a choice for all materials, with other values for some of them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <utility>

namespace keyblock {

template <class T>
struct PerMaterial {
  T common{};
  std::map<int, T> own;  ///< by material number, from 0

  PerMaterial() = default;
  /// Sets one value for all; a plain value may be assigned if all materials share it.
  PerMaterial(T value) : common(std::move(value)) {}

  const T& of(int material) const {
    const auto found = own.find(material);
    return found == own.end() ? common : found->second;
  }
};

}  // namespace keyblock
