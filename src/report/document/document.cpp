// Writes the document; the style prints black on white, and follows the reader's choice of light or dark on a screen.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/document.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "report/drawing/png.hpp"
#include "report/drawing/svg.hpp"

namespace keyblock::report {
namespace {

constexpr std::string_view kStyle = R"(
:root { color-scheme: light dark; --text: #1d2330; --faint: #5b6472; --line: #d5dae2; --back: #fff; --head: #f3f5f8 }
@media (prefers-color-scheme: dark) {
  :root { --text: #e6e9ef; --faint: #a7b0be; --line: #3a4250; --back: #14181f; --head: #1e242e }
}
* { box-sizing: border-box }
body { font: 15px/1.5 system-ui, "DejaVu Sans", Helvetica, Arial, sans-serif; color: var(--text);
  background: var(--back); max-width: 60rem; margin: 0 auto; padding: 1.5rem 1.25rem 4rem }
h1 { font-size: 1.7rem; margin: 0 } h2 { font-size: 1.2rem; margin: 2rem 0 .5rem; break-after: avoid }
.subtitle { color: var(--faint); margin: .2rem 0 1rem }
.verdict { border-left: 6px solid; padding: .6rem .9rem; background: var(--head); border-radius: 0 6px 6px 0 }
.good { border-color: #1a7f4b } .doubtful { border-color: #b26a00 } .bad { border-color: #b3261e }
nav { margin: 1rem 0; color: var(--faint) } a { color: inherit }
nav a { margin-right: 1rem; white-space: nowrap }
.scroll { overflow-x: auto; margin: .6rem 0 }
table { border-collapse: collapse; width: 100%; font-size: .92em }
th, td { text-align: left; padding: .25rem .6rem .25rem 0; border-bottom: 1px solid var(--line);
  vertical-align: top; overflow-wrap: anywhere }
th { font-weight: 600; background: var(--head); overflow-wrap: normal }
td.number { text-align: right; font-variant-numeric: tabular-nums; white-space: nowrap }
figure { margin: 1rem 0; break-inside: avoid }
figure img { width: 100%; background: #fff; border: 1px solid var(--line) }
figcaption { color: var(--faint); font-size: .9em }
@media print {
  @page { size: A4; margin: 16mm } body { font-size: 10pt; padding: 0; max-width: none } nav { display: none }
  tr { break-inside: avoid } :root { --text: #000; --faint: #444; --line: #bbb; --back: #fff; --head: #f3f3f3 } }
)";

bool is_number(const std::string& cell) {
  return !cell.empty() && std::isdigit(static_cast<unsigned char>(cell.back())) != 0 &&
         std::ranges::all_of(
             cell, [](char c) { return std::string_view("0123456789+-.eE ").find(c) != std::string_view::npos; });
}

// Returns true if each cell of the column is a number or empty.
bool is_numeric(const DocumentTable& table, std::size_t column) {
  return std::ranges::all_of(
      table.rows, [&](const std::vector<std::string>& row) { return row[column].empty() || is_number(row[column]); });
}

std::string_view class_of(Verdict verdict) {
  return verdict == Verdict::good ? "good" : verdict == Verdict::doubtful ? "doubtful" : "bad";
}

std::string table_of(const DocumentTable& table) {
  std::string text = "<div class=\"scroll\" tabindex=\"0\"><table>";
  if (!std::ranges::all_of(table.columns, &std::string::empty)) {
    text += "<thead><tr>";
    for (const std::string& column : table.columns)
      text += fmt::format("<th scope=\"col\">{}</th>", escape_xml(column));
    text += "</tr></thead>";
  }
  text += "<tbody>";
  for (const std::vector<std::string>& row : table.rows) {
    text += "<tr>";
    for (std::size_t column = 0; column < row.size(); ++column)
      text +=
          fmt::format("<td{}>{}</td>", is_numeric(table, column) ? " class=\"number\"" : "", escape_xml(row[column]));
    text += "</tr>\n";
  }
  return text + "</tbody></table></div>\n";
}

std::string section_of(const DocumentSection& section) {
  const std::string anchor =
      section.anchor.empty() ? std::string() : fmt::format(" id=\"{}\"", escape_xml(section.anchor));
  std::string text = fmt::format("<section{}><h2>{}</h2>\n", anchor, escape_xml(section.heading));
  for (const std::string& paragraph : section.paragraphs) text += fmt::format("<p>{}</p>\n", escape_xml(paragraph));
  for (const DocumentPicture& picture : section.pictures)
    text += fmt::format(
        "<figure><img src=\"data:image/svg+xml;base64,{}\" alt=\"{}\"><figcaption>{}</figcaption></figure>\n",
        base64(picture.svg), escape_xml(picture.caption), escape_xml(picture.caption));
  for (const DocumentTable& table : section.tables) text += table_of(table);
  return text + "</section>\n";
}

std::string links_of(const std::vector<DocumentSection>& sections) {
  std::string text;
  for (const DocumentSection& section : sections)
    if (!section.anchor.empty())
      text += fmt::format("<a href=\"#{}\">{}</a> ", escape_xml(section.anchor), escape_xml(section.heading));
  return text.empty() ? text : fmt::format("<nav aria-label=\"sections\">{}</nav>\n", text);
}

}  // namespace

std::string document_page(const Document& document) {
  std::string body;
  for (const DocumentSection& section : document.sections) body += section_of(section);
  return fmt::format(
      "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<title>{0}</title><style>{1}</style></head>\n<body><main><h1>{0}</h1><p class=\"subtitle\">{2}</p>\n"
      "<p class=\"verdict {3}\">{4}</p>\n{5}{6}</main></body></html>\n",
      escape_xml(document.title), kStyle, escape_xml(document.subtitle), class_of(document.verdict),
      escape_xml(document.verdict_in_words), links_of(document.sections), body);
}

}  // namespace keyblock::report
