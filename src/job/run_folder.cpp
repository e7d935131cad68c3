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
#include "formats/dxf/dxf_writer.hpp"
#include "formats/registry.hpp"
#include "formats/text/contact_csv.hpp"
#include "formats/text/csv.hpp"
#include "formats/text/tips_csv.hpp"
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
constexpr const char* kCheckpoint = "checkpoint.h5";
constexpr const char* kFrameList = "fields.pvd";
// The list is written whole each time: of many frames not with each.
constexpr std::chrono::milliseconds kListEvery{500};

// The files that a run may leave in its folder, and all that it may leave.
constexpr std::array<std::string_view, 21> kFiles{
    kStepTable,  kLedgerTable,   kRecord,      "history.csv", kFrameList,      "picture.svg", "energy.svg",
    "field.svg", "plastic.svg",  "steps.csv",  "blocks.csv",  "reactions.svg", "points.csv",  "rounds.csv",
    kCheckpoint, "contacts.csv", "joints.csv", "bolts.csv",   "tips.csv",      "cracks.svg",  "cracks.dxf"};
// Of those, what is written as the run goes: a run that was killed leaves them without a record.
constexpr std::array<std::string_view, 8> kGrowing{kFrameList,    "contacts.csv", "joints.csv", "bolts.csv",
                                                   "history.csv", "points.csv",   kStepTable,   kLedgerTable};

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

RunFolder::RunFolder(fs::path folder, Overwrite overwrite, Trace trace)
    : folder_(std::move(folder)),
      frame_files_(folder_),
      contacts_(folder_ / "contacts.csv", formats::contacts_csv_header()),
      joints_(folder_ / "joints.csv", formats::joints_csv_header()),
      bolts_(folder_ / "bolts.csv", formats::bolts_csv_header()),
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

void RunFolder::flush_frames() {
  frame_files_.flush();
  for (const GrowingTable* table : {&contacts_, &joints_, &bolts_}) table->flush();
}

void RunFolder::describe(Archive& archive) {
  frame_files_.describe(archive);
  archive.list("frames", frames_, [&](Frame& frame) { keyblock::describe(archive, frame); });
  if (!archive.is_restoring()) return;
  if (frames_.empty()) archive.refuse("frames", "expected the first frame, found none");
  frame_files_.require_unchanged(archive);
}

void RunFolder::write_list_of_frames() {
  try {
    frame_files_.require_there();
  } catch (const OutputError&) {  // the list would name what is not there
    std::error_code error;
    if (own_.contains(kFrameList)) fs::remove(folder_ / kFrameList, error);
    throw;
  }
  write(kFrameList, frame_files_.list());
}

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
  FrameFiles::remove_others(folder_, {});
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
  frame_files_.remove();
  for (const std::string_view name : kGrowing) fs::remove(folder_ / name, error);
  fs::remove(checkpoint_in(folder_), error);
  fs::remove(folder_ / kFrameFolder, error);  // unless something else lies there
  if (made_folder_) fs::remove(folder_, error);
}

void RunFolder::drop_what_followed() {
  std::error_code error;
  fs::remove(folder_ / kRecord, error);  // where it stands the run is over; the other results are written again
  FrameFiles::remove_others(folder_, frame_files_.paths());
  remove_drafts(folder_);
  fs::create_directory(folder_ / kFrameFolder, error);
  for (GrowingTable* table : {&contacts_, &joints_, &bolts_}) table->keep_steps(frame_files_.steps());
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

void RunFolder::write(const std::string& name, const std::string& plain) {
  const std::string text = name.ends_with(".csv")   ? table_in_units(plain, units_)
                           : name.ends_with(".svg") ? picture_in_units(plain, units_)
                                                    : plain;
  write_file(folder_ / name, text, own_.contains(name) ? Overwrite::yes : overwrite_);
  own_.insert(name);
  if (std::ranges::find(outputs_, name) == outputs_.end()) outputs_.push_back(name);
}

void RunFolder::add(const Frame& frame, const FieldFrame& field, const ContactFrames& contacts) {
  frame_files_.write(frame, field, contacts);
  contacts_.append(formats::contacts_csv_rows(frame.step, frame.time, contacts));
  joints_.append(formats::joints_csv_rows(frame.step, frame.time, contacts));
  bolts_.append(formats::bolts_csv_rows(frame));
  if (const auto now = std::chrono::steady_clock::now(); now - listed_ > kListEvery) {
    write(kFrameList, frame_files_.list());
    listed_ = now;
  }
  if (trace_ == Trace::no && frames_.size() == 2) frames_.pop_back();
  frames_.push_back(frame);
}

void RunFolder::write_tables(const RunTables& tables) {
  write("history.csv", formats::history_csv(tables.history));
  write(kStepTable, tables.steps);
  if (!tables.ledger.empty()) write(kLedgerTable, tables.ledger);
  if (tables.history.of_measured_points) write("points.csv", formats::points_csv(tables.history));
}

void RunFolder::finish(const RunResults& results) {
  const auto& [title, tables, steps, ledger, field, is_of_motion, marked, marked_words, units] = results;
  const History& history = tables.history;
  units_ = units;
  outputs_.clear();  // in the same order whatever was written on the way
  write_list_of_frames();
  for (const GrowingTable* table : {&contacts_, &joints_, &bolts_})
    if (table->has_begun()) outputs_.push_back(table->file().filename().string());
  write_tables(tables);
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
    write("cracks.svg", report::crack_picture({title + ", cracks", frames_.front(), history, field}));
  }
  if (!field.cracks.empty()) write("cracks.dxf", dxf_of(field.cracks, units));
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
