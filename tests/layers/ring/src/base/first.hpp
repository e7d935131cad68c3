// Includes a file that includes it, for the test of the layers test. Never compiled.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/second.hpp"
