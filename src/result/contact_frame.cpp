// Names the conditions of contacts.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "result/contact_frame.hpp"

namespace keyblock {

std::string_view word_for(ContactCondition condition) {
  switch (condition) {
    case ContactCondition::open:
      return "open";
    case ContactCondition::stick:
      return "stick";
    case ContactCondition::slide:
      return "slide";
  }
  return "";
}

}  // namespace keyblock
