// Writes the results of one run.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/run_folder.hpp"

#include <fmt/format.h>

#include <array>
#include <set>

#include "app/usage_error.hpp"
#include "formats/csv.hpp"
#include "formats/vtk.hpp"
#include "report/energy_picture.hpp"
#include "report/run_picture.hpp"
#include "result/describe.hpp"

namespace keyblock {

namespace fs = std::filesystem;

namespace {

constexpr const char* kRecord = "run.json";
constexpr const char* kFrameFolder = "frames";
constexpr const char* kCheckpoint = "checkpoint.h5";

// What a run writes at its end, and everything it may leave in its folder.
constexpr std::array kResults{kRecord,      "history.csv", "fields.pvd", "picture.svg",
                              "energy.svg", "steps.csv",   "blocks.csv", "points.csv"};
constexpr std::array kNames{kRecord,     "history.csv", "fields.pvd", "picture.svg", "energy.svg",
                            "steps.csv", "blocks.csv",  "points.csv", kFrameFolder,  kCheckpoint};

// How far each followed point has come, over time.
std::vector<report::Curve> displacement_curves(const History& history) {
  constexpr std::size_t kMostCurves = 6;  // more cannot be told apart in one chart
  std::vector<report::Curve> curves;
  if (history.rows.empty()) return curves;
  const std::size_t count = std::min(history.rows.front().points.size(), kMostCurves);
  for (std::size_t i = 0; i < count; ++i) {
    report::Curve curve;
    const bool is_last_of_more = i + 1 == count && history.rows.front().points.size() > count;
    curve.label = fmt::format("{} {}{}", history.of_measured_points ? "measured point" : "block", i + 1,
                              is_last_of_more ? fmt::format(" (of {})", history.rows.front().points.size()) : "");
    for (const HistoryRow& row : history.rows) {
      curve.x.push_back(row.time);
      curve.y.push_back(length(row.points[i].displacement));
    }
    curves.push_back(std::move(curve));
  }
  return curves;
}

}  // namespace

RunFolder::RunFolder(fs::path folder, Overwrite overwrite, Trace trace) : folder_(std::move(folder)), trace_(trace) {
  if (fs::exists(folder_) && !fs::is_directory(folder_))
    throw UsageError(fmt::format("{} is a file, not a folder", folder_.string()));
  for (const char* name : kNames) require_free(folder_ / name, overwrite);
  // What an earlier run left is no part of this one.
  std::error_code error;
  for (const char* name : kNames) {
    fs::remove_all(folder_ / name, error);
    if (error) throw UsageError(fmt::format("cannot remove {} of an earlier run", (folder_ / name).string()));
  }
  fs::create_directories(folder_ / kFrameFolder, error);
  if (error) throw UsageError(fmt::format("cannot make the folder {}", folder_.string()));
}

RunFolder::RunFolder(fs::path folder, Trace trace) : folder_(std::move(folder)), trace_(trace) {}

void RunFolder::drop_what_followed() {
  std::error_code error;
  for (const char* name : kResults) fs::remove(folder_ / name, error);
  std::set<fs::path> kept;
  for (const auto& [time, name] : frame_files_) kept.insert(folder_ / name);
  std::vector<fs::path> later;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder_ / kFrameFolder))
    if (!kept.contains(entry.path())) later.push_back(entry.path());
  for (const fs::path& file : later) fs::remove(file, error);
}

void RunFolder::flush_frames() {
  for (; flushed_frames_ < frame_files_.size(); ++flushed_frames_)
    flush_to_disk(folder_ / frame_files_[flushed_frames_].second);
  flush_to_disk(folder_ / kFrameFolder);
}

void RunFolder::write_checkpoint(const std::string& bytes) {
  flush_frames();
  write_durably(checkpoint_in(folder_), bytes);
}

void RunFolder::remove_checkpoint() {
  if (!fs::exists(checkpoint_in(folder_))) return;
  flush_frames();
  for (const std::string& name : outputs_) flush_to_disk(folder_ / name);
  flush_to_disk(folder_);
  fs::remove(checkpoint_in(folder_));
}

void RunFolder::describe(Archive& archive) {
  archive.list("files", frame_files_, [&](std::pair<double, std::string>& file) {
    archive.value("time", file.first);
    archive.value("name", file.second);
  });
  archive.list("frames", frames_, [&](Frame& frame) { keyblock::describe(archive, frame); });
  if (!archive.is_restoring()) return;
  flushed_frames_ = frame_files_.size();
  if (frames_.empty()) archive.refuse("frames", "expected the first frame, found none");
  for (const auto& [time, name] : frame_files_)
    if (!fs::is_regular_file(folder_ / name))
      archive.refuse(name, "expected every frame written so far, found one gone");
}

void RunFolder::write(const std::string& name, const std::string& text) {
  write_file(folder_ / name, text);
  outputs_.push_back(name);
}

void RunFolder::add(const Frame& frame) {
  const std::string name = fmt::format("{}/{:08}.vtu", kFrameFolder, frame.step);
  write_file(folder_ / name, formats::vtu(frame));
  frame_files_.emplace_back(frame.time, name);
  if (trace_ == Trace::no && frames_.size() == 2) frames_.pop_back();
  frames_.push_back(frame);
}

void RunFolder::finish(const std::string& title, const History& history, const std::vector<StepReport>& steps,
                       const Ledger& ledger) {
  write("fields.pvd", formats::pvd(frame_files_));
  write("history.csv", formats::history_csv(history));
  write("picture.svg", report::run_picture({title,
                                            frames_.front(),
                                            frames_.back(),
                                            displacement_curves(history),
                                            {"time [T]", "displacement [L]"},
                                            ""}));
  if (!ledger.rows.empty()) write("energy.svg", report::energy_picture(title + ", energy", ledger));
  if (trace_ == Trace::no) return;
  write("steps.csv", formats::steps_csv(steps));
  write("blocks.csv", formats::blocks_csv(frames_));
}

void RunFolder::add(const FieldFrame& frame) {
  const std::string name = fmt::format("{}/{:08}.vtu", kFrameFolder, frame.step);
  write_file(folder_ / name, formats::vtu(frame));
  frame_files_.emplace_back(frame.time, name);
}

void RunFolder::finish(const std::string& picture, const History& history) {
  write("fields.pvd", formats::pvd(frame_files_));
  write("history.csv", formats::history_csv(history));
  write("points.csv", formats::points_csv(history));
  write("picture.svg", picture);
}

void RunFolder::write_record(const std::string& json) {
  write(kRecord, json);
}

fs::path checkpoint_in(const fs::path& folder) {
  return folder / kCheckpoint;
}

}  // namespace keyblock
