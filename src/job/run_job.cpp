// Steps a run: the record grows with every step, the folder with every frame.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "job/run_job.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/context.hpp"
#include "base/counted.hpp"
#include "base/decimals.hpp"
#include "base/error.hpp"
#include "base/sentences/sentences.hpp"
#include "job/ledger_report.hpp"
#include "job/page/run_page.hpp"
#include "job/run_report.hpp"
#include "job/step_tables.hpp"
#include "model/continuum.hpp"
#include "run/steppers.hpp"

namespace keyblock {
namespace {

// Tables are written during the run, and take at most a fiftieth of its time.
constexpr std::chrono::seconds kTablesEvery{5};
constexpr int kLeastPause = 50;

RunFolder folder_for(const RunJobOptions& options, const Units& units, bool goes_on) {
  return goes_on ? RunFolder(options.folder, options.trace, units)
                 : RunFolder(options.folder, options.overwrite, options.trace, units);
}

std::vector<int> numbers_of(const std::vector<ElementIndex>& elements) {
  std::vector<int> numbers;
  for (const ElementIndex e : elements) numbers.push_back(e.value);
  return numbers;
}

// Uses the words of the legend of the picture.
std::string what_failed_does(const RunOutcome& outcome, const Scene& scene) {
  const char* const noun = scene.model.nodes.empty() ? "block" : "element";
  const std::string blocks = outcome.elements.size() == 1 ? fmt::format("{} {}", noun, outcome.numbers.front())
                                                          : counted(outcome.elements.size(), noun);
  const char* const does = outcome.failure == FailureKind::inside_out ? "turned inside out"
                           : scene.settings.dynamics == Dynamics::shi ? "too far for a step"
                           : !is_of_the_scene(outcome.failure)        ? "no rest"
                                                                      : "no equilibrium";
  return fmt::format("{}: {}", blocks, does);
}

formats::FrameStage stage_of(const Stepper& stepper, bool is_static, const Frame& frame) {
  formats::FrameStage stage{{}, is_static, stepper.load_share()};
  if (const std::vector<SceneReport> scenes = stepper.scenes(); !scenes.empty()) stage.name = scenes.back().name;
  if (const Model& model = stepper.model(); model.continuum && !model.continuum->cracks.empty())
    stage.load_factor = frame.load_factor;
  return stage;
}

// The list is by number of element, loop after loop. Edges inside a body belong to no joint.
std::vector<std::vector<int>> joints_of_edges(const Model& model) {
  std::vector<std::vector<int>> joints;
  for (const ElementIndex e : indices(model.elements)) {
    const auto number = static_cast<std::size_t>(model.identities.of_element(e.value).number);
    if (number >= joints.size()) joints.resize(number + 1);
    for (const VertexIndex v : model.elements[e].vertices())
      joints[number].push_back(model.vertices[v].is_inner ? -1 : model.vertices[v].joint_material);
  }
  return joints;
}

// Tables that grow with each history and each measured point. The warning comes before the run, which may be long.
Warnings large_tables(const Prepared& prepared, const Followed& followed, const RunJobOptions& options) {
  constexpr double kMegabyte = 1e6;
  constexpr double kLarge = 100;         // megabytes
  constexpr double kBytesOfPoint = 170;  // of one instant, in history.csv and points.csv
  const int steps = prepared.scene.settings.step_count;
  const double points = static_cast<double>(prepared.scene.model.measured_points.size());
  const double rows = 1.0 + steps / stride_of(steps);
  const double of_points = points * kBytesOfPoint * rows / kMegabyte;
  const double of_histories = followed.bytes_of_row() * rows / kMegabyte;
  if (of_points + of_histories < kLarge) return {};
  return {warning_of({"tables_large",
                      {{{"megabytes", of_points + of_histories},
                        {"of_histories", of_histories},
                        {"histories", options.outputs.histories.size()},
                        {"of_points", of_points},
                        {"points", points}}}},
                     options.place)};
}

Warnings thinned_tables(const RunFolder& folder, const RunJobOptions& options) {
  if (folder.frame_tables().thinned_every() < 2) return {};
  return {warning_of({"contacts_thinned",
                      {{{"rows", folder.frame_tables().expected_rows()},
                        {"most", kMostContactRows},
                        {"every", options.outputs.contacts_every * folder.frame_tables().thinned_every()}}}},
                     options.place)};
}

RunTables tables_of(const History& history, const RunRecord& record, const LedgerScope& scope) {
  const Ledger ledger{scope, record.ledger.rows()};
  return {history, step_table_csv(record.steps.rows(), record.units),
          ledger.rows.empty() ? std::string() : ledger_csv(ledger, record.ledger_sums, record.units)};
}

}  // namespace

RunJob::RunJob(const Prepared& prepared, RunRecord record, RunRequest request, RunJobOptions options, Archive* saved)
    : prepared_(prepared),
      request_(std::move(request)),
      options_(std::move(options)),
      saved_(saved),
      folder_(folder_for(options_, record.units, saved != nullptr)),
      account_(std::make_shared<RunAccount>(prepared, std::move(record), options_.outputs.histories, options_.place)),
      history_{!prepared.scene.model.measured_points.empty(), {}, stride_of(prepared.scene.settings.step_count)},
      clock_(options_.checkpoint_every),
      tables_due_(std::chrono::steady_clock::now() + kTablesEvery) {
  choose_outputs();
  Warnings& warnings = account_->record().warnings;
  warnings = joined(warnings, large_tables(prepared_, account_->followed(), options_));
}

void RunJob::choose_outputs() {
  const OutputPlan& plan = options_.outputs;
  require_choice(plan);
  const int frames = 1 + prepared_.scene.settings.step_count / std::max(1, account_->record().record_every);
  folder_.choose_frames(prepared_.scene.model.block_materials, options_.frames);
  folder_.choose_contacts({plan.contacts, plan.contacts_every,
                           [this](const ContactFrame& contact) { return account_->followed().follows(contact); },
                           frames});
}

// A stop of the context ends the run with a checkpoint, so that it can go on.
void RunJob::stop_if_met(const Stepper& stepper) {
  if (!options_.stop_when || !criterion_met_.empty()) return;
  criterion_met_ = options_.stop_when->met_by(account_->values(stepper));
  if (!criterion_met_.empty()) context().stop();
}

void RunJob::open() {
  if (saved_ == nullptr) return folder_.begin(bytes_before_steps(request_));
  if (holds_steps(*saved_)) {
    describe_told(*saved_, folder_, history_, *account_);
    saved_->group("stepper", [&] { stepper_ = restored_stepper(prepared_.scene, *saved_); });
    steps_before_ = stepper_->state().step;
    joints_of_edges_ = joints_of_edges(stepper_->model());
  }
  folder_.drop_what_followed();
}

void RunJob::write_checkpoint(Stepper& stepper) {
  if (context().is_stopped() || clock_.is_due()) save(stepper);
}

void RunJob::save(Stepper& stepper) {
  folder_.write_checkpoint(saved_bytes(request_, folder_, history_, *account_, stepper));
  clock_.written();
}

// Whole files are written each time, so the pause before the next is long in a long run.
void RunJob::write_tables(const LedgerScope& scope) {
  const auto begun = std::chrono::steady_clock::now();
  if (begun < tables_due_) return;
  folder_.write_tables(tables_of(history_, account_->record(), scope));
  const auto ended = std::chrono::steady_clock::now();
  tables_due_ = ended + std::max<std::chrono::steady_clock::duration>(kTablesEvery, kLeastPause * (ended - begun));
}

Observer RunJob::observer() {
  return {[&](Frame frame) {
            account_->add(frame, stepper_->model());
            formats::FrameStage stage = stage_of(*stepper_, account_->is_static(), frame);
            folder_.add(std::move(frame), std::exchange(field_, {}), account_->contacts(), std::move(stage));
          },
          [&](const StepReport& report) {
            account_->add(report);
            if (options_.trace == Trace::yes) account_->record().traced.push_back(report);
            last_ = report;
          },
          [&](const HistoryRow& row) { history_.add(row); },
          [&](const LedgerRow& row) { account_->add(row); },
          [&](Stepper& stepper) {
            if (!history_.rows.empty()) write_tables(stepper.ledger_scope());
            write_checkpoint(stepper);
          },
          [&](FieldFrame field) { field_ = std::move(field); },
          [&](const ContactFrames& contacts) {
            account_->add(contacts, stepper_->model());
            joints_of_edges_ = joints_of_edges(stepper_->model());
          },
          [&](const Stepper& stepper) {
            account_->add(stepper);
            const State& now = stepper.state();
            if (account_->has_row(now.step))
              folder_.add_histories(history_lines(account_->values(stepper), now.step, now.time));
            stop_if_met(stepper);
            if (calls_.on_state) calls_.on_state(stepper);
          }};
}

template <class Work>
void RunJob::taking_back(const Work& work) {
  try {
    work();
  } catch (const StopRequested&) {
    account_->record().outcome.end = RunEnd::stopped;
    throw;
  } catch (const InputError&) {
    if (saved_ == nullptr) folder_.take_back();
    throw;
  }
}

void RunJob::start(RunCalls calls) {
  calls_ = std::move(calls);
  told_ = observer();
  taking_back([&] {
    const bool is_new = stepper_ == nullptr;
    if (is_new) stepper_ = stepper_for(prepared_.scene);
    loop_.emplace(prepared_.scene, *stepper_, account_->record().record_every, told_);
    if (is_new) loop_->tell_start();
  });
}

// If the caller throws, tables are whole, and the run can be resumed from this step.
void RunJob::tell_caller() {
  if (!calls_.on_step) return;
  try {
    calls_.on_step(last_);
  } catch (...) {
    save(*stepper_);
    throw;
  }
}

bool RunJob::step() {
  bool is_made = false;
  taking_back([&] {
    is_made = loop_->step();
    if (is_made) tell_caller();
  });
  return is_made;
}

// The last step has a row, as in the other tables, wherever the run ends. It follows what a checkpoint saves, so that a
// resumed run drops it.
void RunJob::end() {
  RunOutcome& outcome = account_->record().outcome;
  outcome = loop_->end();
  if (const State& now = stepper_->state(); account_->lacks_row(now.step))
    folder_.add_histories(history_lines(account_->values(*stepper_), now.step, now.time));
  if (outcome.end == RunEnd::stopped) outcome.why_early = criterion_met_;
  loop_.reset();
  stepper_.reset();
}

void RunJob::end_early(const std::string& why) {
  criterion_met_ = why;
  context().stop();
}

bool RunJob::run(const std::function<void(const StepReport&)>& on_step) {
  try {
    start({on_step});
    while (step()) {
    }
    end();
    return true;
  } catch (const StopRequested&) {
    return false;
  }
}

namespace {

// Returns the bolts without properties in all scenes of the run.
std::vector<int> idle_bolts(const Scene& first) {
  std::set<int> numbers;
  for (const Scene* scene : scenes_of(first))
    for (std::size_t i = 0; i < scene->model.bolts.size(); ++i) {
      const Bolt& bolt = scene->model.bolts[i];
      if (!bolt.is_spring() && bolt.pretension == 0) numbers.insert(scene->model.identities.of_bolt(i));
    }
  return {numbers.begin(), numbers.end()};
}

// Returns the fixed blocks. NMM bodies are left out: the load on one of their elements is known.
std::vector<int> held_blocks(const Frame& end) {
  if (!end.outlines.empty()) return {};
  std::set<int> numbers;
  for (const PointFrame& point : end.fixed_points) numbers.insert(point.element);
  return {numbers.begin(), numbers.end()};
}

// Returns fixed points, loading points and held edges of blocks before the first step; of more than `kMostSupports` of
// a kind every n-th.
std::vector<SupportRecord> supports_of(const Frame& start, const Model& model) {
  constexpr std::size_t kMostSupports = 500;
  std::vector<SupportRecord> supports;
  const auto add = [&](const char* kind, const std::vector<PointFrame>& points) {
    const std::size_t every = 1 + points.size() / kMostSupports;
    for (std::size_t i = 0; i < points.size(); i += every)
      supports.push_back({kind, points[i].position - points[i].displacement, points[i].element + 1});
  };
  add("fixed_point", start.fixed_points);
  add("loading_point", start.loading_points);
  const std::vector<SupportRow>& rows = model.support_rows;
  for (std::size_t i = 0; i < rows.size(); i += 1 + rows.size() / kMostSupports)
    supports.push_back({"held_edge", rows[i].start, model.number_of(rows[i].element), rows[i].direction});
  return supports;
}

}  // namespace

std::string RunJob::finish(const std::string& title, double seconds) {
  RunRecord& record = account_->record();
  record.timings.run = to_microseconds(seconds);
  record.reactions = reaction_curves(history_);
  record.warnings = joined(record.warnings, thinned_tables(folder_, options_));
  account_->judge(folder_.first_frame(), folder_.last_frame());
  record.held = held_blocks(folder_.last_frame());
  record.names = options_.names;
  record.supports = supports_of(folder_.first_frame(), prepared_.scene.model);
  record.left_out = folder_.finish({title,
                                    tables_of(history_, record, record.outcome.ledger_scope),
                                    record.traced,
                                    {record.outcome.ledger_scope, record.ledger.rows()},
                                    record.outcome.field,
                                    !prepared_.scene.is_untouched,
                                    numbers_of(record.outcome.elements),
                                    what_failed_does(record.outcome, prepared_.scene),
                                    !account_->followed().is_empty(),
                                    joints_of_edges_,
                                    options_.names.rocks,
                                    options_.names.joints,
                                    idle_bolts(prepared_.scene),
                                    record.held,
                                    options_.has_pictures,
                                    options_.has_page,
                                    options_.shown});
  record.outputs = folder_.outputs();
  record.checksums = folder_.checksums();
  const std::string json =
      run_json(prepared_, record).dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
  std::function<std::string()> page;
  if (options_.has_page) page = [this] { return run_page(options_.folder); };
  folder_.write_record(json + "\n", page);
  if (record.outcome.end != RunEnd::stopped) folder_.remove_checkpoint();
  return json;
}

}  // namespace keyblock
