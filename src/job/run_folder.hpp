// The folder a run writes into: frames as they come, tables and pictures at the end.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <filesystem>
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

/// Tables that are written whole, at the end and from time to time before it.
struct RunTables {
  const History& history;
  std::string steps;
  std::string ledger;  ///< empty where no books are kept
};

/// What a run leaves beside its frames.
struct RunResults {
  std::string title;
  RunTables tables;
  const std::vector<StepReport>& steps;
  Ledger ledger;
  const FieldFrame& field;         ///< the end
  bool is_of_motion = true;        ///< displacements are as they are, however large; those of linear statics are not
  std::vector<int> marked = {};    ///< elements, from 0, at which it failed
  std::string marked_words = {};   ///< what these do
  bool follows_by_choice = false;  ///< histories.csv was written on the way
  std::vector<std::vector<int>> joints = {};  ///< as `report::RunPicture` has them
  std::vector<std::string> rock_names = {};   ///< as `report::RunPicture` has them
  std::vector<std::string> joint_names = {};
  std::vector<int> idle_bolts = {};  ///< numbers, from 0, of bolts without properties
  std::vector<int> held = {};        ///< numbers, from 0, of blocks with a fixed point at the end
  bool has_pictures = true;
  std::string shown = {};  ///< in field.svg, a word of `report::kFieldWords`; empty: the stress that varies most
};

class RunFolder {
 public:
  /// For a new run; nothing is changed before `begin`. Tables, frames and pictures name `units`. Throws UsageError if
  /// there is a run already that may not be overwritten.
  RunFolder(std::filesystem::path folder, Overwrite overwrite, Trace trace, Units units = {});

  /// The folder of a run that goes on: `describe` has to follow, and then `drop_what_followed`, which changes it first.
  /// Throws UsageError if that run still writes.
  RunFolder(std::filesystem::path folder, Trace trace, Units units = {});

  /// Makes the folder; what an earlier run left there goes, all else stays. The first checkpoint, if the run has any,
  /// comes before the folder of frames: wherever that stands, the run can be resumed. Throws UsageError if another has
  /// just begun there, or still writes.
  void begin(const std::string& checkpoint = {});

  /// What `begin` made and the frames since, for a run whose input turns out to be unusable.
  void take_back();

  /// Saves and restores frames and growing tables. Throws InputError if one that was written is gone or is another.
  void describe(Archive& archive);

  /// Removes what an interrupted run left beyond its checkpoint, and nothing that is not a run's.
  void drop_what_followed();

  bool has_frames() const { return !frame_files_.is_empty(); }

  /// Puts `bytes` where `checkpoint_in` says, once the frames that they count on are on the disk.
  void write_checkpoint(const std::string& bytes);

  /// The run is over: the checkpoint goes, if there is one; of a run that took more than seconds, or began from a
  /// checkpoint, once the results are on the disk.
  void remove_checkpoint();

  /// Writes at once the frame's .vtu, with `field` where that has elements, .vtp files of contacts and bolts where
  /// there are any, and their rows of contacts.csv, joints.csv, joint_lines.csv and bolts.csv; and from time to time
  /// fields.pvd.
  void add(const Frame& frame, const FieldFrame& field = {}, const ContactFrames& contacts = {});

  /// Says what is to become of contacts, before the first frame.
  void choose_contacts(ContactOutput output) { frame_tables_.choose(std::move(output)); }
  /// Of which bodies consist, before the first frame.
  void choose_frames(std::vector<BlockMaterial> materials, formats::VtkCoding coding) {
    frame_files_.choose(std::move(materials), coding);
  }
  const FrameTables& frame_tables() const { return frame_tables_; }

  /// Lines of histories.csv, kept for a while before they are written.
  void add_histories(const std::string& rows);

  /// history.csv (`hidden`: numbers of blocks that pictures leave out), step_table.csv, ledger.csv if there is a
  /// ledger, points.csv where points are measured.
  void write_tables(const RunTables& tables, const std::vector<int>& hidden = {});

  /// All tables, fields.pvd, picture.svg, field.svg; energy.svg if there is a ledger, plastic.svg where rock may yield,
  /// reactions.svg where load steps of such rock drive an edge and, for a trace, steps.csv, blocks.csv and, where there
  /// are rounds of Newton's method, rounds.csv. Returns the numbers, from 0, of the elements that the pictures leave
  /// out.
  std::vector<int> finish(const RunResults& results);

  /// run.json, last: where it stands, everything else does.
  void write_record(const std::string& json);

  const Frame& first_frame() const { return frames_.front(); }
  const Frame& last_frame() const { return frames_.back(); }
  /// Of the last frame against the first.
  Extremes extremes(const FieldFrame& end) const { return extremes_of(frames_.front(), frames_.back(), end); }

  /// Names of what was written, in order.
  const std::vector<std::string>& outputs() const { return files_.names(); }

 private:
  void write_traces(const RunResults& results);
  void write_list_of_frames();
  void flush_frames();
  void flush_histories();

  std::filesystem::path folder_;
  OutputFiles files_;
  Units units_;
  FolderLock lock_;  ///< of a new run from `begin` on
  FrameFiles frame_files_;
  FrameTables frame_tables_;
  GrowingTable histories_;
  std::string history_rows_;                           ///< that are not written yet
  std::chrono::steady_clock::time_point listed_ = {};  ///< when the list of frames was written last
  Trace trace_;
  std::vector<Frame> frames_;  ///< for a trace all of them, else the first and the last
  bool made_folder_ = false;
  bool has_saved_steps_ = false;
  std::chrono::steady_clock::time_point begun_ = std::chrono::steady_clock::now();
};

/// Where a run's folder has its checkpoint.
std::filesystem::path checkpoint_in(const std::filesystem::path& folder);

}  // namespace keyblock
