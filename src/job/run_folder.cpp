// Writes the results of one run.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "job/run_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>
#include <numeric>
#include <optional>
#include <string_view>

#include "base/error.hpp"
#include "base/sha256.hpp"
#include "formats/registry.hpp"
#include "formats/text/contact_csv.hpp"
#include "formats/text/csv.hpp"
#include "formats/text/tips_csv.hpp"
#include "formats/views/vtk.hpp"
#include "formats/views/vtk_parts.hpp"
#include "job/curves/most_moved.hpp"
#include "job/declared_units.hpp"
#include "job/run_report.hpp"
#include "report/energy_picture.hpp"
#include "report/field_picture.hpp"
#include "report/reaction_picture.hpp"
#include "report/rock/crack_picture.hpp"
#include "report/rock/plastic_picture.hpp"
#include "report/run_picture.hpp"
#include "result/describe.hpp"
#include "result/reaction_curve.hpp"

namespace keyblock {

namespace fs = std::filesystem;

namespace {

constexpr const char* kRecord = "run.json";
constexpr const char* kFrameFolder = "frames";
constexpr const char* kCheckpoint = "checkpoint.h5";
constexpr const char* kFrameList = "fields.pvd";
constexpr const char* kHistories = "histories.csv";
// The list is written whole each time: of many frames not with each.
constexpr std::chrono::milliseconds kListEvery{500};

// Rows of histories are written in lots.
constexpr std::size_t kLotOfRows = 1 << 16;

// The files that a run may leave in its folder, and all that it may leave.
constexpr std::array<std::string_view, 22> kFiles{
    kStepTable,   kLedgerTable, kRecord,       "history.csv",    kFrameList,   "picture.svg",
    "energy.svg", "field.svg",  "plastic.svg", "steps.csv",      "blocks.csv", "reactions.svg",
    "points.csv", "rounds.csv", kCheckpoint,   "contacts.csv",   "joints.csv", "bolts.csv",
    "tips.csv",   "cracks.svg", kHistories,    "joint_lines.csv"};
// Of those, what is written as the run goes: a run that was killed leaves them without a record.
constexpr std::array<std::string_view, 10> kGrowing{kFrameList,    "contacts.csv",   "joints.csv", "bolts.csv",
                                                    "history.csv", "points.csv",     kStepTable,   kLedgerTable,
                                                    kHistories,    "joint_lines.csv"};

}  // namespace

RunFolder::RunFolder(fs::path folder, Overwrite overwrite, Trace trace)
    : folder_(std::move(folder)),
      contacts_(folder_ / "contacts.csv", formats::contacts_csv_header()),
      joints_(folder_ / "joints.csv", formats::joints_csv_header()),
      joint_lines_(folder_ / "joint_lines.csv", formats::joint_lines_csv_header()),
      bolts_(folder_ / "bolts.csv", formats::bolts_csv_header()),
      histories_(folder_ / kHistories, Followed::header()),
      trace_(trace),
      overwrite_(overwrite) {
  if (fs::exists(folder_) && !fs::is_directory(folder_))
    throw UsageError(fmt::format("{} is a file, not a folder", folder_.string()));
  require_names_free();
  // A link to a folder is no folder of this run: what lies behind it is the user's.
  if (const fs::path frames = folder_ / kFrameFolder;
      fs::exists(fs::symlink_status(frames)) && !fs::is_directory(fs::symlink_status(frames)))
    throw UsageError(fmt::format("{} is a file or a link, not a folder", frames.string()));
}

void RunFolder::require_names_free() const {
  for (const std::string_view name : kFiles) require_free(folder_ / name, overwrite_);
  require_free(folder_ / kFrameFolder, overwrite_);
}

RunFolder::RunFolder(fs::path folder, Trace trace) : RunFolder(std::move(folder), Overwrite::yes, trace) {
  lock_ = FolderLock(folder_);
}

namespace {

/// Files of a frame, by the opening of their names and their endings; each is a part of its own for viewers.
struct FramePart {
  std::string_view opening;
  std::string_view ending;
};
constexpr std::array<FramePart, 3> kParts{{{"", ".vtu"}, {"contacts_", ".vtp"}, {"bolts_", ".vtp"}}};

std::string frame_file(const FramePart& part, int step) {
  return fmt::format("{}/{}{:08}{}", kFrameFolder, part.opening, step, part.ending);
}

bool is_of(const FramePart& part, const fs::path& file) {
  const std::string stem = file.stem().string();
  return file.extension() == part.ending && stem.starts_with(part.opening) && stem.size() >= part.opening.size() + 8 &&
         std::ranges::all_of(stem.substr(part.opening.size()), [](char c) { return c >= '0' && c <= '9'; });
}

int part_number(const fs::path& file) {
  const auto part = std::ranges::find_if(kParts, [&](const FramePart& p) { return is_of(p, file); });
  return static_cast<int>(part - kParts.begin());
}

/// As `frame_file` names them; whatever else lies beside them is the user's.
bool is_frame(const fs::directory_entry& entry) {
  return part_number(entry.path()) < static_cast<int>(kParts.size()) && fs::is_regular_file(entry.symlink_status());
}

void remove_frames(const fs::path& folder, const std::set<fs::path>& kept) {
  std::error_code error;
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error))
    if (is_frame(entry) && !kept.contains(entry.path())) files.push_back(entry.path());
  for (const fs::path& file : files) fs::remove(file, error);
  remove_drafts(folder);
}

}  // namespace

// By its record; a run that was killed before it wrote one left its frames and checkpoint alone.
std::set<std::string> RunFolder::written_before() const {
  std::set<std::string> names{kRecord, kCheckpoint};
  if (!fs::is_regular_file(folder_ / kRecord)) {
    if (fs::is_regular_file(folder_ / kCheckpoint)) names.insert(kGrowing.begin(), kGrowing.end());
    return names;
  }
  const auto record = nlohmann::json::parse(formats::load((folder_ / kRecord).string()).text, nullptr, false);
  if (!record.is_object() || !record.contains("outputs")) return names;
  for (const auto& name : record.at("outputs"))
    if (name.is_string() && std::ranges::find(kFiles, name.get<std::string>()) != kFiles.end()) names.insert(name);
  return names;
}

void RunFolder::clear() {
  std::error_code error;
  for (const std::string& name : written_before()) {
    fs::remove(folder_ / name, error);
    if (error) throw UsageError(fmt::format("cannot remove {} of an earlier run", (folder_ / name).string()));
  }
  remove_frames(folder_ / kFrameFolder, {});
  remove_drafts(folder_);
}

// Whatever came to stand there since the folder was looked at is another run's, or the user's.
void RunFolder::begin(const std::string& checkpoint) {
  std::error_code error;
  made_folder_ = fs::create_directories(folder_, error);
  if (error) throw UsageError(fmt::format("cannot make the folder {}", folder_.string()));
  lock_ = FolderLock(folder_);
  if (overwrite_ == Overwrite::yes)
    clear();
  else
    require_names_free();
  if (!checkpoint.empty()) write_durably(checkpoint_in(folder_), checkpoint, Overwrite::no);
  const bool made_frames = fs::create_directory(folder_ / kFrameFolder, error);
  if (error) throw UsageError(fmt::format("cannot make the folder {}", (folder_ / kFrameFolder).string()));
  if (!made_frames && overwrite_ == Overwrite::no)
    throw UsageError(fmt::format("{} holds the frames of another run; give another folder", folder_.string()));
}

void RunFolder::take_back() {
  std::error_code error;
  for (const FrameFile& file : frame_files_) fs::remove(folder_ / file.name, error);
  for (const std::string_view name : kGrowing) fs::remove(folder_ / name, error);
  fs::remove(checkpoint_in(folder_), error);
  fs::remove(folder_ / kFrameFolder, error);  // unless something else lies there
  if (made_folder_) fs::remove(folder_, error);
}

void RunFolder::drop_what_followed(int last_step) {
  std::error_code error;
  fs::remove(folder_ / kRecord, error);  // where it stands the run is over; the other results are written again
  std::set<fs::path> kept;
  for (const FrameFile& file : frame_files_) kept.insert(folder_ / file.name);
  remove_frames(folder_ / kFrameFolder, kept);
  remove_drafts(folder_);
  fs::create_directory(folder_ / kFrameFolder, error);
  for (GrowingTable* table : tables_of_frames()) table->keep_steps(framed_steps());
  histories_.keep_until(last_step);
}

std::set<int> RunFolder::framed_steps() const {
  std::set<int> steps;
  for (const FrameFile& file : frame_files_)
    if (is_of(kParts.front(), file.name)) steps.insert(std::stoi(fs::path(file.name).stem().string()));
  return steps;
}

void RunFolder::flush_frames() {
  for (; flushed_frames_ < frame_files_.size(); ++flushed_frames_)
    flush_to_disk(folder_ / frame_files_[flushed_frames_].name);
  flush_to_disk(folder_ / kFrameFolder);
  for (const GrowingTable* table : tables_of_frames()) table->flush();
  flush_histories();
  histories_.flush();
}

void RunFolder::write_checkpoint(const std::string& bytes) {
  flush_frames();
  write_durably(checkpoint_in(folder_), bytes, Overwrite::yes);
}

void RunFolder::remove_checkpoint() {
  if (!fs::exists(checkpoint_in(folder_))) return;
  flush_frames();
  for (const std::string& name : outputs_) flush_to_disk(folder_ / name);
  flush_to_disk(folder_);
  fs::remove(checkpoint_in(folder_));
}

void RunFolder::describe(Archive& archive) {
  archive.list("files", frame_files_, [&](FrameFile& file) {
    archive.value("time", file.time);
    archive.value("name", file.name);
    archive.value("sha256", file.sha256);
  });
  archive.list("frames", frames_, [&](Frame& frame) { keyblock::describe(archive, frame); });
  archive.value("framed", framed_);
  archive.value("thinned_every", thinned_every_);
  archive.value("expected_rows", expected_rows_);
  if (!archive.is_restoring()) return;
  flushed_frames_ = frame_files_.size();
  if (frames_.empty()) archive.refuse("frames", "expected the first frame, found none");
  for (const FrameFile& file : frame_files_) {
    if (!fs::is_regular_file(folder_ / file.name))
      archive.refuse(file.name, "expected every frame written so far, found one gone");
    if (sha256(formats::load((folder_ / file.name).string()).text) != file.sha256)
      archive.refuse(file.name, "expected every frame as it was written, found one changed");
  }
}

void RunFolder::write(const std::string& name, const std::string& plain) {
  const std::string text = name.ends_with(".csv")   ? table_in_units(plain, units_)
                           : name.ends_with(".svg") ? picture_in_units(plain, units_)
                                                    : plain;
  write_file(folder_ / name, text, own_.contains(name) ? Overwrite::yes : overwrite_);
  own_.insert(name);
  if (std::ranges::find(outputs_, name) == outputs_.end()) outputs_.push_back(name);
}

void RunFolder::write_frame(const std::string& name, double time, const std::string& text) {
  write_file(folder_ / name, text);
  frame_files_.push_back({time, name, sha256(text)});
}

void RunFolder::add(const Frame& frame, const FieldFrame& field, const ContactFrames& contacts) {
  const auto& [blocks, points, lines] = kParts;
  write_frame(frame_file(blocks, frame.step), frame.time, formats::vtu(frame, field));
  const ContactTables which = contact_output_.which;
  if (which != ContactTables::none && framed_ % contact_output_.every == 0) {
    ContactFrames shown = contacts;
    if (which == ContactTables::chosen)
      std::erase_if(shown, [&](const ContactFrame& c) { return !contact_output_.is_chosen(c); });
    if (!shown.empty())
      write_frame(frame_file(points, frame.step), frame.time, formats::contacts_vtp(frame.time, shown));
    add_tables_of_contacts(frame, shown, contacts);
  }
  if (!frame.bolts.empty()) write_frame(frame_file(lines, frame.step), frame.time, formats::bolts_vtp(frame));
  bolts_.append(formats::bolts_csv_rows(frame));
  ++framed_;
  if (const auto now = std::chrono::steady_clock::now(); now - listed_ > kListEvery) {
    write(kFrameList, list_of_frames());
    listed_ = now;
  }
  if (trace_ == Trace::no && frames_.size() == 2) frames_.pop_back();
  frames_.push_back(frame);
}

// The first frame with contacts says how long the tables would grow.
void RunFolder::add_tables_of_contacts(const Frame& frame, const ContactFrames& shown, const ContactFrames& all) {
  const int every = contact_output_.every;
  if (thinned_every_ == 0 && !shown.empty()) {
    expected_rows_ = static_cast<double>(shown.size()) * ((contact_output_.frames + every - 1) / every);
    const bool is_thinned = contact_output_.which == ContactTables::automatic && expected_rows_ > kMostContactRows;
    thinned_every_ = is_thinned ? static_cast<int>(std::ceil(expected_rows_ / kMostContactRows)) : 1;
  }
  if (framed_ / every % thinned_every() != 0) return;
  contacts_.append(formats::contacts_csv_rows(frame.step, frame.time, shown));
  joints_.append(formats::joints_csv_rows(frame.step, frame.time, all));
  joint_lines_.append(formats::joint_lines_csv_rows(frame.step, frame.time, all));
}

void RunFolder::add_histories(const std::string& rows) {
  history_rows_ += rows;
  if (history_rows_.size() > kLotOfRows) flush_histories();
}

void RunFolder::flush_histories() {
  histories_.append(history_rows_);
  history_rows_.clear();
}

// The list would name what is not there.
void RunFolder::write_list_of_frames() {
  for (const FrameFile& file : frame_files_) {
    if (fs::is_regular_file(folder_ / file.name)) continue;
    std::error_code error;
    if (own_.contains(kFrameList)) fs::remove(folder_ / kFrameList, error);
    throw OutputError(fmt::format("{} was written, and is gone now", (folder_ / file.name).string()));
  }
  write(kFrameList, list_of_frames());
}

std::string RunFolder::list_of_frames() const {
  std::vector<formats::PvdEntry> files;
  for (const FrameFile& file : frame_files_) files.push_back({file.time, part_number(file.name), file.name});
  return formats::pvd(files);
}

void RunFolder::write_tables(const RunTables& tables) {
  write("history.csv", formats::history_csv(tables.history));
  write(kStepTable, tables.steps);
  if (!tables.ledger.empty()) write(kLedgerTable, tables.ledger);
  if (tables.history.of_measured_points) write("points.csv", formats::points_csv(tables.history));
}

void RunFolder::finish(const RunResults& results) {
  const auto& [title, tables, steps, ledger, field, is_of_motion, marked, marked_words, units, follows,
               followed_units] = results;
  const History& history = tables.history;
  units_ = units;
  outputs_.clear();  // in the same order whatever was written on the way
  write_list_of_frames();
  flush_histories();
  if (histories_.has_begun()) outputs_.emplace_back(kHistories);
  for (const GrowingTable* table : tables_of_frames())
    if (table->has_begun()) outputs_.push_back(table->file().filename().string());
  write_tables(tables);
  if (!follows)
    write(kHistories, Followed::header() + most_moved_rows(history, frames_.front(), field, followed_units));
  write("picture.svg", report::run_picture({title,
                                            frames_.front(),
                                            frames_.back(),
                                            displacement_curves(history, frames_.front(), field),
                                            {"time [T]", "displacement [L]"},
                                            "",
                                            marked,
                                            marked_words}));
  if (!ledger.rows.empty()) write("energy.svg", report::energy_picture(title + ", energy", ledger));
  write("field.svg", report::field_picture({fmt::format("{}, time {:g}", title, field.time), field, field,
                                            frames_.back().measured_points, report::most_varied(field), is_of_motion}));
  if (field.plastic)
    write("plastic.svg",
          report::plastic_picture({fmt::format("{}, time {:g}", title, field.time), field, frames_.back().outlines}));
  if (const std::vector<ReactionCurve> curves = reaction_curves(history); !curves.empty())
    write("reactions.svg", report::reaction_picture(title + ", reactions", curves));
  if (const std::string tips = formats::tips_csv(history); !tips.empty()) {
    write("tips.csv", tips);
    write("cracks.svg", report::crack_picture(title + ", cracks", frames_.front(), history));
  }
  if (trace_ == Trace::no) return;
  write("steps.csv", formats::steps_csv(steps));
  if (std::ranges::any_of(steps, [](const StepReport& step) { return !step.residuals.empty(); }))
    write("rounds.csv", formats::rounds_csv(steps));
  write("blocks.csv", formats::blocks_csv(frames_));
}

void RunFolder::write_record(const std::string& json) {
  write(kRecord, json);
}

fs::path checkpoint_in(const fs::path& folder) {
  return folder / kCheckpoint;
}

}  // namespace keyblock
