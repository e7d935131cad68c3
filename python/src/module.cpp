// Binds the public library to Python: the module keyblock._keyblock, which the package wraps. Includes nothing of the
// project but the public headers, so that another binding could replace this file.
//
// Columns become NumPy views without copies: a capsule keeps their owner. Computations run without Python's lock. A
// call from the main thread computes on a thread of its own, so that Ctrl-C takes effect. It stops the context, and
// raises KeyboardInterrupt after kPatience at the latest, even if a factorisation still runs behind it.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <keyblock/keyblock.hpp>
#include <keyblock/record.hpp>
#include <keyblock/studies.hpp>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace {

namespace kb = keyblock::api;
namespace py = pybind11;
using namespace std::chrono_literals;

constexpr auto kBetweenLooks = 50ms;  // at the signals of Python
constexpr auto kPatience = 700ms;     // with a computation that was stopped
constexpr auto kQuickStep = 50ms;     // the next step after one that took less needs no thread of its own

std::atomic<int> left_behind{0};  // computations without a waiting caller

bool is_main_thread() {
  return syscall(SYS_gettid) == getpid();
}

struct Task {
  std::mutex mutex;
  std::condition_variable ended;
  bool is_done = false, is_left = false;
  std::exception_ptr error;
};

/// Waits without Python's lock; true once the task is done.
bool is_done_after(Task& task, std::chrono::milliseconds time) {
  const py::gil_scoped_release release;
  std::unique_lock lock(task.mutex);
  return task.ended.wait_for(lock, time, [&] { return task.is_done; });
}

/// Does `work` on a thread of its own. `work` owns all that it uses: it may be left behind.
template <class Work>
void on_own_thread(const kb::Context& context, Work work) {
  auto task = std::make_shared<Task>();
  std::thread([task, work = std::move(work)]() mutable {
    std::exception_ptr error;
    try {
      Work own = std::move(work);  // gone before the caller goes on
      own();
    } catch (...) {
      error = std::current_exception();
    }
    const std::lock_guard lock(task->mutex);
    task->error = error;
    task->is_done = true;
    if (task->is_left) --left_behind;
    task->ended.notify_all();
  }).detach();
  while (!is_done_after(*task, kBetweenLooks)) {
    if (PyErr_CheckSignals() == 0) continue;
    py::error_already_set interrupt;
    context.stop();
    if (!is_done_after(*task, kPatience)) {
      const std::lock_guard lock(task->mutex);
      if (!task->is_done) {
        task->is_left = true;
        ++left_behind;
      }
    }
    throw interrupt;
  }
  if (task->error) std::rethrow_exception(task->error);
}

/// Does `work` without Python's lock and returns its result. Throws what it throws, or KeyboardInterrupt.
template <class Work>
auto computed(const kb::Context& context, Work work) {
  using Result = decltype(work());
  if (!is_main_thread()) {
    const py::gil_scoped_release release;
    return work();
  }
  auto result = std::make_shared<std::optional<Result>>();
  on_own_thread(context, [result, work = std::move(work)] { *result = work(); });
  return std::move(**result);
}

using Pairs = std::vector<std::pair<std::string, std::string>>;

/// A view of the numbers of a column. Without rows it has `width` columns, if that is more than 1.
template <class T>
py::array view_of(const kb::Column<T>& column) {
  std::vector<py::ssize_t> shape{static_cast<py::ssize_t>(column.rows())};
  if (column.width() > 1) shape.push_back(static_cast<py::ssize_t>(column.width()));
  auto owner = std::make_unique<kb::Column<T>>(column);
  const py::capsule keeper(owner.release(), [](void* held) { delete static_cast<kb::Column<T>*>(held); });
  py::array_t<T> view(std::move(shape), column.values().data(), keeper);
  py::detail::array_proxy(view.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;  // other views share it
  return view;
}

/// Computes contacts when they are first asked for.
std::size_t rows_of(const kb::Frame& frame, std::string_view part) {
  const py::gil_scoped_release release;
  return frame.rows(part);
}

py::array column_of(const kb::Frame& frame, std::string_view part, std::string_view name) {
  rows_of(frame, part);
  if (frame.is_integer(part, name)) return view_of(frame.integers(part, name));
  return view_of(frame.reals(part, name));
}

/// A run that several threads of Python may hold.
class Runner {
 private:
  struct Shared {
    std::timed_mutex mutex;
    std::shared_ptr<kb::Run> run;
    std::atomic<bool> is_computing{false};  // on a thread of its own
    std::atomic<bool> is_quick{false};      // the last step was
    bool writes_files = false;              // no step is quick then
    std::atomic<int> waiting{0};            // threads between steps of which `finish` lets one have the run
  };

  struct Computing {
    explicit Computing(std::atomic<bool>& flag) : flag_(flag) { flag_ = true; }
    ~Computing() { flag_ = false; }
    std::atomic<bool>& flag_;
  };

  struct Waiting {
    explicit Waiting(std::atomic<int>& count) : count_(count) { ++count_; }
    ~Waiting() { --count_; }
    std::atomic<int>& count_;
  };

  /// Waits for another thread that uses the run. Throws KeyboardInterrupt.
  std::unique_lock<std::timed_mutex> locked() const {
    const Waiting waiting(shared_->waiting);
    std::unique_lock lock(shared_->mutex, std::try_to_lock);
    const auto is_locked = [&lock] {
      const py::gil_scoped_release release;
      return lock.try_lock_for(kBetweenLooks);
    };
    while (!lock.owns_lock() && !is_locked())
      if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    return lock;
  }

  void require_no_interrupted_work() const {
    if (context_.is_stopped() && shared_->is_computing)
      throw kb::Error("the run was interrupted, and its last computation still ends");
  }

  template <class Work>
  auto with_run(bool is_quick, Work work) {
    require_no_interrupted_work();
    if (is_quick) {
      auto waited = locked();
      const py::gil_scoped_release release;
      const auto lock = std::move(waited);  // ends before Python's lock is taken again
      return work(*shared_->run);
    }
    return computed(context_, [shared = shared_, work] {
      const std::lock_guard lock(shared->mutex);
      const Computing computing(shared->is_computing);
      return work(*shared->run);
    });
  }

 public:
  Runner(const kb::Plan& plan, const kb::Context& context) : context_(context), shared_(std::make_shared<Shared>()) {
    auto run = computed(context, [plan, context] { return std::make_shared<kb::Run>(plan, context); });
    shared_->run = std::move(run);
  }

  /// Holds the run that `make` begins, which writes files.
  template <class Make>
  Runner(const kb::Context& context, Make make) : context_(context), shared_(std::make_shared<Shared>()) {
    auto run = computed(context, [make] { return std::make_shared<kb::Run>(make()); });
    shared_->run = std::move(run);
    shared_->writes_files = true;
  }

  void end_early(const std::string& why) {
    with_run(false, [why](kb::Run& run) {
      run.end_early(why);
      return true;
    });
  }

  bool advance() {
    return with_run(shared_->is_quick, [shared = shared_](kb::Run& run) {
      const auto began = std::chrono::steady_clock::now();
      const bool is_made = run.advance();
      shared->is_quick = !shared->writes_files && std::chrono::steady_clock::now() - began < kQuickStep;
      return is_made;
    });
  }

  /// Makes the steps to the end. Between them other threads may read the run.
  kb::Outcome finish() {
    require_no_interrupted_work();
    return computed(context_, [shared = shared_] {
      const Computing computing(shared->is_computing);
      while (true) {
        {
          const std::lock_guard lock(shared->mutex);
          if (!shared->run->advance()) return shared->run->outcome();
        }
        while (shared->waiting > 0) std::this_thread::yield();
      }
    });
  }

  kb::Frame frame(bool has_corners) {
    return with_run(true, [has_corners](kb::Run& run) {
      return run.frame(has_corners ? kb::Detail::corners : kb::Detail::blocks);
    });
  }

  std::vector<std::string> histories() {
    return with_run(true, [](kb::Run& run) { return run.histories(); });
  }

  Pairs quantities(const std::string& history) {
    return with_run(true, [history](kb::Run& run) { return run.quantities(history); });
  }

  py::array history(const std::string& history, const std::string& quantity) {
    const kb::Column<double> values =
        with_run(true, [history, quantity](kb::Run& run) { return run.history(history, quantity); });
    return view_of(values);
  }

  kb::Case of() {
    return with_run(true, [](kb::Run& run) { return run.of(); });
  }

  kb::Step last() {
    return with_run(true, [](kb::Run& run) { return run.last(); });
  }

  kb::Outcome outcome() {
    return with_run(true, [](kb::Run& run) { return run.outcome(); });
  }

 private:
  kb::Context context_;
  std::shared_ptr<Shared> shared_;
};

const char* name_of(kb::End end) {
  switch (end) {
    case kb::End::running:
      return "running";
    case kb::End::finished:
      return "finished";
    case kb::End::stopped:
      return "stopped";
    case kb::End::failed:
      return "failed";
    case kb::End::doubtful:
      return "doubtful";
  }
  return "";
}

// The types of exceptions live as long as the interpreter.
PyObject* error_type = nullptr;
PyObject* input_error_type = nullptr;
PyObject* setting_error_type = nullptr;
PyObject* stopped_type = nullptr;

PyObject* new_type(py::module_& m, const char* name, const char* doc, const py::handle& base) {
  PyObject* type = PyErr_NewExceptionWithDoc((std::string("keyblock.") + name).c_str(), doc, base.ptr(), nullptr);
  if (!type) throw py::error_already_set();
  m.add_object(name, type);
  return type;
}

/// Text of Python. Names of files may have bytes that are not UTF-8.
py::str text_of(const std::string& text) {
  PyObject* made = PyUnicode_DecodeUTF8(text.data(), static_cast<py::ssize_t>(text.size()), "surrogateescape");
  if (!made) throw py::error_already_set();
  return py::reinterpret_steal<py::str>(made);
}

/// Returns the argument of Python for a choice of the library.
std::string argument_of(const std::string& choice) {
  return choice == "histories" ? "history" : choice == "Recording::overwrite" ? "force=True" : choice;
}

PyObject* type_of(kb::ErrorCode code) {
  switch (code) {
    case kb::ErrorCode::input:
      return input_error_type;
    case kb::ErrorCode::choice:
      return setting_error_type;
    case kb::ErrorCode::stopped:
      return stopped_type;
    default:
      return error_type;
  }
}

/// Raises the type of the code. Arguments of Python replace choices of the library.
void raise(const kb::Error& error) {
  const bool is_input = error.code == kb::ErrorCode::input;
  std::string message = error.what(), file = error.place.file;
  if (const std::string& choice = error.place.choice; !choice.empty()) {
    const std::string word = argument_of(choice) + (is_input ? "=" : "");
    message.replace(error.choice_at, choice.size() + (is_input ? 1 : 0), word);
    file = word + file;
  }
  PyObject* const type = type_of(error.code);
  const py::object raised = py::reinterpret_borrow<py::object>(type)(text_of(message));
  if (is_input) {
    raised.attr("file") = text_of(file);
    raised.attr("line") = error.place.line;
    raised.attr("column") = error.place.column;
  }
  PyErr_SetObject(type, raised.ptr());
}

void bind_errors(py::module_& m) {
  error_type = new_type(m, "Error", "Base of the errors of this package.", PyExc_RuntimeError);
  const py::handle base(error_type);
  input_error_type = new_type(m, "InputError",
                              "Input that cannot be used. `file`, `line` and `column` name the place; line and column "
                              "count from 1, 0 means the file as a whole.",
                              base);
  setting_error_type = new_type(m, "SettingError", "An unknown setting, profile or pointer.", base);
  stopped_type = new_type(m, "Stopped", "Raised by a computation that was stopped before it had a result.", base);
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const kb::Error& error) {
      raise(error);
    }
  });
}

py::dict dict_of(const std::vector<std::pair<std::string, double>>& numbers) {
  py::dict found;
  for (const auto& [name, value] : numbers) found[py::str(name)] = value;
  return found;
}

/// Pickles a struct of plain members.
template <class T, class... Members>
auto pickled(Members T::*... members) {
  return py::pickle([=](const T& value) { return py::make_tuple(value.*members...); },
                    [=](const py::tuple& state) {
                      T value;
                      std::size_t i = 0;
                      ((value.*members = state[i++].cast<Members>()), ...);
                      return value;
                    });
}

void bind_parts_of_values(py::module_& m) {
  py::class_<kb::Place>(m, "_Place")
      .def(pickled(&kb::Place::file, &kb::Place::line, &kb::Place::column, &kb::Place::choice));
  py::class_<kb::Facts>(m, "_Facts")
      .def(pickled(&kb::Facts::numbers, &kb::Facts::blocks, &kb::Facts::points, &kb::Facts::names));
  py::enum_<kb::End>(m, "_End")
      .value("running", kb::End::running)
      .value("finished", kb::End::finished)
      .value("stopped", kb::End::stopped)
      .value("failed", kb::End::failed)
      .value("doubtful", kb::End::doubtful);
}

void bind_values(py::module_& m) {
  py::class_<kb::Warning>(m, "Warning", "A likely mistake or a doubt, with a stable code and its place.")
      .def_readonly("code", &kb::Warning::code, "Stable word; `keyblock explain CODE` gives the remedy.")
      .def_readonly("sentence", &kb::Warning::sentence, "The warning as text.")
      .def_readonly("level", &kb::Warning::level, "error, warning, note or silent.")
      .def_property_readonly(
          "numbers", [](const kb::Warning& w) { return dict_of(w.facts.numbers); },
          "Values behind the sentence, by name.")
      .def_property_readonly(
          "blocks", [](const kb::Warning& w) { return w.facts.blocks; }, "Blocks or elements, from 1.")
      .def_property_readonly(
          "points", [](const kb::Warning& w) { return w.facts.points; }, "Points of the sentence, x and y [length].")
      .def_property_readonly(
          "names", [](const kb::Warning& w) { return w.facts.names; },
          "Names in the sentence: list of (kind, name), such as (\"layer\", \"Bedding\").")
      .def_property_readonly(
          "file", [](const kb::Warning& w) { return text_of(w.place.file); }, "File; empty without one.")
      .def_property_readonly(
          "line", [](const kb::Warning& w) { return w.place.line; }, "Line, from 1; 0 means the file as a whole.")
      .def_property_readonly(
          "column", [](const kb::Warning& w) { return w.place.column; }, "Column, from 1; 0 means the whole line.")
      .def("__str__",
           [](const kb::Warning& w) {
             std::string place = w.place.file;
             if (w.place.line > 0) place += ":" + std::to_string(w.place.line) + ":" + std::to_string(w.place.column);
             const std::string level = w.level == "silent" ? "note" : w.level;
             return text_of((place.empty() ? "" : place + ": ") + level + ": " + w.sentence + " [" + w.code + "]");
           })
      .def(pickled(&kb::Warning::code, &kb::Warning::sentence, &kb::Warning::place, &kb::Warning::level,
                   &kb::Warning::facts))
      .def("__repr__", [](const kb::Warning& w) { return "<Warning " + w.code + ">"; });
  py::class_<kb::Step>(m, "Step", "An accepted step.")
      .def_readonly("number", &kb::Step::number, "Number of the step, from 1; 0 means the initial state.")
      .def_readonly("time", &kb::Step::time, "Time at the end of the step [time].")
      .def_readonly("dt", &kb::Step::dt, "Size of the step [time].")
      .def_readonly("systems", &kb::Step::systems, "Solves of contact forces, or open-close iterations.")
      .def_readonly("residual", &kb::Step::residual, "Largest force out of balance, divided by the largest load.")
      .def_readonly("penetration", &kb::Step::penetration, "Deepest overlap of two blocks [length].")
      .def(pickled(&kb::Step::number, &kb::Step::time, &kb::Step::dt, &kb::Step::systems, &kb::Step::residual,
                   &kb::Step::penetration))
      .def("__repr__", [](const kb::Step& s) {
        return "<Step " + std::to_string(s.number) + ", time " + std::to_string(s.time) + ">";
      });
  py::class_<kb::Outcome>(m, "Outcome", "End of a run, its reason and its doubts.")
      .def_property_readonly(
          "end", [](const kb::Outcome& o) { return name_of(o.end); },
          "running, finished, stopped, failed, or doubtful: it finished, and its results are unreliable.")
      .def_readonly("reason", &kb::Outcome::reason, "Reason of a failure.")
      .def_readonly("failure", &kb::Outcome::failure, "no_equilibrium, undecided or cracks; empty without a failure.")
      .def_readonly("cause", &kb::Outcome::cause, "Code of the reason, such as contacts_do_not_settle.")
      .def_property_readonly(
          "numbers", [](const kb::Outcome& o) { return dict_of(o.facts.numbers); },
          "Values behind the reason, by name.")
      .def_property_readonly(
          "blocks", [](const kb::Outcome& o) { return o.facts.blocks; }, "Blocks or elements that failed, from 1.")
      .def_property_readonly(
          "points", [](const kb::Outcome& o) { return o.facts.points; }, "Points behind the reason, x and y [length].")
      .def_readonly("steps", &kb::Outcome::steps, "Number of accepted steps.")
      .def_readonly("time", &kb::Outcome::time, "Time that the run has reached [time].")
      .def_readonly("displacement", &kb::Outcome::displacement,
                    "Largest displacement of any corner of a block or element at the end, from the case as drawn "
                    "[length]; nan before the end.")
      .def_readonly("speed", &kb::Outcome::speed, "Speed of the fastest block at the end [length/time]; nan before it.")
      .def_readonly("sentences", &kb::Outcome::sentences, "How the motion ended.")
      .def_readonly("warnings", &kb::Outcome::warnings, "Warnings of the plan and the run, with the doubts.")
      .def_readonly("doubts", &kb::Outcome::doubts, "Reasons not to trust the results.")
      .def(pickled(&kb::Outcome::end, &kb::Outcome::reason, &kb::Outcome::failure, &kb::Outcome::cause,
                   &kb::Outcome::facts, &kb::Outcome::steps, &kb::Outcome::time, &kb::Outcome::displacement,
                   &kb::Outcome::speed, &kb::Outcome::sentences, &kb::Outcome::warnings, &kb::Outcome::doubts))
      .def("__repr__", [](const kb::Outcome& o) {
        return "<Outcome " + std::string(name_of(o.end)) + ", " + std::to_string(o.steps) + " steps>";
      });
}

void bind_studies(py::module_& m) {
  py::class_<kb::Trial>(m, "Trial", "One trial of a strength reduction.")
      .def_readonly("factor", &kb::Trial::factor, "Factor by which the strength was divided.")
      .def_readonly("verdict", &kb::Trial::verdict, "stands, falls or undecided.")
      .def_readonly("why", &kb::Trial::why, "Reason for the verdict; may be empty.")
      .def_readonly("displacement", &kb::Trial::displacement, "Largest displacement of the trial [length].")
      .def(pickled(&kb::Trial::factor, &kb::Trial::verdict, &kb::Trial::why, &kb::Trial::displacement))
      .def("__repr__", [](const kb::Trial& t) { return "<Trial " + std::to_string(t.factor) + " " + t.verdict + ">"; });
  py::class_<kb::Strength>(m, "Strength", "Factor of safety: the bracket and its trials.")
      .def_readonly("stands", &kb::Strength::stands, "Largest factor at which the case is stable, or None.")
      .def_readonly("falls", &kb::Strength::falls, "Smallest factor at which the case is unstable, or None.")
      .def_readonly("profile", &kb::Strength::profile)
      .def_readonly("why_profile", &kb::Strength::why_profile, "Reason for the profile.")
      .def_readonly("settings", &kb::Strength::settings, "Names and values of all settings, those of the trials.")
      .def_readonly("unknowns", &kb::Strength::unknowns, "Number of unknowns.")
      .def_readonly("end", &kb::Strength::end, "bracketed, falls, stands, undecided or stopped.")
      .def_readonly("trials", &kb::Strength::trials)
      .def_readonly("notes", &kb::Strength::notes)
      .def_readonly("warnings", &kb::Strength::warnings)
      .def_readonly("standing", &kb::Strength::standing, "Frame at `stands`, or None.")
      .def_readonly("falling", &kb::Strength::falling, "Frame at `falls`, or None.");
  py::class_<kb::Tip>(m, "Tip", "A crack tip at the end of the loads.")
      .def_readonly("x", &kb::Tip::x, "Place in the undeformed body [length].")
      .def_readonly("y", &kb::Tip::y, "Place in the undeformed body [length].")
      .def_readonly("ahead_x", &kb::Tip::ahead_x, "Direction of length 1, along the crack into the rock.")
      .def_readonly("ahead_y", &kb::Tip::ahead_y, "Direction of length 1, along the crack into the rock.")
      .def_readonly("k1", &kb::Tip::k1, "Stress intensity, mode I [force/length^1.5].")
      .def_readonly("k2", &kb::Tip::k2, "Stress intensity, mode II [force/length^1.5].")
      .def_readonly("j", &kb::Tip::j, "Energy release rate [force/length].")
      .def_readonly("kink_deg", &kb::Tip::kink_deg, "Direction of growth, from straight ahead to the left [deg].")
      .def_readonly("k_equivalent", &kb::Tip::k_equivalent,
                    "Stress intensity of a tip in mode I that is as near to growth; 0 means closed [force/length^1.5].")
      .def_readonly("spread", &kb::Tip::spread, "Difference of K_I between integration domains, over K.")
      .def_readonly("doubt", &kb::Tip::doubt, "Reason not to trust it, or empty.")
      .def(
          "asdict",
          [](const kb::Tip& t) {
            using namespace py::literals;
            return py::dict("x"_a = t.x, "y"_a = t.y, "ahead_x"_a = t.ahead_x, "ahead_y"_a = t.ahead_y, "k1"_a = t.k1,
                            "k2"_a = t.k2, "j"_a = t.j, "kink_deg"_a = t.kink_deg, "k_equivalent"_a = t.k_equivalent,
                            "spread"_a = t.spread, "doubt"_a = t.doubt);
          },
          "Returns the numbers and the doubt as a dict.")
      .def(pickled(&kb::Tip::x, &kb::Tip::y, &kb::Tip::ahead_x, &kb::Tip::ahead_y, &kb::Tip::k1, &kb::Tip::k2,
                   &kb::Tip::j, &kb::Tip::kink_deg, &kb::Tip::k_equivalent, &kb::Tip::spread, &kb::Tip::doubt));
  py::class_<kb::Intensity>(m, "Intensity", "Stress intensity factors of all crack tips.")
      .def_readonly("tips", &kb::Intensity::tips)
      .def_readonly("profile", &kb::Intensity::profile)
      .def_readonly("why_profile", &kb::Intensity::why_profile, "Reason for the profile.")
      .def_readonly("settings", &kb::Intensity::settings, "Names and values of all settings.")
      .def_readonly("unknowns", &kb::Intensity::unknowns, "Number of unknowns.")
      .def_readonly("warnings", &kb::Intensity::warnings);
  m.def(
      "factor_of_safety",
      [](const kb::Case& of, const std::string& what, double within, const std::string& profile, const Pairs& settings,
         const kb::Context& context) {
        return computed(context, [=] { return kb::factor_of_safety(of, what, within, {profile, settings}, context); });
      },
      py::arg("case"), py::arg("what"), py::arg("within"), py::arg("profile"), py::arg("settings"), py::arg("context"));
  m.def(
      "stress_intensity",
      [](const kb::Case& of, const std::string& profile, const Pairs& settings, const kb::Context& context) {
        return computed(context, [=] { return kb::stress_intensity(of, {profile, settings}, context); });
      },
      py::arg("case"), py::arg("profile"), py::arg("settings"), py::arg("context"));
}

void bind_records(py::module_& m) {
  m.def(
      "record",
      [](const kb::Case& of, const std::string& folder, int every, bool overwrite, bool pictures,
         double checkpoint_every, const std::vector<std::string>& histories, const std::string& contacts,
         const std::string& frames, const std::string& profile, const Pairs& settings, const kb::Context& context) {
        const kb::Recording how{every, overwrite, pictures, checkpoint_every, histories, contacts, frames, {}};
        return computed(context, [=] { return kb::record(of, folder, how, {profile, settings}, context); });
      },
      py::arg("case"), py::arg("folder"), py::arg("every"), py::arg("overwrite"), py::arg("pictures"),
      py::arg("checkpoint_every"), py::arg("histories"), py::arg("contacts"), py::arg("frames"), py::arg("profile"),
      py::arg("settings"), py::arg("context"));
  m.def(
      "resume",
      [](const std::string& folder, const kb::Context& context) {
        return computed(context, [=] { return kb::resume(folder, {}, context); });
      },
      py::arg("folder"), py::arg("context"));
}

/// Returns a function of a case and a pointer that computes as `computed` does.
template <class Result>
auto in_background(Result (kb::Case::*function)(std::string_view) const) {
  return [function](const kb::Case& of, const std::string& pointer) {
    return computed(kb::Context(), [=] { return (of.*function)(pointer); });
  };
}

void bind_case(py::module_& m) {
  py::class_<kb::Case>(m, "Case")
      .def_static(
          "read",
          [](const std::vector<std::string>& paths, const std::string& unit, double join) {
            return computed(kb::Context(), [=] { return kb::Case::read(paths, {unit, join}); });
          },
          py::arg("paths"), py::arg("unit") = "", py::arg("join") = 0)
      .def_property_readonly("warnings", &kb::Case::warnings)
      .def_property_readonly("units", &kb::Case::units)
      .def_property_readonly("profile", &kb::Case::profile)
      .def("json", [](const kb::Case& of) { return computed(kb::Context(), [of] { return of.json(); }); })
      .def("get", in_background(&kb::Case::get), py::arg("pointer"))
      .def("pointers", in_background(&kb::Case::pointers), py::arg("pointer"))
      .def(
          "with_json",
          [](const kb::Case& of, const std::string& pointer, const std::string& value) {
            return computed(kb::Context(), [=] { return of.with(pointer, std::string_view(value)); });
          },
          py::arg("pointer"), py::arg("value"))
      .def(
          "write",
          [](const kb::Case& of, const std::string& path, const std::string& format) {
            return computed(kb::Context(), [=] { return of.write(path, format); });
          },
          py::arg("path"), py::arg("format"));
  py::class_<kb::Plan>(m, "Plan")
      .def(py::init([](const kb::Case& of, const std::string& profile, const Pairs& settings,
                       const std::vector<std::string>& histories, const kb::Context& context) {
             return computed(context, [=] { return kb::Plan(of, {profile, settings, histories}, context); });
           }),
           py::arg("case"), py::arg("profile"), py::arg("settings"), py::arg("histories"), py::arg("context"))
      .def_property_readonly("profile", &kb::Plan::profile)
      .def_property_readonly("why_profile", &kb::Plan::why_profile)
      .def_property_readonly("settings", &kb::Plan::settings)
      .def_property_readonly("warnings", &kb::Plan::warnings)
      .def_property_readonly("unknowns", &kb::Plan::unknowns)
      .def_property_readonly("blocks", &kb::Plan::blocks)
      .def_property_readonly("steps", &kb::Plan::steps)
      .def_property_readonly("step_times", &kb::Plan::step_times);
}

void bind_run(py::module_& m) {
  py::class_<kb::Frame>(m, "Frame")
      .def_property_readonly("step", &kb::Frame::step)
      .def_property_readonly("time", &kb::Frame::time)
      .def_property_readonly("load_factor", &kb::Frame::load_factor)
      .def_property_readonly("epoch", &kb::Frame::epoch)
      .def_static("parts", &kb::Frame::parts)
      .def("names", &kb::Frame::names, py::arg("part"), py::call_guard<py::gil_scoped_release>())
      .def("rows", &rows_of, py::arg("part"))
      .def("components", &kb::Frame::components, py::arg("part"), py::arg("name"),
           py::call_guard<py::gil_scoped_release>())
      .def("unit", &kb::Frame::unit, py::arg("part"), py::arg("name"))
      .def("column", &column_of, py::arg("part"), py::arg("name"));
  py::class_<Runner>(m, "Run")
      .def(py::init<const kb::Plan&, const kb::Context&>(), py::arg("plan"), py::arg("context"))
      .def_static(
          "recorded",
          [](const kb::Case& of, const std::string& folder, int every, bool overwrite, bool pictures,
             double checkpoint_every, const std::vector<std::string>& histories, const std::string& contacts,
             const std::string& frames, const std::string& profile, const Pairs& settings, const kb::Context& context) {
            const kb::Recording how{every, overwrite, pictures, checkpoint_every, histories, contacts, frames, {}};
            return std::make_unique<Runner>(context, [=] {
              return kb::recorded(of, folder, how, {profile, settings}, context);
            });
          },
          py::arg("case"), py::arg("folder"), py::arg("every"), py::arg("overwrite"), py::arg("pictures"),
          py::arg("checkpoint_every"), py::arg("histories"), py::arg("contacts"), py::arg("frames"), py::arg("profile"),
          py::arg("settings"), py::arg("context"))
      .def_static(
          "resumed",
          [](const std::string& folder, const kb::Context& context) {
            return std::make_unique<Runner>(context, [=] { return kb::resumed(folder, context); });
          },
          py::arg("folder"), py::arg("context"))
      .def_property_readonly("case", &Runner::of)
      .def("end_early", &Runner::end_early, py::arg("why"))
      .def("advance", &Runner::advance)
      .def("finish", &Runner::finish)
      .def("frame", &Runner::frame, py::arg("corners"))
      .def("histories", &Runner::histories)
      .def("quantities", &Runner::quantities, py::arg("history"))
      .def("history", &Runner::history, py::arg("history"), py::arg("quantity"))
      .def_property_readonly("last", &Runner::last)
      .def_property_readonly("outcome", &Runner::outcome);
}

}  // namespace

PYBIND11_MODULE(_keyblock, m) {
  m.doc() = "The public library of Keyblock; the package keyblock wraps it.";
  bind_errors(m);
  bind_parts_of_values(m);
  bind_values(m);
  py::class_<kb::Context>(m, "Context")
      .def(py::init<int>(), py::arg("threads") = 0)
      .def("stop", &kb::Context::stop)
      .def_property_readonly("is_stopped", &kb::Context::is_stopped)
      .def_property_readonly("headway", &kb::Context::headway);
  bind_case(m);
  bind_run(m);
  bind_records(m);
  bind_studies(m);
  m.def("random_rows", &kb::random_rows, py::arg("keys"), py::arg("count"), py::arg("seed"));
  m.def("version", &kb::version);
  m.def("build", &kb::build);
  m.def("commit", &kb::commit);
  m.def("compiler", &kb::compiler);
  m.def(
      "left_behind", [] { return left_behind.load(); }, "Number of computations that an interrupt left running.");
}
