// Defines presets of the quirks, by name.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "settings/settings.hpp"

namespace keyblock {

BerkeleyQuirks BerkeleyQuirks::none() {
  BerkeleyQuirks quirks = BerkeleyQuirks{}.without_those_of_the_step();
  quirks.moments_about_origin = false;
  quirks.plane_strain_factor = false;
  quirks.start_velocity_slots = false;
  quirks.weight_of_first_material = false;
  return quirks;
}

BerkeleyQuirks BerkeleyQuirks::without_those_of_the_step() const {
  BerkeleyQuirks quirks = *this;
  quirks.search_full_depth = false;
  quirks.edge_direction_offset = false;
  quirks.stale_contact_list = false;
  quirks.contact_length_last_vertex = false;
  quirks.velocity_from_coming_step = false;
  quirks.cut_step_stays = false;
  quirks.fixed_pass_bound = false;
  quirks.step_rule_by_time = false;
  return quirks;
}

}  // namespace keyblock
