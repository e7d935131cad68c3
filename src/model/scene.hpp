// What a run steps through: a model and the choices by which it moves.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/model.hpp"
#include "settings/settings.hpp"

namespace keyblock {

struct Scene {
  Model model;
  Settings settings;
};

}  // namespace keyblock
