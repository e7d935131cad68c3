// An include over the fence around Shi's rules, for the test of the test: never compiled.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "legacy/step/advance.hpp"
