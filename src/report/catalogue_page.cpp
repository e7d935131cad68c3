// Writes the page: a style, a table, and the few lines of script that sort and sift it.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/catalogue_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "report/drawing/svg.hpp"

namespace keyblock::report {
namespace {

constexpr std::string_view kStyle = R"(
body { font: 14px/1.4 "DejaVu Sans", Helvetica, Arial, sans-serif; margin: 1.5em; color: #222 }
table { border-collapse: collapse; table-layout: fixed; width: 100% }
th, td { border-bottom: 1px solid #ddd; padding: 4px 6px; text-align: left; vertical-align: top }
td { overflow-wrap: anywhere }
td small { color: #666 }
th { background: #f4f4f4; cursor: pointer; position: sticky; top: 0 }
td.number { text-align: right; font-variant-numeric: tabular-nums }
svg { display: block }
img { display: block; width: 160px; border: 1px solid #ddd }
tr.failed td.verdict { color: #b03060; font-weight: bold }
tr.differs td.verdict, tr.no-equilibrium td.verdict { color: #a06000; font-weight: bold }
tr.ran td.verdict { color: #206030 }
tr.listed { color: #777 }
)";

// Fits the window; texts share the width that pictures and numbers leave.
constexpr std::string_view kColumns =
    "<colgroup><col style=\"width: 174px\"><col><col style=\"width: 6em\"><col><col>"
    "<col style=\"width: 5em\"><col style=\"width: 6em\"><col style=\"width: 4em\"><col>"
    "<col style=\"width: 7em\"></colgroup>";

// Numbers sort as numbers, everything else as text; a second click reverses the order.
constexpr std::string_view kScript = R"(
const body = document.querySelector("tbody");
const sift = document.querySelector("#sift");
const value = (row, column) => row.cells[column].dataset.value ?? row.cells[column].textContent;
document.querySelectorAll("th").forEach((heading, column) => heading.onclick = () => {
  const turn = heading.dataset.turn = heading.dataset.turn === "1" ? -1 : 1;
  const compare = (a, b) => {
    const x = value(a, column), y = value(b, column);
    return turn * (x !== "" && y !== "" && !isNaN(x) && !isNaN(y) ? x - y : x < y ? -1 : x > y ? 1 : 0);
  };
  body.append(...[...body.rows].sort(compare));
});
sift.oninput = () => {
  for (const row of body.rows) row.hidden = !row.textContent.toLowerCase().includes(sift.value.toLowerCase());
};
)";

std::string number_cell(std::optional<int> number) {
  return fmt::format("<td class=\"number\">{}</td>", number ? fmt::format("{}", *number) : "");
}

// Writes the files of a job with their formats, and why they form one case.
std::string job_cell(const CatalogueRow& row) {
  std::string text;
  for (const CatalogueFile& file : row.files) {
    const std::string format = file.format.empty() ? "" : fmt::format(" [{}]", escape_xml(file.format));
    const std::string path = file.path == row.name ? "" : escape_xml(file.path);  // the name is said already
    if (!path.empty() || !format.empty())
      text += fmt::format("<br><span title=\"SHA-256 {}\">{}{}</span>", file.sha256, path, format);
  }
  if (!row.paired_by.empty()) text += fmt::format("<br>{}", escape_xml(row.paired_by));
  return fmt::format("<td data-value=\"{0}\">{0}<small>{1}</small></td>", escape_xml(row.name), text);
}

std::string verdict_cell(const CatalogueRow& row) {
  const bool is_said = row.outcome == row.verdict.word || row.outcome == "ok";
  return fmt::format("<td class=\"verdict\" data-value=\"{0}\">{0}<small class=\"outcome\">{1}</small></td>",
                     row.verdict.word, is_said ? "" : fmt::format("<br>{}", row.outcome));
}

// The verdict's reason, and the message where that is another.
std::string why_cell(const CatalogueRow& row) {
  std::string text = escape_xml(row.verdict.why);
  if (!row.message.empty() && row.message != row.verdict.why) {
    const std::string first = row.warnings > 1 ? fmt::format("first of {} warnings: ", row.warnings) : std::string();
    text += fmt::format("{}<small>{}{}</small>", text.empty() ? "" : "<br>", first, escape_xml(row.message));
  }
  return fmt::format("<td>{}</td>", text);
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

bool has_results(const CatalogueAnswer& answer) {
  return answer.measures.has_value();
}

// Links each answer to the folder of its run; both lists have the same order.
std::string answers_cell(const CatalogueRow& row) {
  std::string text;
  for (std::size_t i = 0; i < row.answers.size(); ++i) {
    const CatalogueAnswer& answer = row.answers[i];
    std::string name = escape_xml(answer.profile);
    if (i < row.outputs.size()) {
      const std::string url = url_of(row.outputs[i]);
      name = has_results(answer) ? fmt::format(
                                       "<a href=\"{0}/picture.svg\">{1}</a> (<a href=\"{0}/run.json\">record</a>, "
                                       "<a href=\"{0}.log\">log</a>)",
                                       url, name)
                                 : fmt::format("{1} (<a href=\"{0}.log\">log</a>)", url, name);
    }
    text += fmt::format("{}{}: {}", text.empty() ? "" : "<br>", name, escape_xml(text_of(answer)));
  }
  if (!row.expected.empty()) text += fmt::format("<br>expected values: {}", escape_xml(row.expected));
  if (row.answers.empty())
    for (const std::string& output : row.outputs)
      text += fmt::format("{}<a href=\"{}\">{}</a>", text.empty() ? "" : "<br>", url_of(output), escape_xml(output));
  return fmt::format("<td>{}</td>", text);
}

// The start, and the end of each run.
std::string pictures_cell(const CatalogueRow& row) {
  std::string text = row.thumbnail;
  for (std::size_t i = 0; i < std::min(row.answers.size(), row.outputs.size()); ++i)
    if (has_results(row.answers[i]))
      text += fmt::format("<a href=\"{0}/picture.svg\"><img loading=\"lazy\" src=\"{0}/picture.svg\" alt=\"{1}\"></a>",
                          url_of(row.outputs[i]), escape_xml(row.answers[i].profile));
  return text;
}

std::string class_of(std::string verdict) {
  std::ranges::replace(verdict, ' ', '-');
  return verdict;
}

std::string row_of(const CatalogueRow& row) {
  return fmt::format("<tr class=\"{}\"><td>{}</td>{}{}{}<td>{}</td>{}{}{}{}<td class=\"number\">{}</td></tr>\n",
                     class_of(row.verdict.word), pictures_cell(row), job_cell(row), verdict_cell(row), why_cell(row),
                     escape_xml(row.scene), number_cell(row.blocks), number_cell(row.elements), number_cell(row.steps),
                     answers_cell(row), row.difference ? fmt::format("{:.6g}", *row.difference) : "");
}

}  // namespace

std::string CatalogueRow::formats() const {
  std::string text;
  for (const CatalogueFile& file : files)
    if (!file.format.empty()) text += (text.empty() ? "" : " + ") + file.format;
  return text;
}

std::string text_of(const CatalogueMeasures& measures) {
  std::string text =
      fmt::format("at most {:.4g} anywhere, principal stress {:.4g} to {:.4g}, {}", measures.displacement,
                  measures.least_stress, measures.greatest_stress,
                  measures.contacts > 0 ? fmt::format("{} contacts or fewer", measures.contacts) : "no contact");
  if (!measures.is_static) return text;
  return text + (measures.equilibrium_share
                     ? fmt::format(", about {:.3g} % of the way to equilibrium", 100 * *measures.equilibrium_share)
                     : ", no sign of an equilibrium");
}

std::string text_of(const CatalogueAnswer& answer) {
  const std::string measures = answer.measures ? text_of(*answer.measures) + "; " : "";
  const std::string end = fmt::format("{}{}, {} steps{}", measures, answer.end, answer.steps,
                                      answer.doubt.empty() ? "" : ", unreliable: " + answer.doubt);
  if (answer.of_what.empty()) return end;
  return fmt::format("{} moved by ({:.6g}, {:.6g}), {:.6g}, at time {:.6g}; {}", answer.of_what, answer.dx, answer.dy,
                     std::hypot(answer.dx, answer.dy), answer.time, end);
}

std::string summary_of(const std::vector<CatalogueRow>& rows) {
  std::map<std::string, int> counts;
  for (const CatalogueRow& row : rows) ++counts[row.verdict.word.empty() ? row.outcome : row.verdict.word];
  std::string text = fmt::format("{} job{}", rows.size(), rows.size() == 1 ? "" : "s");
  for (const auto& [word, count] : counts)
    text += fmt::format("{} {} {} ({:.0f} %)", text.find(':') == std::string::npos ? ":" : ",", count,
                        word == "no equilibrium"         ? "without equilibrium"
                        : word == "differs" && count > 1 ? "differ"
                                                         : word,
                        100.0 * count / double(rows.size()));
  return text;
}

std::string catalogue_page(const std::string& title, const std::vector<CatalogueRow>& rows) {
  std::string body;
  for (const CatalogueRow& row : rows) body += row_of(row);
  return fmt::format(
      "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>{0}</title><style>{1}</style></head>\n"
      "<body><h1>{0}</h1><p>{2}. A click on a heading sorts; rows with "
      "<input id=\"sift\" placeholder=\"any text\"> only.</p>\n"
      "<table>{5}<thead><tr><th></th><th>job</th><th>verdict</th><th>why</th><th>scene</th><th>blocks</th>"
      "<th>elements</th><th>steps</th><th>answers</th><th>difference</th></tr></thead>\n"
      "<tbody>\n{3}</tbody></table>\n<script>{4}</script></body></html>\n",
      escape_xml(title), kStyle, summary_of(rows), body, kScript, kColumns);
}

}  // namespace keyblock::report
