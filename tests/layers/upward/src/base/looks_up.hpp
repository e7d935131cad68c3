// Includes a file of a higher layer, for the test of the layers test. Never compiled.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command.hpp"
