// Writes and reads the lines of the journal.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/batch/batch_journal.hpp"

#include <algorithm>

#include "study/batch/batch_catalogue.hpp"

namespace keyblock::study {
namespace {

using Json = nlohmann::ordered_json;

std::string line_of(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

/// Reads the line into the journal. Returns false if it is not a valid line.
bool take_in(Journal& journal, std::string_view line) {
  const Json json = Json::parse(line, nullptr, false);
  if (!json.is_object()) return false;
  try {
    if (journal.task.empty()) {
      if (!json.contains("batch")) return false;
      journal.task = json.at("task");
    } else {
      report::CatalogueRow row = row_of(json.at("row"));
      journal.rows.insert_or_assign(row.name, std::move(row));
    }
    return true;
  } catch (const Json::exception&) {
    return false;
  }
}

bool are_same(const report::CatalogueFile& a, const report::CatalogueFile& b) {
  return a.path == b.path && a.sha256 == b.sha256;
}

}  // namespace

void Journal::add(std::string_view line) {
  if (take_in(*this, line)) lines += line;
}

const report::CatalogueRow* Journal::find(const std::string& name,
                                          const std::vector<report::CatalogueFile>& files) const {
  const auto found = rows.find(name);
  return found != rows.end() && std::ranges::equal(found->second.files, files, are_same) ? &found->second : nullptr;
}

std::string journal_head(const std::string& task) {
  return line_of({{"batch", 1}, {"task", task}});
}

std::string journal_line(const report::CatalogueRow& row, double seconds) {
  return line_of({{"row", json_of(row)}, {"seconds", seconds}});
}

Journal read_journal(std::string_view text) {
  Journal journal;
  for (std::size_t end = text.find('\n'); end != std::string_view::npos; end = text.find('\n')) {
    journal.add(text.substr(0, end + 1));
    text.remove_prefix(end + 1);
  }
  return journal;
}

}  // namespace keyblock::study
