// Makes a document of the catalogue: a card, a row and a section per job.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/catalogue_page.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "base/counted.hpp"
#include "report/document/document.hpp"

namespace keyblock::report {
namespace {

std::string text_of(const std::optional<int>& number) {
  return number ? fmt::format("{}", *number) : std::string();
}

const std::string& word_of(const CatalogueRow& row) {
  return row.verdict.word.empty() ? row.outcome : row.verdict.word;
}

Verdict verdict_of(const CatalogueRow& row) {
  const std::string& word = word_of(row);
  if (word == "failed") return Verdict::bad;
  return word == "differs" || word == "no equilibrium" ? Verdict::doubtful : Verdict::good;
}

// The reason of the verdict, and the message if it is another.
std::vector<std::string> reasons_of(const CatalogueRow& row) {
  std::vector<std::string> reasons;
  if (!row.verdict.why.empty()) reasons.push_back(row.verdict.why);
  if (!row.message.empty() && row.message != row.verdict.why) {
    const bool has_more = row.warnings > 1;
    reasons.push_back((has_more ? fmt::format("first of {} warnings and notes: ", row.warnings) : "") + row.message);
  }
  return reasons;
}

// Both lists of a row have the same order: an answer, and the folder of its run.
std::vector<DocumentLink> links_of(const CatalogueRow& row) {
  std::vector<DocumentLink> links;
  for (std::size_t i = 0; i < std::min(row.answers.size(), row.outputs.size()); ++i) {
    const CatalogueAnswer& answer = row.answers[i];
    const std::string& folder = row.outputs[i];
    if (answer.measures) {
      links.push_back({answer.profile, folder + "/picture.svg", true});
      links.push_back({fmt::format("record of {}", answer.profile), folder + "/run.json"});
    }
    links.push_back({fmt::format("log of {}", answer.profile), folder + ".log"});
  }
  if (row.answers.empty())
    for (const std::string& output : row.outputs) links.push_back({output, output});
  return links;
}

// A verdict that says the outcome needs no second word.
std::string verdict_in_words(const CatalogueRow& row) {
  const bool is_said = row.outcome == row.verdict.word || row.outcome == "ok" || row.outcome.empty();
  if (row.verdict.word.empty()) return row.outcome;
  return is_said ? row.verdict.word : fmt::format("{}, {}", row.verdict.word, row.outcome);
}

std::string anchor_of(std::size_t index) {
  return fmt::format("job-{}", index + 1);
}

DocumentCard card_of(const CatalogueRow& row, std::size_t index) {
  DocumentCard card{row.name, anchor_of(index), row.thumbnail, verdict_of(row), word_of(row), {verdict_in_words(row)}};
  for (const std::string& reason : reasons_of(row)) card.lines.push_back(reason);
  if (!row.scene.empty()) card.lines.push_back(row.scene);
  card.links = links_of(row);
  return card;
}

// Files with their checksums, and what each profile came to.
DocumentSection section_of(const CatalogueRow& row, std::size_t index) {
  DocumentSection section{row.name};
  section.anchor = anchor_of(index);
  if (!row.paired_by.empty()) section.paragraphs.push_back(row.paired_by);
  if (!row.expected.empty()) section.paragraphs.push_back("expected values: " + row.expected);
  DocumentTable answers{{"profile", "answer"}, {}};
  for (const CatalogueAnswer& answer : row.answers) answers.rows.push_back({answer.profile, text_of(answer)});
  if (!answers.rows.empty()) section.tables.push_back(std::move(answers));
  DocumentTable files{{"file", "format", "SHA-256"}, {}};
  for (const CatalogueFile& file : row.files) files.rows.push_back({file.path, file.format, file.sha256});
  if (!files.rows.empty()) section.tables.push_back(std::move(files));
  return section;
}

DocumentTable table_of(const std::vector<CatalogueRow>& rows) {
  DocumentTable table{{"job", "verdict", "why", "scene", "blocks", "elements", "steps", "difference"}, {}};
  for (const CatalogueRow& row : rows)
    table.rows.push_back({row.name, verdict_in_words(row), fmt::format("{}", fmt::join(reasons_of(row), "; ")),
                          row.scene, text_of(row.blocks), text_of(row.elements), text_of(row.steps),
                          row.difference ? fmt::format("{:.6g}", *row.difference) : std::string()});
  return table;
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
  for (const CatalogueRow& row : rows) ++counts[word_of(row)];
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
  Document document{title, "", Verdict::good, summary_of(rows) + ".", {}};
  document.sections.push_back({"All jobs", {}, {}, {table_of(rows)}});
  for (std::size_t i = 0; i < rows.size(); ++i) {
    document.verdict = std::max(document.verdict, verdict_of(rows[i]));
    // The table names what is no case: a card would be empty.
    if (word_of(rows[i]) != "listed") document.cards.push_back(card_of(rows[i], i));
    document.sections.push_back(section_of(rows[i], i));
  }
  document.subtitle = fmt::format("{} on cards, {} in the table below", counted(document.cards.size(), "case"),
                                  counted(rows.size(), "job"));
  return document_page(document);
}

}  // namespace keyblock::report
