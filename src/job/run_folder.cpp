// Writes the results of one run into its folder.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "job/run_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>
#include <utility>

#include "base/error.hpp"
#include "formats/columns/frame_columns.hpp"
#include "formats/dxf/dxf_writer.hpp"
#include "formats/tables/run_tables.hpp"
#include "formats/text/csv.hpp"
#include "formats/text/tips_csv.hpp"
#include "job/curves/most_moved.hpp"
#include "job/run_heading.hpp"
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

// The list is written whole each time, so it is not written with each of many frames.
constexpr std::chrono::milliseconds kListEvery{500};

// Results of longer runs must survive a power failure.
constexpr std::chrono::seconds kWorthTheDisk{3};

// Rows of histories are written in batches.
constexpr std::size_t kLotOfRows = 1 << 16;

// Layer JOINT_2 has cracks that started in shear, JOINT_1 all others.
std::string dxf_of(const std::vector<CrackFrame>& cracks, const Units& units) {
  formats::Content content;
  content.units = units;
  Drawing& drawing = content.drawing.emplace();
  for (const CrackFrame& crack : cracks)
    for (std::size_t i = 0; i + 1 < crack.along.size(); ++i)
      drawing.joints.push_back({{crack.along[i], crack.along[i + 1]}, crack.is_shear ? 1 : 0, {}});
  return formats::write_dxf(content);
}

std::vector<int> numbers_of(const Frame& frame, const std::vector<std::size_t>& elements) {
  std::vector<int> numbers;
  for (const std::size_t i : elements) numbers.push_back(number_of(frame, i));
  return numbers;
}

std::vector<std::size_t> places_of(const std::vector<int>& numbers, const Frame& frame) {
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < frame.elements.size(); ++i)
    if (std::ranges::find(numbers, number_of(frame, i)) != numbers.end()) places.push_back(i);
  return places;
}

std::string histories_header(const Units& units) {
  return formats::headings(formats::kHistoriesTable, units) + '\n';
}

void write_pictures(OutputFiles& files, const RunResults& results, const Frame& start, const Frame& end,
                    const std::vector<std::size_t>& left_out, const Units& units) {
  const FieldFrame& field = results.field;
  const History& history = results.tables.history;
  const std::string at_end = title_at(results.title, field.time, units);
  const Shown shown{history, start, field, numbers_of(end, left_out)};
  files.write("picture.svg",
              report::run_picture({results.title,
                                   start,
                                   end,
                                   displacement_curves(shown),
                                   {{"time", measures::kTime, units}, {"displacement", measures::kLength, units}},
                                   units.time,
                                   results.marked,
                                   results.marked_words,
                                   units,
                                   left_out,
                                   numbers_of_curves(shown),
                                   numbered_words(shown),
                                   results.joints,
                                   results.rock_names,
                                   results.joint_names,
                                   results.idle_bolts}));
  if (results.ledger.rows.size() > 1)
    files.write("energy.svg", report::energy_picture(results.title + ", energy", results.ledger, units));
  files.write("field.svg", report::field_picture({at_end,
                                                  {},
                                                  field,
                                                  end.measured_points,
                                                  results.shown.empty() ? report::most_varied(field)
                                                                        : report::field_of_word(results.shown),
                                                  results.is_of_motion,
                                                  units,
                                                  left_out,
                                                  {},
                                                  places_of(results.held, end),
                                                  {}}));
  if (field.plastic) files.write("plastic.svg", report::plastic_picture({at_end, field, end.outlines, units}));
  if (const std::vector<ReactionCurve> curves = reaction_curves(history); !curves.empty())
    files.write(kReactionFile, report::reaction_picture(results.title + ", reactions", curves, units));
}

[[noreturn]] void give_up(const fs::path& folder, std::error_code why) {
  const std::string words = fmt::format("cannot make the folder {}: {}", folder.string(), why.message());
  if (why == std::errc::no_space_on_device) throw OutputError(words);
  throw UsageError(words);
}

}  // namespace

RunFolder::RunFolder(fs::path folder, Overwrite overwrite, Trace trace, Units units)
    : folder_(std::move(folder)),
      files_(folder_, overwrite),
      units_(std::move(units)),
      frame_files_(folder_),
      frame_tables_(folder_, units_),
      histories_(folder_ / formats::kHistoriesTable.file, histories_header(units_)),
      trace_(trace) {
  files_.require_free();
  // A link to a folder is not a folder of this run: its target is the user's.
  if (const fs::path frames = folder_ / kFrameFolder;
      fs::exists(fs::symlink_status(frames)) && !fs::is_directory(fs::symlink_status(frames)))
    throw UsageError(fmt::format("{} is a file or a link, not a folder", frames.string()));
}

RunFolder::RunFolder(fs::path folder, Trace trace, Units units)
    : RunFolder(std::move(folder), Overwrite::yes, trace, std::move(units)) {
  has_saved_steps_ = true;
  lock_ = FolderLock(folder_);
}

// Files that appeared since the folder was checked belong to another run, or to the user.
void RunFolder::begin(const std::string& checkpoint) {
  std::error_code error;
  made_folder_ = fs::create_directories(folder_, error);
  if (error) give_up(folder_, error);
  lock_ = FolderLock(folder_);
  if (files_.overwrite() == Overwrite::yes)
    files_.remove_earlier();
  else
    files_.require_free();
  remove_drafts(folder_);  // of a killed run: no other run writes here
  if (!checkpoint.empty()) write_file(checkpoint_in(folder_), checkpoint, Overwrite::no);
  const bool made_frames = fs::create_directory(folder_ / kFrameFolder, error);
  if (error) give_up(folder_ / kFrameFolder, error);
  if (!made_frames && files_.overwrite() == Overwrite::no)
    throw UsageError(fmt::format("{} holds the frames of another run; give another folder", folder_.string()));
}

void RunFolder::take_back() {
  std::error_code error;
  frame_files_.remove();
  files_.remove_growing();
  fs::remove(checkpoint_in(folder_), error);
  fs::remove(folder_ / kFrameFolder, error);  // unless it holds other files
  if (made_folder_) fs::remove(folder_, error);
}

void RunFolder::drop_what_followed() {
  std::error_code error;
  fs::remove(folder_ / kRecord, error);  // its presence means that the run is over; the other results are written again
  FrameFiles::remove_others(folder_, frame_files_.paths());
  remove_drafts(folder_);
  fs::create_directory(folder_ / kFrameFolder, error);
  frame_tables_.drop_what_followed();
  histories_.drop_what_followed();
}

void RunFolder::flush_frames() {
  frame_files_.flush();
  frame_tables_.flush();
  flush_histories();
  histories_.flush();
}

void RunFolder::write_checkpoint(const std::string& bytes) {
  flush_frames();
  write_durably(checkpoint_in(folder_), bytes, Overwrite::yes);
  has_saved_steps_ = true;
}

// The results replace the checkpoint, and reach the disk first. Those of a run of a few seconds may wait.
void RunFolder::remove_checkpoint() {
  if (!fs::exists(checkpoint_in(folder_))) return;
  if (has_saved_steps_ || std::chrono::steady_clock::now() - begun_ > kWorthTheDisk) {
    flush_frames();
    for (const std::string& name : files_.names()) flush_to_disk(folder_ / name);
    flush_to_disk(folder_);
  }
  fs::remove(checkpoint_in(folder_));
}

void RunFolder::describe(Archive& archive) {
  frame_files_.describe(archive);
  archive.list("frames", frames_, [&](Frame& frame) { keyblock::describe(archive, frame); });
  if (archive.is_restoring()) {
    if (frames_.empty()) archive.refuse("frames", "expected the first frame, found none");
    frame_files_.require_unchanged(archive);
  } else {
    flush_histories();
  }
  frame_tables_.describe(archive);
  archive.group("histories", [&] { histories_.describe(archive); });
}

void RunFolder::add(Frame frame, FieldFrame field, const ContactFrames& contacts, formats::FrameStage stage) {
  const auto columns = formats::columns_of(frame, frame_tables_.shown(contacts), field, std::move(stage));
  field = {};  // in the columns; large bodies need the room
  frame_files_.write(columns, units_);
  frame_tables_.append(frame, columns, contacts);
  if (const auto now = std::chrono::steady_clock::now(); now - listed_ > kListEvery) {
    files_.write(kFrameList, frame_files_.list());
    listed_ = now;
  }
  if (trace_ == Trace::no && frames_.size() == 2) frames_.pop_back();
  frames_.push_back(std::move(frame));
}

void RunFolder::add_histories(const std::string& rows) {
  history_rows_ += rows;
  if (history_rows_.size() > kLotOfRows) flush_histories();
}

void RunFolder::flush_histories() {
  histories_.append(history_rows_);
  history_rows_.clear();
}

// Without this check the list would name missing files.
void RunFolder::write_list_of_frames() {
  try {
    frame_files_.require_there();
  } catch (const OutputError&) {
    std::error_code error;
    if (files_.is_own(kFrameList)) fs::remove(folder_ / kFrameList, error);
    throw;
  }
  files_.write(kFrameList, frame_files_.list());
}

void RunFolder::write_tables(const RunTables& tables, const std::vector<int>& hidden) {
  flush_histories();
  files_.write(formats::kHistoryTable.file,
               formats::history_csv(tables.history, units_, columns_of_history(tables.history, hidden)));
  files_.write(formats::kStepTable.file, tables.steps);
  if (!tables.ledger.empty()) files_.write(formats::kLedgerTable.file, tables.ledger);
  if (tables.history.of_measured_points)
    files_.write(formats::kPointsTable.file, formats::points_csv(tables.history, units_));
}

std::vector<int> RunFolder::finish(const RunResults& results) {
  const History& history = results.tables.history;
  files_.forget_names();
  write_list_of_frames();
  flush_histories();
  histories_.write_waiting();
  if (results.follows_by_choice && histories_.has_begun())
    files_.name(formats::kHistoriesTable.file, histories_.checksum());
  for (auto& [name, checksum] : frame_tables_.written()) files_.name(name, std::move(checksum));
  const std::vector<std::size_t> left_out = report::left_out_of(frames_.front(), frames_.back(), results.marked);
  const std::vector<int> hidden = numbers_of(frames_.back(), left_out);
  write_tables(results.tables, hidden);
  if (!results.follows_by_choice && !history.of_measured_points)  // measured points have tables of their own
    files_.write(formats::kHistoriesTable.file,
                 histories_header(units_) + most_moved_rows({history, frames_.front(), results.field, hidden}, units_));
  if (results.has_pictures) write_pictures(files_, results, frames_.front(), frames_.back(), left_out, units_);
  if (const std::string tips = formats::tips_csv(history, units_); !tips.empty()) {
    files_.write(formats::kTipsTable.file, tips);
    if (results.has_pictures)
      files_.write("cracks.svg", report::crack_picture(
                                     {results.title + ", cracks", frames_.front(), history, results.field, units_}));
  }
  if (!results.field.cracks.empty()) files_.write("cracks.dxf", dxf_of(results.field.cracks, units_));
  if (trace_ == Trace::yes) write_traces(results);
  if (results.has_page) files_.name(kPageFile, "");
  return hidden;
}

void RunFolder::write_traces(const RunResults& results) {
  files_.write(formats::kTraceOfSteps.file, formats::steps_csv(results.steps, units_));
  if (std::ranges::any_of(results.steps, [](const StepReport& step) { return !step.residuals.empty(); }))
    files_.write(formats::kTraceOfRounds.file, formats::rounds_csv(results.steps));
  files_.write(formats::kTraceOfBlocks.file, formats::blocks_csv(frames_, units_));
}

void RunFolder::write_record(const std::string& json, const std::function<std::string()>& page) {
  files_.write(kRecord, json);
  if (page) files_.write(kPageFile, page());
}

fs::path checkpoint_in(const fs::path& folder) {
  return folder / kCheckpoint;
}

}  // namespace keyblock
