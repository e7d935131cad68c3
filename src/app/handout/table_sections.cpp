// Reads tables that run_tables.hpp describes. A table that cannot be read is named in a sentence.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/handout/table_sections.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/bytes/file_bytes.hpp"
#include "base/bytes/sha256.hpp"
#include "base/words/plain_number.hpp"
#include "formats/text/csv.hpp"
#include "problem/units/readable.hpp"

namespace keyblock {
namespace {

namespace fs = std::filesystem;
using formats::csv_column;
using formats::csv_real;
using Json = nlohmann::ordered_json;
using report::DocumentSection;

using Rows = std::vector<std::vector<std::string>>;

constexpr int kDigitsOfLoadFactor = 4;

std::optional<formats::CsvTable> table_of(const fs::path& file) {
  if (!fs::is_regular_file(file)) return std::nullopt;
  return formats::read_csv({file.string(), file_bytes(file.string())});
}

/// Force of a bolt through the run.
struct BoltForces {
  std::string name;
  double at_end = 0;
  double most = 0;
  bool is_broken = false;
};

std::map<int, BoltForces> forces_in(const formats::CsvTable& table) {
  const std::size_t bolt = csv_column(table, "bolt"), force = csv_column(table, "force"),
                    broken = csv_column(table, "is_broken"), name = csv_column(table, "name");
  std::map<int, BoltForces> bolts;
  for (const formats::CsvRow& row : table.rows) {
    BoltForces& own = bolts[static_cast<int>(csv_real(table, row, bolt))];
    own.name = row.cells[name];
    own.at_end = csv_real(table, row, force);
    if (std::abs(own.at_end) > std::abs(own.most)) own.most = own.at_end;
    own.is_broken = !row.cells[broken].empty() && row.cells[broken] != "0";
  }
  return bolts;
}

/// Contacts of one joint material.
struct JointContacts {
  int all = 0, closed = 0, sliding = 0;
  double most_normal = 0, most_shear = 0;
};

std::map<int, JointContacts> contacts_in(const formats::CsvTable& table) {
  const std::size_t step = csv_column(table, "step"), joint = csv_column(table, "joint_material"),
                    state = csv_column(table, "state"), normal = csv_column(table, "normal_force"),
                    shear = csv_column(table, "shear_force");
  std::map<int, JointContacts> joints;
  for (auto row = table.rows.rbegin(); row != table.rows.rend(); ++row) {
    if (row->cells[step] != table.rows.back().cells[step]) break;
    JointContacts& own = joints[static_cast<int>(csv_real(table, *row, joint))];
    ++own.all;
    own.closed += row->cells[state] == "open" ? 0 : 1;
    own.sliding += row->cells[state] == "slide" ? 1 : 0;
    own.most_normal = std::max(own.most_normal, std::abs(csv_real(table, *row, normal)));
    own.most_shear = std::max(own.most_shear, std::abs(csv_real(table, *row, shear)));
  }
  return joints;
}

/// Makes the section, or one that says why it cannot be made.
template <class Make>
DocumentSection made(const std::string& heading, Make make) {
  try {
    return make();
  } catch (const std::exception& error) {
    return {heading, {fmt::format("Not listed: {}", error.what())}};
  }
}

std::string name_of(const Json& names, int number) {
  if (names.is_array() && number >= 1 && static_cast<std::size_t>(number) <= names.size())
    if (const std::string name = plain_text(names[static_cast<std::size_t>(number) - 1]); !name.empty()) return name;
  return fmt::format("{}", number);
}

}  // namespace

DocumentSection bolt_section(const fs::path& folder, const RunRecordFile& record) {
  return made("Bolts", [&]() -> DocumentSection {
    const auto table = table_of(folder / "bolts.csv");
    Rows rows;
    if (table)
      for (const auto& [number, bolt] : forces_in(*table))
        rows.push_back({bolt.name.empty() ? fmt::format("{}", number) : bolt.name, bolt.is_broken ? "broken" : "holds",
                        readable(bolt.at_end, measures::kForce, record.units()),
                        readable(bolt.most, measures::kForce, record.units())});
    return {"Bolts",
            rows.empty() ? std::vector<std::string>() : std::vector<std::string>{"Tension is positive."},
            {},
            {{{"bolt", "state", "force at the end", "largest recorded force"}, rows}}};
  });
}

DocumentSection contact_section(const fs::path& folder, const RunRecordFile& record) {
  return made("Contacts", [&]() -> DocumentSection {
    const auto table = table_of(folder / "contacts.csv");
    Rows rows;
    if (table && !table->rows.empty())
      for (const auto& [number, joint] : contacts_in(*table))
        rows.push_back({name_of(record.at("names.joints"), number), fmt::format("{}", joint.all),
                        fmt::format("{}", joint.closed), fmt::format("{}", joint.sliding),
                        readable(joint.most_normal, measures::kForce, record.units()),
                        readable(joint.most_shear, measures::kForce, record.units())});
    DocumentSection section{"Contacts", {}, {}, {}};
    if (rows.empty()) return section;
    section.paragraphs.push_back(fmt::format("Contacts by joint material in the last recorded frame, step {}.",
                                             table->rows.back().cells[csv_column(*table, "step")]));
    section.tables.push_back(
        {{"joint", "contacts", "closed", "sliding", "largest normal force", "largest shear force"}, rows});
    return section;
  });
}

DocumentSection crack_section(const fs::path& folder, const RunRecordFile& record) {
  return made("Cracks", [&]() -> DocumentSection {
    const auto table = table_of(folder / "tips.csv");
    DocumentSection section{"Cracks", {}, {}, {}};
    if (!table || table->rows.empty()) return section;
    const auto cell = [&](const formats::CsvRow& row, const char* name) { return row.cells[csv_column(*table, name)]; };
    const auto number = [&](const formats::CsvRow& row, const char* name, const Measure& measure) {
      return readable(csv_real(*table, row, csv_column(*table, name)), measure, record.units());
    };
    const std::string last = cell(table->rows.back(), "step");
    Rows rows;
    for (const formats::CsvRow& row : table->rows)
      if (cell(row, "step") == last)
        rows.push_back({cell(row, "crack"), number(row, "x", measures::kLength), number(row, "y", measures::kLength),
                        number(row, "length", measures::kLength), number(row, "K_I", measures::kToughness),
                        number(row, "K_II", measures::kToughness), number(row, "toughness", measures::kToughness)});
    const double factor = csv_real(*table, table->rows.back(), csv_column(*table, "load_factor"));
    section.paragraphs.push_back(fmt::format("Crack tips at step {}, under {} times the loads of the case.", last,
                                             plain(factor, kDigitsOfLoadFactor)));
    section.tables.push_back({{"crack", "tip x", "tip y", "length", "K_I", "K_II", "toughness"}, rows});
    return section;
  });
}

DocumentSection checksum_section(const fs::path& folder, const ResultRecord& record) {
  Rows rows;
  for (const Json& input : record.list("inputs"))
    rows.push_back({plain_text(member(input, "file")), fmt::format("input, {}", plain_text(member(input, "format"))),
                    plain_text(member(input, "sha256"))});
  for (const Json& output : record.list("outputs")) {
    const fs::path name = plain_text(output);
    if (name.empty() || name.has_parent_path() || !fs::is_regular_file(folder / name)) continue;
    rows.push_back({name.string(), "result", sha256(file_bytes((folder / name).string()))});
  }
  return {"Checksums", {}, {}, {{{"file", "kind", "SHA-256"}, rows}}};
}

}  // namespace keyblock
