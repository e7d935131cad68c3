// An include that runs up within its room, for the test of the test: never compiled.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/time/impact.hpp"
