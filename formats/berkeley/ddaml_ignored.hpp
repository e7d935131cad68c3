// Warns of elements of a DDAML file that Keyblock skips.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "formats/xml/xml_document.hpp"

namespace keyblock::formats {

/// Returns the warning that an element is skipped; the code of the warning names known elements.
Warning ignored(const Element& element);

/// Returns the warning that the last of several such elements counts.
Warning repeated(const Element& element);

}  // namespace keyblock::formats
