// Names the warnings about skipped elements; see ddaml_ignored.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/berkeley/ddaml_ignored.hpp"

#include <array>

#include "base/sentences/sentences.hpp"

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
  Facts facts;
  facts.names = {{"element_name", std::string(element.name())}};
  return warning_of({name, std::move(facts)}, element.place());
}

Warning repeated(const Element& element) {
  Facts facts;
  facts.names = {{"element_name", std::string(element.name())}};
  return warning_of({"repeated_element", std::move(facts)}, element.place());
}

}  // namespace keyblock::formats
