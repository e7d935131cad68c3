// Appends rows frame by frame; see frame_tables.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "job/folder/frame_tables.hpp"

#include <cmath>

#include "formats/columns/contact_columns.hpp"
#include "formats/tables/run_tables.hpp"
#include "formats/text/contact_csv.hpp"

namespace keyblock {

FrameTables::FrameTables(const std::filesystem::path& folder, const Units& units)
    : contacts_(folder / formats::kContactsTable.file, formats::contacts_csv_header(units)),
      joints_(folder / formats::kJointsTable.file, formats::joints_csv_header(units)),
      joint_lines_(folder / formats::kJointLinesTable.file, formats::joint_lines_csv_header(units)),
      bolts_(folder / formats::kBoltsTable.file, formats::bolts_csv_header(units)) {}

ContactFrames FrameTables::shown(const ContactFrames& contacts) const {
  if (!is_asked()) return {};
  ContactFrames shown = contacts;
  if (output_.which == ContactTables::chosen)
    std::erase_if(shown, [&](const ContactFrame& c) { return !output_.is_chosen(c); });
  return shown;
}

void FrameTables::append(const Frame& frame, const formats::FrameColumns& columns, const ContactFrames& contacts) {
  if (is_asked()) append_contacts(columns, contacts);
  bolts_.append(formats::bolts_csv_rows(columns, frame.bolts));
  ++framed_;
}

// The first frame with contacts determines the expected length of the tables.
void FrameTables::append_contacts(const formats::FrameColumns& columns, const ContactFrames& contacts) {
  const std::size_t shown = columns.part("contacts").rows;
  const int every = output_.every;
  if (thinned_every_ == 0 && shown > 0) {
    expected_rows_ = static_cast<double>(shown) * ((output_.frames + every - 1) / every);
    const bool is_thinned = output_.which == ContactTables::automatic && expected_rows_ > kMostContactRows;
    thinned_every_ = is_thinned ? static_cast<int>(std::ceil(expected_rows_ / kMostContactRows)) : 1;
  }
  if (framed_ / every % thinned_every() != 0) return;
  contacts_.append(formats::contacts_csv_rows(columns));
  const formats::FramePart all =
      output_.which == ContactTables::chosen ? formats::contact_part(contacts) : columns.part("contacts");
  joints_.append(formats::joints_csv_rows(columns.step, columns.time, all));
  joint_lines_.append(formats::joint_lines_csv_rows(columns.step, columns.time, all));
}

void FrameTables::drop_what_followed() {
  for (GrowingTable* table : all()) table->drop_what_followed();
}

void FrameTables::flush() {
  for (GrowingTable* table : all()) table->flush();
}

Checksums FrameTables::written() {
  Checksums tables;
  for (GrowingTable* table : all()) {
    table->write_waiting();
    if (table->has_begun()) tables.emplace_back(table->file().filename().string(), table->checksum());
  }
  return tables;
}

void FrameTables::describe(Archive& archive) {
  archive.value("framed", framed_);
  archive.value("thinned_every", thinned_every_);
  archive.value("expected_rows", expected_rows_);
  for (GrowingTable* table : all()) archive.group(table->file().filename().string(), [&] { table->describe(archive); });
}

}  // namespace keyblock
