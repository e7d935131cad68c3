// Gives up at the first value that lies too deep.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/bytes/sound_json.hpp"

namespace keyblock {
namespace {

struct TooDeep {};

}  // namespace

nlohmann::ordered_json sound_json(std::string_view text, bool with_comments) {
  using Json = nlohmann::ordered_json;
  const auto look = [](int level, Json::parse_event_t, const Json&) {
    if (level > kMostJsonLevels) throw TooDeep{};
    return true;
  };
  try {
    return Json::parse(text, look, false, with_comments);
  } catch (const TooDeep&) {
    return Json::value_t::discarded;
  }
}

}  // namespace keyblock
