// Includes a file across the fence around Shi's rules, for the test of the layers test. Never compiled.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "legacy/step/advance.hpp"
