// Writes the document as HTML; document_style.hpp holds its look.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/document/document.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <set>
#include <utility>

#include "base/printable.hpp"
#include "report/document/document_style.hpp"
#include "report/drawing/png.hpp"

namespace keyblock::report {
namespace {

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

// Returns true for a word that may break anywhere, such as a checksum.
bool is_code(const std::string& cell) {
  constexpr std::size_t kLeast = 40;
  return cell.size() >= kLeast && std::ranges::all_of(cell, [](unsigned char c) { return std::isalnum(c) != 0; });
}

std::string_view class_of(const DocumentTable& table, std::size_t column) {
  if (table.rows.empty()) return "";
  if (is_numeric(table, column)) return " class=\"number\"";
  return is_code(table.rows.front()[column]) ? " class=\"code\"" : "";
}

std::string_view class_of(Verdict verdict) {
  return verdict == Verdict::good ? "good" : verdict == Verdict::doubtful ? "doubtful" : "bad";
}

std::string table_of(const DocumentTable& table) {
  std::string text = "<div class=\"scroll\" tabindex=\"0\"><table>";
  if (!std::ranges::all_of(table.columns, &std::string::empty)) {
    text += "<thead><tr>";
    for (std::size_t column = 0; column < table.columns.size(); ++column)
      text += fmt::format("<th scope=\"col\"{}>{}</th>", class_of(table, column), escape_xml(table.columns[column]));
    text += "</tr></thead>";
  }
  text += "<tbody>";
  for (const std::vector<std::string>& row : table.rows) {
    text += "<tr>";
    for (std::size_t column = 0; column < row.size(); ++column)
      text += fmt::format("<td{}>{}</td>", class_of(table, column), escape_xml(row[column]));
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

std::string facts_of(const Document& document) {
  std::string text;
  for (const auto& [name, value] : document.facts)
    if (!value.empty()) text += fmt::format("<div><dt>{}</dt><dd>{}</dd></div>", escape_xml(name), escape_xml(value));
  return text.empty() ? text : "<dl class=\"facts\">" + text + "</dl>\n";
}

/// Returns a path below the page as a link, with characters that a URL excludes as %XX.
std::string url_of(const std::string& path) {
  constexpr std::string_view kPlain = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-._~/";
  std::string url;
  for (const char c : path)
    if (kPlain.find(c) == std::string_view::npos)
      url += fmt::format("%{:02X}", static_cast<unsigned char>(c));
    else
      url += c;
  return url;
}

std::string links_of(const std::vector<DocumentLink>& links) {
  std::string pictures, words;
  for (const DocumentLink& link : links) {
    const std::string url = url_of(link.path), said = escape_xml(link.words);
    if (link.is_picture)
      pictures += fmt::format("<a href=\"{0}\"><img loading=\"lazy\" alt=\"\" src=\"{0}\">{1}</a>", url, said);
    else
      words += fmt::format("<a href=\"{}\">{}</a> ", url, said);
  }
  if (!pictures.empty()) pictures = "<div class=\"ends\">" + pictures + "</div>";
  return words.empty() ? pictures : pictures + "<span class=\"links\">" + words + "</span>";
}

std::string card_of(const DocumentCard& card) {
  std::string text = fmt::format("<li class=\"card {}\" data-state=\"{}\"><a href=\"#{}\">", class_of(card.verdict),
                                 escape_xml(card.state), escape_xml(card.anchor));
  text += card.svg.empty()
              ? "<span class=\"none\">no picture</span>"
              : fmt::format("<img loading=\"lazy\" alt=\"\" src=\"data:image/svg+xml;base64,{}\">", base64(card.svg));
  text += fmt::format("<b>{}</b></a>", escape_xml(card.title));
  for (const std::string& line : card.lines) text += fmt::format("<span>{}</span>", escape_xml(line));
  return text + links_of(card.links) + "</li>\n";
}

std::string cards_of(const Document& document) {
  std::set<std::pair<Verdict, std::string>> states;  // good ones first
  for (const DocumentCard& card : document.cards) states.insert({card.verdict, card.state});
  std::string choices;
  for (const auto& [verdict, state] : states) choices += fmt::format("<option>{}</option>\n", escape_xml(state));
  std::string text = fmt::format(kCardFilter, choices);
  text += "<ul class=\"cards\">";
  for (const DocumentCard& card : document.cards) text += card_of(card);
  return text + fmt::format("</ul>\n<script>{}</script>\n", kCardScript);
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
      "<title>{0}</title><style>{1}</style></head>\n<body{7}><main><h1>{0}</h1><p class=\"subtitle\">{2}</p>\n"
      "{8}<p class=\"verdict {3}\">{4}</p>\n{5}{6}</main></body></html>\n",
      escape_xml(document.title), kDocumentStyle, escape_xml(document.subtitle), class_of(document.verdict),
      escape_xml(document.verdict_in_words), document.cards.empty() ? links_of(document.sections) : cards_of(document),
      body, document.cards.empty() ? "" : " class=\"wide\"", facts_of(document));
}

}  // namespace keyblock::report
