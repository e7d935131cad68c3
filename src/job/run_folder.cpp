// Writes the results of one run.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "job/run_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <nlohmann/json.hpp>
#include <numeric>
#include <optional>
#include <string_view>

#include "base/error.hpp"
#include "base/sha256.hpp"
#include "formats/dxf/dxf_writer.hpp"
#include "formats/registry.hpp"
#include "formats/tables/run_tables.hpp"
#include "formats/text/contact_csv.hpp"
#include "formats/text/csv.hpp"
#include "formats/text/tips_csv.hpp"
#include "formats/views/vtk.hpp"
#include "formats/views/vtk_parts.hpp"
#include "job/run_report.hpp"
#include "problem/units/measure.hpp"
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
constexpr const char* kReactionFile = "reactions.svg";
// The list is written whole each time: of many frames not with each.
constexpr std::chrono::milliseconds kListEvery{500};

// What a run may leave in its folder, beside its tables, and all that it may leave.
constexpr std::array<std::string_view, 10> kOtherFiles{kRecord,      kFrameList,    "picture.svg", "energy.svg",
                                                       "field.svg",  "plastic.svg", kReactionFile, "cracks.svg",
                                                       "cracks.dxf", kCheckpoint};
// What is written as the run goes: a run that was killed leaves it without a record.
constexpr std::array<const formats::RunTable*, 7> kGrowing{
    &formats::kContactsTable, &formats::kJointsTable, &formats::kBoltsTable, &formats::kHistoryTable,
    &formats::kPointsTable,   &formats::kStepTable,   &formats::kLedgerTable};

std::vector<std::string> growing_files() {
  std::vector<std::string> files{kFrameList};
  for (const formats::RunTable* table : kGrowing) files.emplace_back(table->file);
  return files;
}

std::vector<std::string> all_files() {
  std::vector<std::string> files(kOtherFiles.begin(), kOtherFiles.end());
  for (const formats::RunTable* table : formats::run_tables())
    if (table->file != kFrameFolder) files.emplace_back(table->file);
  return files;
}

constexpr std::size_t kMostCurves = 6;  // more cannot be told apart in one chart

bool is_in(const HistoryRow& row, std::size_t point) {
  return point < row.points.size() && is_there(row.points[point]);
}

// What the rows of a history hold: measured points, blocks, or the elements of bodies, whose displacements are weighed
// to the bodies'.
struct Followed {
  const char* word;
  std::vector<std::vector<std::pair<std::size_t, double>>> parts;  ///< of each: points of a row with their shares
};

Followed followed_by(const History& history, const Frame& start, const FieldFrame& field) {
  Followed followed{history.of_measured_points ? "measured point" : "block", {}};
  const std::size_t count = history.rows.front().points.size();
  const bool are_blocks = field.elements.size() != count || body_count(field) == count;
  if (history.of_measured_points || are_blocks) {
    for (std::size_t i = 0; i < count; ++i) followed.parts.push_back({{i, 1.0}});
    return followed;
  }
  followed.word = "body";
  std::vector<double> masses;
  for (std::size_t e = 0; e < count; ++e) {
    const auto body = static_cast<std::size_t>(field.elements[e].body);
    followed.parts.resize(std::max(followed.parts.size(), body + 1));
    masses.resize(followed.parts.size());
    followed.parts[body].emplace_back(e, start.elements[e].mass);
    masses[body] += start.elements[e].mass;
  }
  for (std::size_t body = 0; body < masses.size(); ++body)
    for (auto& [element, share] : followed.parts[body]) share /= masses[body];
  return followed;
}

/// Of some of what a history follows the displacement in a row; none where it is not there.
std::optional<double> displacement_of(const HistoryRow& row, const std::vector<std::pair<std::size_t, double>>& parts) {
  Point mean;
  for (const auto& [point, share] : parts) {
    if (!is_in(row, point)) return std::nullopt;
    mean = mean + share * row.points[point].displacement;
  }
  return length(mean);
}

// All of few; of many those that came farthest, the first of them first.
std::vector<std::size_t> shown_of(const History& history, const Followed& followed) {
  std::vector<double> farthest;
  for (const auto& parts : followed.parts) {
    double& most = farthest.emplace_back(0);
    for (const HistoryRow& row : history.rows) most = std::max(most, displacement_of(row, parts).value_or(0));
  }
  std::vector<std::size_t> shown(followed.parts.size());
  std::iota(shown.begin(), shown.end(), 0U);
  if (shown.size() <= kMostCurves) return shown;
  std::ranges::stable_sort(shown, std::ranges::greater(), [&](std::size_t i) { return farthest[i]; });
  shown.resize(kMostCurves);
  return shown;
}

// Layer JOINT_2 has those that started in shear, JOINT_1 all others.
std::string dxf_of(const std::vector<CrackFrame>& cracks, const Units& units) {
  formats::Content content;
  content.units = units;
  Drawing& drawing = content.drawing.emplace();
  for (const CrackFrame& crack : cracks)
    for (std::size_t i = 0; i + 1 < crack.along.size(); ++i)
      drawing.joints.push_back({{crack.along[i], crack.along[i + 1]}, crack.is_shear ? 1 : 0, {}});
  return formats::write_dxf(content);
}

// How far each of them has come, over time.
std::vector<report::Curve> displacement_curves(const History& history, const Frame& start, const FieldFrame& field) {
  std::vector<report::Curve> curves;
  if (history.rows.empty()) return curves;
  const Followed followed = followed_by(history, start, field);
  const std::vector<std::size_t> shown = shown_of(history, followed);
  for (const std::size_t i : shown) {
    report::Curve curve;
    const bool is_last_of_more = i == shown.back() && followed.parts.size() > shown.size();
    curve.label =
        fmt::format("{} {}{}", followed.word, i + 1,
                    is_last_of_more ? fmt::format(" (of {}: those that move most)", followed.parts.size()) : "");
    for (const HistoryRow& row : history.rows)
      if (const std::optional<double> way = displacement_of(row, followed.parts[i])) {
        curve.x.push_back(row.time);
        curve.y.push_back(*way);
      }
    curves.push_back(std::move(curve));
  }
  return curves;
}

}  // namespace

RunFolder::RunFolder(fs::path folder, Overwrite overwrite, Trace trace, Units units)
    : folder_(std::move(folder)),
      units_(std::move(units)),
      contacts_(folder_ / formats::kContactsTable.file, formats::contacts_csv_header(units_)),
      joints_(folder_ / formats::kJointsTable.file, formats::joints_csv_header(units_)),
      bolts_(folder_ / formats::kBoltsTable.file, formats::bolts_csv_header(units_)),
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
  for (const std::string& name : all_files()) require_free(folder_ / name, overwrite_);
  require_free(folder_ / kFrameFolder, overwrite_);
}

RunFolder::RunFolder(fs::path folder, Trace trace, Units units)
    : RunFolder(std::move(folder), Overwrite::yes, trace, std::move(units)) {
  lock_ = FolderLock(folder_);
}

namespace {

/// Files of a frame, by the opening of their names and their endings; each is a part of its own for viewers.
struct FramePart {
  std::string_view opening;
  std::string_view ending;
};
constexpr std::array<FramePart, 4> kParts{
    {{"", ".vtu"}, {"contacts_", ".vtp"}, {"bolts_", ".vtp"}, {"cracks_", ".vtp"}}};

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
    if (fs::is_regular_file(folder_ / kCheckpoint))
      for (const std::string& name : growing_files()) names.insert(name);
    return names;
  }
  const auto record = nlohmann::json::parse(formats::load((folder_ / kRecord).string()).text, nullptr, false);
  if (!record.is_object() || !record.contains("outputs")) return names;
  const std::vector<std::string> files = all_files();
  for (const auto& name : record.at("outputs"))
    if (name.is_string() && std::ranges::find(files, name.get<std::string>()) != files.end()) names.insert(name);
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
  for (const std::string& name : growing_files()) fs::remove(folder_ / name, error);
  fs::remove(checkpoint_in(folder_), error);
  fs::remove(folder_ / kFrameFolder, error);  // unless something else lies there
  if (made_folder_) fs::remove(folder_, error);
}

void RunFolder::drop_what_followed() {
  std::error_code error;
  fs::remove(folder_ / kRecord, error);  // where it stands the run is over; the other results are written again
  std::set<fs::path> kept;
  for (const FrameFile& file : frame_files_) kept.insert(folder_ / file.name);
  remove_frames(folder_ / kFrameFolder, kept);
  remove_drafts(folder_);
  fs::create_directory(folder_ / kFrameFolder, error);
  for (GrowingTable* table : {&contacts_, &joints_, &bolts_}) table->keep_steps(framed_steps());
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
  for (const GrowingTable* table : {&contacts_, &joints_, &bolts_}) table->flush();
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

void RunFolder::write(std::string_view file, const std::string& text) {
  const std::string name(file);
  write_file(folder_ / name, text, own_.contains(name) ? Overwrite::yes : overwrite_);
  own_.insert(name);
  if (std::ranges::find(outputs_, name) == outputs_.end()) outputs_.push_back(name);
}

void RunFolder::write_frame(const std::string& name, double time, const std::string& text) {
  write_file(folder_ / name, text);
  frame_files_.push_back({time, name, sha256(text)});
}

void RunFolder::add(const Frame& frame, const FieldFrame& field, const ContactFrames& contacts) {
  const auto& [blocks, points, lines, cracks] = kParts;
  write_frame(frame_file(blocks, frame.step), frame.time, formats::vtu(frame, field, units_));
  if (!contacts.empty())
    write_frame(frame_file(points, frame.step), frame.time, formats::contacts_vtp(frame.time, contacts, units_));
  if (!frame.bolts.empty()) write_frame(frame_file(lines, frame.step), frame.time, formats::bolts_vtp(frame, units_));
  if (!field.cracks.empty())
    write_frame(frame_file(cracks, frame.step), frame.time, formats::cracks_vtp(field, units_));
  contacts_.append(formats::contacts_csv_rows(frame.step, frame.time, contacts));
  joints_.append(formats::joints_csv_rows(frame.step, frame.time, contacts));
  bolts_.append(formats::bolts_csv_rows(frame));
  if (const auto now = std::chrono::steady_clock::now(); now - listed_ > kListEvery) {
    write(kFrameList, list_of_frames());
    listed_ = now;
  }
  if (trace_ == Trace::no && frames_.size() == 2) frames_.pop_back();
  frames_.push_back(frame);
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
  write(formats::kHistoryTable.file, formats::history_csv(tables.history, units_));
  write(formats::kStepTable.file, tables.steps);
  if (!tables.ledger.empty()) write(formats::kLedgerTable.file, tables.ledger);
  if (tables.history.of_measured_points) write(formats::kPointsTable.file, formats::points_csv(tables.history, units_));
}

void RunFolder::write_pictures(const RunResults& results) {
  const auto& [title, tables, steps, ledger, field, is_of_motion, marked, marked_words] = results;
  const History& history = tables.history;
  const std::string at_end =
      fmt::format("{}, time {:g}{}{}", title, field.time, units_.time.empty() ? "" : " ", units_.time);
  write("picture.svg", report::run_picture({title,
                                            frames_.front(),
                                            frames_.back(),
                                            displacement_curves(history, frames_.front(), field),
                                            {with_unit("time", measures::kTime, units_),
                                             with_unit("displacement", measures::kLength, units_)},
                                            units_.time,
                                            marked,
                                            marked_words,
                                            units_}));
  if (!ledger.rows.empty()) write("energy.svg", report::energy_picture(title + ", energy", ledger, units_));
  write("field.svg", report::field_picture({at_end, field, field, frames_.back().measured_points,
                                            report::most_varied(field), is_of_motion, units_}));
  if (field.plastic) write("plastic.svg", report::plastic_picture({at_end, field, frames_.back().outlines, units_}));
  if (const std::vector<ReactionCurve> curves = reaction_curves(history); !curves.empty())
    write(kReactionFile, report::reaction_picture(title + ", reactions", curves, units_));
}

void RunFolder::finish(const RunResults& results) {
  const History& history = results.tables.history;
  outputs_.clear();  // in the same order whatever was written on the way
  write_list_of_frames();
  for (const GrowingTable* table : {&contacts_, &joints_, &bolts_})
    if (table->has_begun()) outputs_.push_back(table->file().filename().string());
  write_tables(results.tables);
  write_pictures(results);
  if (const std::string tips = formats::tips_csv(history, units_); !tips.empty()) {
    write(formats::kTipsTable.file, tips);
    write("cracks.svg",
          report::crack_picture({results.title + ", cracks", frames_.front(), history, results.field, units_}));
  }
  if (!results.field.cracks.empty()) write("cracks.dxf", dxf_of(results.field.cracks, units_));
  if (trace_ == Trace::no) return;
  write(formats::kTraceOfSteps.file, formats::steps_csv(results.steps, units_));
  if (std::ranges::any_of(results.steps, [](const StepReport& step) { return !step.residuals.empty(); }))
    write(formats::kTraceOfRounds.file, formats::rounds_csv(results.steps));
  write(formats::kTraceOfBlocks.file, formats::blocks_csv(frames_, units_));
}

void RunFolder::write_record(const std::string& json) {
  write(kRecord, json);
}

fs::path checkpoint_in(const fs::path& folder) {
  return folder / kCheckpoint;
}

}  // namespace keyblock
