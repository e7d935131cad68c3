// A choice for all materials, with others for some of them.
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
  /// One value for all; a plain value may be assigned where all materials share it.
  PerMaterial(T value) : common(std::move(value)) {}

  const T& of(int material) const {
    const auto found = own.find(material);
    return found == own.end() ? common : found->second;
  }
};

}  // namespace keyblock
