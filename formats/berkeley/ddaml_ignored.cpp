// Names the warnings about skipped elements; see ddaml_ignored.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/berkeley/ddaml_ignored.hpp"

#include <fmt/format.h>

#include <array>

namespace keyblock::formats {

Warning ignored(const Element& element) {
  static constexpr std::array<std::array<std::string_view, 2>, 5> kNames{
      {{"Seismicpointlist", "seismic_points_ignored"},
       {"Timehistory", "time_history_ignored"},
       {"Pipeflow", "pipe_flow_ignored"},
       {"Fluids", "pipe_flow_ignored"},
       {"PipeFlow", "pipe_flow_ignored"}}};
  std::string name = "unknown_element";
  for (const auto& [element_name, warning_name] : kNames)
    if (element.name() == element_name) name = warning_name;
  return {name, element.place(), fmt::format("{} is ignored", element.name())};
}

}  // namespace keyblock::formats
