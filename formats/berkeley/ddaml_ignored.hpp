// What a DDAML file holds and Keyblock passes over.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "formats/xml/xml_document.hpp"

namespace keyblock::formats {

/// The warning that an element is skipped; it is named after what is skipped where that is known.
Warning ignored(const Element& element);

}  // namespace keyblock::formats
