// Steps a run on request of the caller, with the checks and the judgement of `keyblock run`.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <optional>

#include "formats/tables/run_tables.hpp"
#include "job/ledger_report.hpp"
#include "job/run_doubts.hpp"
#include "job/run_report.hpp"
#include "job/run_warnings.hpp"
#include "job/verdict/end_of_motion.hpp"
#include "library/run_state.hpp"
#include "problem/units/measure.hpp"
#include "run/follow/followed.hpp"
#include "run/record.hpp"
#include "run/steppers.hpp"

namespace keyblock::api {
namespace {

void put_failure(Outcome& outcome, const RunOutcome& run) {
  if (run.end != RunEnd::failed) return;
  outcome.reason = run.reason;
  outcome.failure = word_for(run.failure);
  outcome.cause = run.cause.code();
  outcome.facts = public_facts(run.cause.facts);
  outcome.facts.blocks = run.numbers.empty() ? run.cause.facts.elements : run.numbers;
}

}  // namespace

Outcome outcome_of(const Prepared& prepared, const RunRecord& record) {
  Outcome outcome;
  outcome.end = record.outcome.end == RunEnd::failed    ? End::failed
                : record.outcome.end == RunEnd::stopped ? End::stopped
                : record.doubts.empty()                 ? End::finished
                                                        : End::doubtful;
  put_failure(outcome, record.outcome);
  if (outcome.end == End::stopped) outcome.reason = record.outcome.why_early;
  outcome.steps = record.outcome.steps;
  outcome.time = record.outcome.time;
  if (record.outcome.steps > 0) {
    outcome.displacement = record.extremes.displacement;
    outcome.speed = record.motion ? record.motion->speed : 0;
  }
  if (record.motion) outcome.sentences = sentences(prepared, record, *record.motion);
  outcome.warnings = public_warnings(record.warnings);
  outcome.doubts = public_warnings(record.doubts);
  return outcome;
}

Step step_of(const StepReport& report) {
  return {report.step, report.time, report.dt, report.passes, report.residual, report.greatest_penetration};
}

namespace {

/// Run in memory.
struct MemoryRun : Run::State {
  MemoryRun(const Plan& of, const Context& under)
      : State(of.data()->of, {of.data(), &of.data()->planned}, under.state().context),
        plan(of),
        watch(prepared()),
        observer(what_is_told()),
        loop(prepared().scene, stepping(), usual_frame_interval(planned->problem, prepared().scene.settings),
             observer) {
    record.profile = plan.profile();
    record.units = planned->problem.units;
    record.warnings = joined(plan.data()->of.data().open.input.warnings, planned->warnings);
    const int stride = stride_of(prepared().scene.settings.step_count);
    record.steps = StepRows(stride);
    record.ledger = LedgerRows(stride);
    loop.tell_start();
    context.tell(nullptr, 0);
  }

  const Prepared& prepared() const { return planned->prepared; }
  const RunRecord& so_far() const override { return record; }
  bool step() override { return loop.step(); }

  Stepper& stepping() {
    stepper = stepper_for(prepared().scene);
    scope = stepper->ledger_scope();
    return *stepper;
  }

  Observer what_is_told() {
    Observer told;
    told.on_step = [this](const StepReport& report) {
      last = step_of(report);
      record.totals.add(report);
      record.steps.add(report);
      watch.add(report);
    };
    told.on_ledger = [this](const LedgerRow& row) {
      record.ledger_sums.add(row);
      record.ledger.add(row);
      watch.blocks().add(row);
    };
    told.on_state = [this](const Stepper& state) {
      watch.blocks().add(state);
      kept.add(state);
    };
    told.on_contacts = [this](const ContactFrames& now) { contacts = now; };
    told.on_frame = [this](const keyblock::Frame& frame) {
      watch.blocks().add(frame, contacts, stepper->model(), prepared().scene.settings);
      if (!first) first = frame;
      last_frame = frame;
    };
    return told;
  }

  void end() override {
    const keyblock::Place& place = planned->problem.analysis->place;
    record.outcome = loop.end();
    record.warnings = joined(record.warnings, watch.warnings(place));
    record.extremes = extremes_of(*first, last_frame, record.outcome.field);
    record.plastic = plastic_extremes_of(last_frame);
    keyblock::judge(record, prepared(), watch, *first, last_frame, place);
    outcome = outcome_of(prepared(), record);
  }

  Plan plan;
  RunRecord record;
  StepWatch watch;
  ContactFrames contacts;
  std::optional<keyblock::Frame> first;
  keyblock::Frame last_frame;
  Observer observer;
  StepLoop loop;
};

bool is_balance(const Run::State& state, std::string_view history) {
  return history == kBalanceName && state.so_far().ledger.last() != nullptr;
}

std::vector<LedgerColumn> balance_columns(const Run::State& state) {
  return ledger_columns(state.scope, state.so_far().ledger_sums.first);
}

std::vector<std::pair<std::string, std::string>> balance_quantities(const Run::State& state) {
  std::vector<std::pair<std::string, std::string>> all;
  for (const LedgerColumn& column : balance_columns(state)) {
    const Measure measure = formats::column_of(formats::kLedgerTable, column.name).measure;
    all.emplace_back(column.name, unit_of(measure, state.planned->problem.units));
  }
  return all;
}

Column<double> balance_of(const Run::State& state, std::string_view quantity) {
  const std::vector<LedgerColumn> columns = balance_columns(state);
  const auto column = std::ranges::find_if(columns, [&](const LedgerColumn& c) { return c.name == quantity; });
  if (column == columns.end())
    throw SettingError(fmt::format("expected a quantity of the history {}, found {}", kBalanceName, quantity));
  std::vector<double> values;
  for (const LedgerRow& row : state.so_far().ledger.rows()) {
    values.push_back(row.time);
    values.push_back(column->value(row));
  }
  return {std::make_shared<const std::vector<double>>(std::move(values)), 2};
}

}  // namespace

inline namespace v1 {

const std::shared_ptr<Contacts>& Run::State::contacts_now() {
  if (!contacts_of_now_)
    contacts_of_now_ = std::make_shared<Contacts>([run = stepper, of = planned, lines = joints, under = context] {
      const Under own(under);
      ContactFrames contacts = run->contacts();
      lines->name(contacts, run->model());
      return contacts;
    });
  return contacts_of_now_;
}

// Frames that are still held keep what their contacts need. A stage changes the model that names their joints.
void Run::State::leave_step() {
  const bool is_held = contacts_of_now_ && contacts_of_now_.use_count() > 1;
  if (is_held && !planned->problem.stages.empty()) contacts_of_now_->part();
  if (is_held)
    contacts_of_now_->keep([&]() -> std::function<ContactFrames()> {
      return [run = stepper, of = planned, lines = joints, later = stepper->contacts_later()] {
        ContactFrames contacts = later();
        lines->name(contacts, run->model());
        return contacts;
      };
    });
  contacts_of_now_.reset();
}

bool Run::State::advance() {
  const Under under(context);
  if (outcome.end != End::running) return false;
  leave_step();
  const bool is_made = step();
  context.tell(nullptr, 0);
  if (!is_made) {
    end();
  } else {
    outcome.steps = last.number;
    outcome.time = last.time;
  }
  return is_made;
}

Run::Run(const Plan& plan, const Context& context) {
  state_ = guarded([&] {
    const Under under(context.state().context);
    return std::make_unique<MemoryRun>(plan, context);
  });
}

Run::Run(std::unique_ptr<State> state) : state_(std::move(state)) {}
Run::Run(Run&&) noexcept = default;
Run& Run::operator=(Run&&) noexcept = default;
Run::~Run() = default;

bool Run::advance() {
  return guarded([&] { return state_->advance(); });
}

void Run::end_early(const std::string& why) {
  guarded([&] {
    {
      const Under under(state_->context);
      state_->end_early(why);
    }
    if (state_->is_recorded()) state_->advance();
  });
}

const Outcome& Run::go_on(const std::function<bool(const Run&)>& until) {
  while (advance())
    if (until && until(*this)) {
      end_early("the condition of the caller is met");
      break;
    }
  return state_->outcome;
}

const Case& Run::of() const {
  return state_->of_case;
}

const Step& Run::last() const {
  return state_->last;
}

Frame Run::frame(Detail detail) const {
  return guarded([&] {
    const Under under(state_->context);
    const Stepper& stepper = *state_->stepper;
    const FieldFrame within = detail == Detail::corners ? field_of(stepper.model(), stepper) : FieldFrame{};
    return Frame(std::make_shared<const Frame::Data>(Frame::Data{
        formats::columns_of(frame_now(stepper), {}, within), state_->contacts_now(), state_->planned->problem.units}));
  });
}

std::vector<std::string> Run::histories() const {
  return state_->kept.names();
}

std::vector<std::pair<std::string, std::string>> Run::quantities(std::string_view history) const {
  return is_balance(*state_, history) ? balance_quantities(*state_) : state_->kept.quantities(history);
}

Column<double> Run::history(std::string_view history, std::string_view quantity) const {
  return is_balance(*state_, history) ? balance_of(*state_, quantity) : state_->kept.values(history, quantity);
}

const Outcome& Run::outcome() const {
  return state_->outcome;
}

}  // namespace v1
}  // namespace keyblock::api
