// An include that runs up, for the test of the test: never compiled.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command.hpp"
