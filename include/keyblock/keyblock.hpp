// Declares Keyblock as a library: reads a case, makes it ready, runs it step by step, hands out what moved.
//
//   #include <keyblock/keyblock.hpp>
//   namespace kb = keyblock::api;
//   kb::Run run(kb::Plan(kb::Case::read({"slope.json"})));
//   run.go_on();
//   double x = run.frame().displacement()(0, 0);
//
// Two more headers are for those who need them: keyblock/record.hpp (results in a folder) and keyblock/studies.hpp
// (factor of safety, stress intensity, random rows).
//
// Numbers of blocks, materials and cracks count from 1, as in case files and tables; rows of columns from 0. Quantities
// have the units of the case (Case::units). Nothing prints, and nothing but Case::write touches a file that it was not
// told to read. Every function may throw Error and std::bad_alloc; "throws input" names a code of Error.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <functional>
#include <keyblock/frame.hpp>
#include <keyblock/values.hpp>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace keyblock::api {
inline namespace v1 {

/// A profile ("standard", "legacy", …; empty: that of the files) and settings above it, as `--profile` and `--set`.
struct Choices {
  std::string profile = {};
  std::vector<std::pair<std::string, std::string>> set = {};
  /// Histories that a `Run` keeps in memory, beside those of the case; as `keyblock run --history`: "crest=point:12,20".
  std::vector<std::string> histories = {};
};

/// Choices for a drawing among the files of a case, as `--unit` and `--join`.
struct Drawing {
  std::string unit = {};  ///< of length, of a DXF file instead of its own: in, ft, mm, cm, m, km, yd or dm
  double join = 0;        ///< ends of lines nearer than this to a line are joined to it; 0: none
};

/// The content of case files. Copies share it; nothing changes it.
class KEYBLOCK_API Case {
 public:
  /// The files of a case in any order, a table of DXF layers among them, or its folder. Throws input, choice
  /// for choices that no drawing has or without a drawing that they fit.
  static Case read(const std::vector<std::string>& paths, const Drawing& drawing = {});
  const std::vector<Warning>& warnings() const;
  /// Names of the units of length, mass and time; each empty where the case does not declare it.
  std::vector<std::string> units() const;
  /// The profile of a `Run` that requests none: that of the case file, `standard` for a case of Keyblock's own,
  /// `legacy` for files of Shi's programs. Throws choice if `case.json` says that it is not run.
  std::string profile() const;
  /// The case as a case file of Keyblock (`keyblock formats --schema`).
  std::string json() const;
  /// A value of that file by its JSON pointer (RFC 6901), as JSON: "/analysis/joint_materials/0/friction_angle_deg".
  /// The name of a list item may replace its number; * stands for all items, whose values form a list. Throws
  /// choice if the case has no such value.
  std::string get(std::string_view pointer) const;
  /// The JSON pointers that a pointer with names and * stands for. Throws choice if there are none.
  std::vector<std::string> pointers(std::string_view pointer) const;
  /// The same case with another value there, given as JSON; also a key that its object lacks. Throws choice for a
  /// pointer to nothing, input for a key or a value that the file must not have.
  Case with(std::string_view pointer, std::string_view value) const;
  Case with(std::string_view pointer, double value) const;
  /// Writes it in a format of `keyblock convert --to`. Gives in sentences what the format cannot hold, what is added,
  /// and by which other rules a run of it goes. Throws choice for no format, and where a file is there already.
  std::vector<std::string> write(const std::string& path, std::string_view format = "keyblock-case") const;

  struct Data;
  const Data& data() const { return *data_; }

 private:
  explicit Case(std::shared_ptr<const Data> data) : data_(std::move(data)) {}

  std::shared_ptr<const Data> data_;
};

/// A case made ready for its first step. Many runs may share it.
class KEYBLOCK_API Plan {
 public:
  /// Throws input, choice.
  explicit Plan(const Case& of, const Choices& choices = {}, const Context& context = Context());
  const std::string& profile() const;                                 ///< "standard", "legacy", "draft" or "reference"
  const std::string& why_profile() const;                             ///< in words: who chose it
  std::vector<std::pair<std::string, std::string>> settings() const;  ///< name and value, all
  std::vector<Warning> warnings() const;                              ///< of reading, preparing and looking ahead
  /// Counts the unknowns of the first step: an affine block that can move has six, a rigid one three, a cover function
  /// two.
  int unknowns() const;
  int blocks() const;  ///< on covers: elements
  int steps() const;   ///< most of them, in all stages
  /// Times of the start and of all steps, if none is cut and no stage ends early [time].
  std::vector<double> step_times() const;

  struct Data;
  const std::shared_ptr<const Data>& data() const { return data_; }

 private:
  std::shared_ptr<const Data> data_;
};

/// An accepted step.
struct Step {
  int number = 0;
  double time = 0, dt = 0;  ///< at its end, and its length [time]
  int systems = 0;          ///< solves of contact forces, or rounds of open and close
  double residual = 0;      ///< out of balance, over the largest load
  double penetration = 0;   ///< deepest of all contacts [length]
};

/// Content of a frame. `corners` adds the displacement of all corners, their stress if it varies within elements, and
/// the faces of cracks.
enum class Detail { blocks, corners };

enum class End { running, finished, stopped, failed, doubtful };

struct Outcome {
  End end = End::running;  ///< doubtful: came to its end, and its numbers cannot be trusted
  std::string reason;      ///< why it failed, or a recorded run ended early
  std::string failure;     ///< its kind: "no_equilibrium", "undecided" or "cracks"; empty without a failure
  std::string cause;       ///< its code, such as "contacts_do_not_settle"; empty without one
  Facts facts;             ///< the values behind the reason; `blocks`: those that move away or turned inside out
  int steps = 0;           ///< accepted
  double time = 0;         ///< reached [time]
  /// The largest of any corner at the end, from the drawing [length]; no number before.
  double displacement = std::nan("");
  double speed = std::nan("");         ///< of the fastest block at the end [length/time]; no number before
  std::vector<std::string> sentences;  ///< how the motion ended
  std::vector<Warning> warnings;       ///< of the plan and the run, doubts among them
  std::vector<Warning> doubts;
};

/// Steps made one at a time, by one thread at a time. Prints nothing and writes nothing. One that was moved from may
/// only be assigned to or destroyed.
class KEYBLOCK_API Run {
 public:
  /// Computes the initial state. Throws input, stopped.
  explicit Run(const Plan& plan, const Context& context = Context());
  Run(Run&&) noexcept;
  Run& operator=(Run&&) noexcept;
  ~Run();
  /// Makes one step; false where the run is at its end, stopped or failed, and `outcome` says which.
  bool advance();
  /// To the end, or until `until` is true after a step: the run may then continue. A recorded run ends there.
  const Outcome& go_on(const std::function<bool(const Run&)>& until = {});
  /// Ends a recorded run after the last step: its results are written, with `why` as `ended_early` in run.json, and a
  /// checkpoint from which `resume` continues. Does nothing to another run, or after the last step of all.
  void end_early(const std::string& why);
  /// The case, with the choices of a run that is resumed.
  const Case& of() const;
  const Step& last() const;
  Frame frame(Detail detail = Detail::blocks) const;  ///< of now; its contacts are computed when first read
  const Outcome& outcome() const;                     ///< `running` before the end
  /// Names of the histories so far: those of `Choices::histories` and of the case. The energy balance is "ledger", if the
  /// settings request it; it is not listed.
  std::vector<std::string> histories() const;
  /// Quantities of a history, each with its unit (a letter if the case does not declare it). Throws choice.
  std::vector<std::pair<std::string, std::string>> quantities(std::string_view history) const;
  /// Time and value of a quantity, at the start and after each step; long runs keep every n-th step and the last one, as
  /// their tables do. Throws choice for a history or quantity that is not there.
  Column<double> history(std::string_view history, std::string_view quantity) const;

  struct State;
  explicit Run(std::unique_ptr<State> state);

 private:
  std::unique_ptr<State> state_;
};

/// "0.2.0".
KEYBLOCK_API std::string version();
/// Hash of this build of the library; builds that may compute otherwise differ in it.
KEYBLOCK_API std::string build();
/// Commit of the sources of this build, with a + if files differed from it: "0123abc+"; "unknown" without a history.
KEYBLOCK_API std::string commit();
/// "g++ 12.2.0".
KEYBLOCK_API std::string compiler();

}  // namespace v1
}  // namespace keyblock::api
