// Adds the histories and contacts that a caller requests to the plan of the case file.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "job/folder/outputs_asked.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <stdexcept>
#include <utility>

#include "base/error.hpp"
#include "run/follow/history_option.hpp"

namespace keyblock {

OutputPlan outputs_asked(OutputPlan plan, const OutputOptions& options) {
  try {
    for (const std::string& text : options.histories) {
      plan.histories.push_back(history_of(text));
      plan.histories.back().place = {FileName::of_choice("history", text)};
    }
  } catch (const std::invalid_argument& error) {
    throw ChoiceError("history", error.what());
  }
  if (options.contacts.empty()) return plan;
  plan.contacts_every = 1;
  plan.place = {FileName::of_choice("contacts", options.contacts)};
  constexpr std::array<std::pair<const char*, ContactTables>, 4> kWords{{{"automatic", ContactTables::automatic},
                                                                         {"all", ContactTables::all},
                                                                         {"chosen", ContactTables::chosen},
                                                                         {"none", ContactTables::none}}};
  for (const auto& [word, which] : kWords)
    if (options.contacts == word) {
      plan.contacts = which;
      return plan;
    }
  const char* end = options.contacts.data() + options.contacts.size();
  const auto [stop, error] = std::from_chars(options.contacts.data(), end, plan.contacts_every);
  if (error != std::errc{} || stop != end || plan.contacts_every < 1)
    throw ChoiceError("contacts", fmt::format("expected automatic, all, chosen, none, or the number of frames from one "
                                              "to the next; found \"{}\"",
                                              options.contacts));
  plan.contacts = ContactTables::all;
  return plan;
}

}  // namespace keyblock
