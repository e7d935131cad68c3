// Counts how often the bodies of a run change.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "base/archive.hpp"
#include "model/model.hpp"

namespace keyblock {

/// Epochs of a run, from 0. Within one, blocks or elements, their numbers, their corners and their undeformed outlines
/// stay the same.
class Epochs {
 public:
  /// Returns the epoch of the model, one more than before if its bodies differ from those of the last call.
  int at(const Model& model);
  void describe(Archive& archive);

 private:
  int epoch_ = 0;
  std::size_t bodies_ = 0;  ///< hash; 0: none yet
};

}  // namespace keyblock
