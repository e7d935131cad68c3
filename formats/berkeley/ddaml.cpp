// Finds the geometry and the analysis of a DDAML document, and has them read and written.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/berkeley/ddaml.hpp"

#include <fmt/format.h>

#include "formats/berkeley/ddaml_analysis.hpp"
#include "formats/berkeley/ddaml_geometry.hpp"
#include "formats/berkeley/ddaml_ignored.hpp"
#include "formats/berkeley/ddaml_text.hpp"
#include "formats/xml/xml_document.hpp"

namespace keyblock::formats {
namespace {

bool begins_with_markup(std::string_view text) {
  const std::size_t first = without_bom(text).find_first_not_of(" \t\r\n");
  return first != std::string_view::npos && without_bom(text)[first] == '<';
}

bool is_ours(const Element& root) {
  return root.name() == "DDA" || root.name() == "Geometry" || root.name() == "Analysis";
}

Recognition recognise_model(const Source& source) {
  using Fit = Recognition::Fit;
  if (!begins_with_markup(source.text)) return {};
  try {
    const Document document(source);
    if (is_ours(document.root())) return {Fit::exact, fmt::format("XML with root element {}", document.root().name())};
    return {Fit::damaged, fmt::format("XML, but with root element {}", document.root().name())};
  } catch (const InputError&) {
    return {Fit::damaged, "begins as XML, but is not well-formed"};
  }
}

std::vector<Element> sections_of(const Element& root) {
  if (root.name() == "DDA") return root.children();
  return {root};
}

Reading read_model(const Source& source, const ReadHint&) {
  const Document document(source);
  const Element root = document.root();
  if (!is_ours(root))
    throw InputError(root.place(), fmt::format("expected the root element DDA of a DDAML file, found {}", root.name()));
  Reading reading;
  const auto once = [](bool seen, const Element& element) {
    if (seen)
      throw InputError(element.place(), fmt::format("expected one {} in a file, found a second", element.name()));
  };
  for (const Element& section : sections_of(root)) {
    if (section.name() == "Geometry") {
      once(reading.content.drawing.has_value(), section);
      auto [drawing, warnings] = read_geometry(section);
      reading.content.drawing = std::move(drawing);
      reading.warnings = joined(std::move(reading.warnings), warnings);
    } else if (section.name() == "Analysis") {
      once(reading.content.analysis.has_value(), section);
      auto [analysis, warnings] = read_analysis(section);
      reading.content.analysis = std::move(analysis);
      reading.warnings = joined(std::move(reading.warnings), warnings);
    } else {
      add_warning(reading.warnings, ignored(section));
    }
  }
  if (!reading.content.drawing && !reading.content.analysis)
    throw InputError(root.place(), "expected a Geometry or an Analysis element, found neither");
  return reading;
}

}  // namespace

constinit const Format kDdaml{.name = "ddaml",
                              .title = "DDAML (XML geometry and analysis of Berkeley's DDA)",
                              .recognise = recognise_model,
                              .read = read_model,
                              .write = ddaml_text,
                              .evidence = "data and public source",
                              .sample = R"(<?xml version="1.0"?>
<DDA>
 <Geometry>
  <Edgenodedist distance="0.01"/>
  <Jointlist>
   <Joint type="1"> 0 0 4 0 </Joint> <Joint type="1"> 4 0 4 1 </Joint>
   <Joint type="1"> 4 1 0 1 </Joint> <Joint type="1"> 0 1 0 0 </Joint>
  </Jointlist>
  <Fixedpointlist> <Point> 1 0.5 </Point> </Fixedpointlist>
 </Geometry>
</DDA>
)"};

}  // namespace keyblock::formats
