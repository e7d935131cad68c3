// Writes the folder of a run: frames during the run, tables and pictures at the end.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "base/archive.hpp"
#include "job/files.hpp"
#include "job/folder/folder_lock.hpp"
#include "job/folder/frame_files.hpp"
#include "job/folder/frame_tables.hpp"
#include "job/folder/growing_table.hpp"
#include "job/folder/output_files.hpp"
#include "problem/run_choices.hpp"
#include "result/contact_frame.hpp"
#include "result/extremes.hpp"
#include "result/field_frame.hpp"
#include "result/frame.hpp"
#include "result/history.hpp"
#include "result/ledger.hpp"
#include "result/step_report.hpp"

namespace keyblock {

enum class Trace { no, yes };

/// Tables that are written whole, at the end and at intervals before it.
struct RunTables {
  const History& history;
  std::string steps;
  std::string ledger;  ///< empty without an energy balance
};

/// Results of a run in addition to its frames.
struct RunResults {
  std::string title;
  RunTables tables;
  const std::vector<StepReport>& steps;
  Ledger ledger;
  const FieldFrame& field;        ///< the end
  bool is_of_motion = true;       ///< displacements are true to scale, even large ones; those of linear statics are not
  std::vector<int> marked = {};   ///< elements, from 0, at which it failed
  std::string marked_words = {};  ///< their failure, in words
  bool follows_by_choice = false;             ///< histories.csv was written during the run
  std::vector<std::vector<int>> joints = {};  ///< in the form of `report::RunPicture`
  std::vector<std::string> rock_names = {};   ///< in the form of `report::RunPicture`
  std::vector<std::string> joint_names = {};
  std::vector<int> idle_bolts = {};  ///< numbers, from 0, of bolts without properties
  std::vector<int> held = {};        ///< numbers, from 0, of blocks with a fixed point at the end
  bool has_pictures = true;
  bool has_page = false;   ///< the page follows the record
  std::string shown = {};  ///< in field.svg, a word of `report::kFieldWords`; empty: the stress that varies most
};

class RunFolder {
 public:
  /// Prepares a new run; changes nothing before `begin`. Tables, frames and pictures name `units`. Throws UsageError if
  /// a run exists there that may not be overwritten.
  RunFolder(std::filesystem::path folder, Overwrite overwrite, Trace trace, Units units = {});

  /// Opens the folder of a run to resume. Call `describe` next, then `drop_what_followed`, which is the first to change
  /// the folder. Throws UsageError if that run still writes.
  RunFolder(std::filesystem::path folder, Trace trace, Units units = {});

  /// Makes the folder and removes the files of an earlier run; all else stays. The first checkpoint, if the run has
  /// any, is written before the folder of frames: any run with that folder can be resumed. Throws UsageError if another
  /// run has just begun there, or still writes.
  void begin(const std::string& checkpoint = {});

  /// Removes the files of `begin` and all frames since, for a run whose input turns out to be unusable.
  void take_back();

  /// Saves and restores frames and growing tables. Throws InputError if a written file is gone or has changed.
  void describe(Archive& archive);

  /// Removes results of an interrupted run beyond its checkpoint, and nothing that is not a run's.
  void drop_what_followed();

  /// Writes `bytes` to the file of `checkpoint_in`, after the frames that they refer to are on the disk.
  void write_checkpoint(const std::string& bytes);

  /// Removes the checkpoint, if any, after the run. If the run took more than seconds, or began from a checkpoint, the
  /// results are flushed to the disk first.
  void remove_checkpoint();

  /// Writes the files of a frame at once, and appends its rows to the tables. Writes fields.pvd at intervals.
  void add(Frame frame, FieldFrame field = {}, const ContactFrames& contacts = {},
           formats::FrameStage stage = {});

  /// Selects the output of contacts, before the first frame.
  void choose_contacts(ContactOutput output) { frame_tables_.choose(std::move(output)); }
  /// Sets the materials of the bodies, before the first frame.
  void choose_frames(std::vector<BlockMaterial> materials, formats::VtkCoding coding) {
    frame_files_.choose(std::move(materials), coding);
  }
  const FrameTables& frame_tables() const { return frame_tables_; }

  /// Adds lines of histories.csv, which are written in batches.
  void add_histories(const std::string& rows);

  /// Writes history.csv (`hidden`: numbers of blocks that pictures leave out), step_table.csv, ledger.csv if there is
  /// an energy balance, points.csv if points are measured.
  void write_tables(const RunTables& tables, const std::vector<int>& hidden = {});

  /// Writes all tables, fields.pvd, picture.svg and field.svg; energy.svg if there is an energy balance; plastic.svg if
  /// rock is elastoplastic. Writes reactions.svg if load steps of such rock drive an edge. For a trace, writes
  /// steps.csv, blocks.csv and, if there are Newton iterations, rounds.csv. Returns the numbers, from 0, of the
  /// elements that the pictures leave out.
  std::vector<int> finish(const RunResults& results);

  /// Writes run.json last: its presence means that all other files are there. The page, which shows it, follows.
  void write_record(const std::string& json, const std::function<std::string()>& page = {});

  const Frame& first_frame() const { return frames_.front(); }
  const Frame& last_frame() const { return frames_.back(); }

  /// Returns the names of the written files, in order.
  const std::vector<std::string>& outputs() const { return files_.names(); }
  /// Returns names and checksums of the written files, then of those of frames.
  Checksums checksums() const { return frame_files_.checksums(files_.checksums()); }

 private:
  void write_traces(const RunResults& results);
  void write_list_of_frames();
  void flush_frames();
  void flush_histories();

  std::filesystem::path folder_;
  OutputFiles files_;
  Units units_;
  FolderLock lock_;  ///< of a new run: locked from `begin` on
  FrameFiles frame_files_;
  FrameTables frame_tables_;
  GrowingTable histories_;
  std::string history_rows_;                           ///< not written yet
  std::chrono::steady_clock::time_point listed_ = {};  ///< last time at which the list of frames was written
  Trace trace_;
  std::vector<Frame> frames_;  ///< for a trace all of them, otherwise the first and the last
  bool made_folder_ = false;
  bool has_saved_steps_ = false;
  std::chrono::steady_clock::time_point begun_ = std::chrono::steady_clock::now();
};

/// Returns the path of the checkpoint in the folder of a run.
std::filesystem::path checkpoint_in(const std::filesystem::path& folder);

}  // namespace keyblock
