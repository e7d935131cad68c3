// Includes a higher folder of its own module, for the test of the layers test. Never compiled.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/time/impact.hpp"
