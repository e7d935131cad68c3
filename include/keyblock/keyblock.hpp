// Declares Keyblock as a library: reads a case, makes it ready, runs it step by step, hands out what moved.
//
//   #include <keyblock/keyblock.hpp>
//   namespace kb = keyblock::api;
//   kb::Run run(kb::Plan(kb::Case::read({"slope.json"})));
//   run.go_on();
//   double x = run.frame().displacement()(0, 0);
//
// Numbers of blocks, materials and cracks count from 1, as in case files and tables; rows of columns from 0. Quantities
// have the units of the case (Case::units). Nothing prints, and nothing but Case::write touches a file that it was not
// told to read. Every function may throw Error, or what it names, and std::bad_alloc.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#define KEYBLOCK_API __attribute__((visibility("default")))

namespace keyblock::api {
inline namespace v1 {

/// A place in a text file; line and column count from 1, 0: the file as a whole.
struct Place {
  std::string file;
  int line = 0, column = 0;
};

/// Usable input that is likely a mistake, or a doubt: `code` is a stable word (`keyblock explain CODE` has the remedy).
struct Warning {
  std::string code, sentence;
  Place place;
};

struct KEYBLOCK_API Error : std::runtime_error {
  using std::runtime_error::runtime_error;
};
/// Input that cannot be used: `what()` is "file:line:column: error: expected …, found …".
struct KEYBLOCK_API InputError : Error {
  InputError(const std::string& what, Place at) : Error(what), place(std::move(at)) {}
  Place place;
};
/// An unknown setting, profile or pointer.
struct KEYBLOCK_API SettingError : Error {
  using Error::Error;
};
/// Thrown by what `Context::stop` ends before it has a result.
struct KEYBLOCK_API Stopped : Error {
  using Error::Error;
};

/// Stops a computation and limits its threads. Copies share one state; any thread may use it.
class KEYBLOCK_API Context {
 public:
  /// Threads of a step, at most 256; 0: as many as there are processors. Results do not depend on it, to the last bit.
  /// Throws SettingError.
  explicit Context(int threads = 0);
  /// Heard within steps and searches, and not taken back. May be called by a signal handler.
  void stop() const noexcept;
  bool is_stopped() const noexcept;
  /// Name of the search that runs and its progress, 0 to 1 (0: unknown). The name is empty between searches.
  std::pair<std::string, double> headway() const;

  struct State;
  const State& state() const { return *state_; }

 private:
  std::shared_ptr<State> state_;
};

/// A profile ("standard", "legacy", …; empty: as the files ask) and settings above it, as `--profile` and `--set`.
struct Choices {
  std::string profile = {};
  std::vector<std::pair<std::string, std::string>> set = {};
  /// Histories that a `Run` keeps in memory, beside those of the case; as `keyblock run --history`: "crest=point:12,20".
  std::vector<std::string> histories = {};
};

/// Choices for a drawing among the files of a case, as `--unit` and `--join`.
struct Drawing {
  std::string unit = {};  ///< of length, of a DXF file instead of its own
  double join = 0;        ///< ends of lines nearer than this to a line are joined to it; 0: none
};

/// The content of case files. Copies share it; nothing changes it.
class KEYBLOCK_API Case {
 public:
  /// The files of a case in any order, a table of DXF layers among them, or its folder. Throws InputError, SettingError
  /// for choices without a drawing that they fit.
  static Case read(const std::vector<std::string>& paths, const Drawing& drawing = {});
  const std::vector<Warning>& warnings() const;
  /// Names of the units of length, mass and time; each empty where the case does not declare it.
  std::vector<std::string> units() const;
  /// The case as a case file of Keyblock (`keyblock formats --schema`).
  std::string json() const;
  /// A value of that file by its JSON pointer (RFC 6901), as JSON: "/analysis/joint_materials/0/friction_angle_deg".
  /// The name of a list item may replace its number; * stands for all items, whose values form a list. Throws
  /// SettingError if the case has no such value.
  std::string get(std::string_view pointer) const;
  /// The JSON pointers that a pointer with names and * stands for. Throws SettingError if there are none.
  std::vector<std::string> pointers(std::string_view pointer) const;
  /// The same case with another value there, given as JSON; also a key that its object lacks. Throws SettingError for a
  /// pointer to nothing, InputError for a key or a value that the file must not have.
  Case with(std::string_view pointer, std::string_view value) const;
  Case with(std::string_view pointer, double value) const;
  /// Writes it in a format of `keyblock convert --to`. Gives in sentences what the format cannot hold, what is added,
  /// and by which other rules a run of it goes. Throws SettingError for no format, Error where a file is there already.
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
  /// Throws InputError, SettingError.
  explicit Plan(const Case& of, const Choices& choices = {}, const Context& context = Context());
  const std::string& profile() const;
  const std::string& why_profile() const;
  std::vector<std::pair<std::string, std::string>> settings() const;  ///< name and value, all
  std::vector<Warning> warnings() const;                              ///< of reading, preparing and looking ahead
  int unknowns() const;
  int blocks() const;  ///< on covers: elements
  int steps() const;

  struct Data;
  const std::shared_ptr<const Data>& data() const { return data_; }

 private:
  std::shared_ptr<const Data> data_;
};

/// A table of numbers, row after row without gaps. Copies share it.
template <class T>
class Column {
 public:
  Column(std::shared_ptr<const std::vector<T>> values, std::size_t width) : values_(std::move(values)), width_(width) {}
  std::size_t rows() const { return values_->size() / width_; }
  std::size_t width() const { return width_; }
  /// Throws Error beyond the last row or column.
  const T& operator()(std::size_t row, std::size_t column = 0) const {
    if (row >= rows() || column >= width_) throw Error("expected a row and a column of the table, found one beyond");
    return (*values_)[row * width_ + column];
  }
  std::span<const T> values() const { return *values_; }

 private:
  std::shared_ptr<const std::vector<T>> values_;
  std::size_t width_;
};

/// One instant as columns, made once; all that is handed out shares them. n blocks (or NMM elements), c contacts,
/// p measured points, t crack tips. `names` lists all columns; most have a function of their own too.
class KEYBLOCK_API Frame {
 public:
  int step() const;
  double time() const;
  double load_factor() const;  ///< by which crack growth multiplies the loads

  /// "blocks", "loops", "corners", "contacts", "bolts", "cracks", "points", "tips".
  static std::vector<std::string> parts();
  /// Columns of a part; none if it has no rows. Throws SettingError for another part.
  std::vector<std::string> names(std::string_view part) const;
  std::size_t rows(std::string_view part) const;
  bool is_integer(std::string_view part, std::string_view name) const;
  /// Names of the numbers of a row, such as "x" and "y"; none for a single number. Throws SettingError for a column that
  /// no frame has.
  std::vector<std::string> components(std::string_view part, std::string_view name) const;
  /// Unit of a column, such as "N/m"; empty for a plain number, and if the case does not declare the units.
  std::string unit(std::string_view part, std::string_view name) const;
  /// Throw SettingError for a column that is not there; without rows each is empty and of width 1.
  Column<double> reals(std::string_view part, std::string_view name) const;
  Column<int> integers(std::string_view part, std::string_view name) const;

  Column<int> number() const { return integers("blocks", "block"); }  ///< n, for the whole run
  Column<int> material() const { return integers("blocks", "material"); }
  Column<double> centroid() const { return reals("blocks", "centroid"); }            ///< n × 2
  Column<double> displacement() const { return reals("blocks", "displacement"); }    ///< n × 2, of centroids
  Column<double> rotation() const { return reals("blocks", "rotation"); }            ///< n, rad, to the left
  Column<double> velocity() const { return reals("blocks", "velocity"); }            ///< n × 2
  Column<double> rotation_rate() const { return reals("blocks", "rotation_rate"); }  ///< n, rad over time
  Column<double> stress() const { return reals("blocks", "stress"); }    ///< n × 4: xx, yy, xy, zz, tension positive
  Column<double> area() const { return reals("blocks", "area"); }        ///< n
  Column<double> vertices() const { return reals("corners", "place"); }  ///< all corners × 2, loop after loop
  Column<int> loop_block() const { return integers("loops", "row"); }    ///< row of the block of each loop
  Column<int> loop_corners() const { return integers("loops", "corners"); }              ///< how many each loop has
  Column<double> point() const { return reals("points", "place"); }                      ///< p × 2
  Column<double> point_displacement() const { return reals("points", "displacement"); }  ///< p × 2
  Column<int> contact_block() const { return integers("contacts", "block"); }            ///< c, number of the block
  Column<int> contact_other() const { return integers("contacts", "other"); }            ///< c, of the other one
  Column<int> contact_state() const { return integers("contacts", "state"); }    ///< c: 0 open, 1 sticks, 2 slides
  Column<double> contact_point() const { return reals("contacts", "place"); }    ///< c × 2
  Column<double> contact_normal() const { return reals("contacts", "normal"); }  ///< c × 2, unit, out of the other
  Column<double> contact_pressure() const { return reals("contacts", "normal_force"); }  ///< c, over thickness
  Column<double> contact_shear() const { return reals("contacts", "shear_force"); }      ///< c, over thickness
  Column<double> contact_gap() const { return reals("contacts", "gap"); }  ///< c, positive where faces are apart

  struct Data;
  explicit Frame(std::shared_ptr<const Data> data) : data_(std::move(data)) {}

 private:
  std::shared_ptr<const Data> data_;
};

/// An accepted step.
struct Step {
  int number = 0;
  double time = 0, dt = 0;
  int systems = 0;      ///< solves of contact forces, or rounds of open and close
  double residual = 0;  ///< out of balance, over the largest load
  double penetration = 0;
};

/// Content of a frame. `corners` adds the displacement of all corners, their stress if it varies within elements, and
/// the faces of cracks.
enum class Detail { blocks, corners };

enum class End { running, finished, stopped, failed, doubtful };

struct Outcome {
  End end = End::running;  ///< doubtful: came to its end, and its numbers cannot be trusted
  std::string reason;      ///< why it failed
  int steps = 0;
  double time = 0;
  double displacement = 0;             ///< the largest of any point at the end, as in run.json
  double speed = 0;                    ///< of the fastest block at the end
  std::vector<std::string> sentences;  ///< how the motion ended
  std::vector<Warning> warnings;       ///< of the plan and the run, doubts among them
  std::vector<Warning> doubts;
};

/// Steps made one at a time. Prints nothing and writes nothing.
class KEYBLOCK_API Run {
 public:
  /// Seeks the start. Throws InputError, Stopped.
  explicit Run(const Plan& plan, const Context& context = Context());
  Run(Run&&) noexcept;
  Run& operator=(Run&&) noexcept;
  ~Run();
  /// Makes one step; false where the run is at its end, stopped or failed, and `outcome` says which.
  bool advance();
  /// To the end, or until `until` is true behind a step: the run may then go on.
  const Outcome& go_on(const std::function<bool(const Run&)>& until = {});
  const Step& last() const;
  Frame frame(Detail detail = Detail::blocks) const;  ///< of now; its contacts are sought when first asked for
  const Outcome& outcome() const;                     ///< `running` before the end
  /// Names of the histories so far: those of `Choices::histories` and of the case.
  std::vector<std::string> histories() const;
  /// Quantities of a history, each with its unit (a letter if the case does not declare it). Throws SettingError.
  std::vector<std::pair<std::string, std::string>> quantities(std::string_view history) const;
  /// Time and value of a quantity, at the start and after each step; long runs keep every n-th step, as their tables
  /// do. Throws SettingError for a history or quantity that is not there.
  Column<double> history(std::string_view history, std::string_view quantity) const;

  struct State;

 private:
  std::unique_ptr<State> state_;
};

/// What `record` writes beside the results that the case asks for.
struct Recording {
  int every = 0;           ///< steps per frame; 0: as the case says, at most 100 frames
  bool overwrite = false;  ///< the results of an earlier run in the folder
  bool pictures = true;
  double checkpoint_every = 30;             ///< seconds; 0: none but at the start and if the run is stopped
  std::vector<std::string> histories = {};  ///< as `keyblock run --history`: "crest=point:16.8,12.8"
  std::string contacts = {};                ///< as `--contacts`: "none", "all", …; empty: as the case says
  std::string frames = "automatic";         ///< coding: "automatic", "raw", "zlib" or "text"
  std::function<void(const Step&)> on_step = {};
};

/// Runs the case to its end with results, tables, frames and pictures in `folder`: all that `keyblock run` leaves
/// there. Throws InputError, SettingError (also for results that may not be overwritten), Error if a file cannot be
/// written. A run that is stopped can be resumed.
KEYBLOCK_API Outcome record(const Case& of, const std::string& folder, const Recording& how = {},
                            const Choices& choices = {}, const Context& context = Context());
/// Continues the run that `record`, or `keyblock run`, of the same build began in `folder`. Throws InputError,
/// SettingError if there is nothing to resume.
KEYBLOCK_API Outcome resume(const std::string& folder, const std::function<void(const Step&)>& on_step = {},
                            const Context& context = Context());

/// A trial of a strength reduction.
struct Trial {
  double factor = 1;
  std::string verdict;  ///< "stands", "falls", "undecided"
  std::string why;
  double displacement = 0;  ///< the largest
};

struct Strength {
  std::optional<double> stands, falls;  ///< the bracket of the factor of safety
  std::string end;                      ///< "bracketed", "falls", "stands", "undecided", "stopped"
  std::vector<Trial> trials;
  std::vector<std::string> notes;
  std::vector<Warning> warnings;  ///< of reading, preparing and looking ahead
};

/// Divides the strength of "joints", "rock" or "both" until the case no longer stands: the search of `keyblock fos`,
/// without its second one on a coarser mesh. If `what` is empty or `within` 0, it is that of the `case.json` of a
/// folder, else "joints" or 0.01. The range of the search and its exemptions are always those of `case.json`. Throws
/// SettingError for another word, or a width below 0.
KEYBLOCK_API Strength factor_of_safety(const Case& of, std::string_view what = {}, double within = 0,
                                       const Choices& choices = {}, const Context& context = Context());

/// A crack tip at the end of the loads.
struct Tip {
  double x = 0, y = 0;              ///< undeformed
  double ahead_x = 0, ahead_y = 0;  ///< of length 1, along the crack into the rock
  double k1 = 0, k2 = 0;            ///< stress intensity, force over length^1.5
  double j = 0;                     ///< energy release rate, force over length
  double kink_deg = 0;              ///< where it would go on, from straight ahead to the left
  double k_equivalent = 0;
  double spread = 0;  ///< of K_I between integration domains, as a share of K
  std::string doubt;  ///< why it cannot be trusted; empty where nothing speaks against it
};

struct Intensity {
  std::vector<Tip> tips;
  std::vector<Warning> warnings;
};

/// Stress intensity factors of all tips, as `keyblock sif`. Throws InputError for a case without cracks.
KEYBLOCK_API Intensity stress_intensity(const Case& of, const Choices& choices = {},
                                        const Context& context = Context());

/// Rows of a Latin hypercube over "KEY=VALUES", as `keyblock sweep --over --random`: a JSON list of objects. The same
/// seed gives the same rows. Throws SettingError.
KEYBLOCK_API std::string random_rows(const std::vector<std::string>& keys, std::size_t count, std::uint64_t seed = 1);

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
