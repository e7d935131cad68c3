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
#include "job/run_account.hpp"
#include "job/run_report.hpp"
#include "job/verdict/end_of_motion.hpp"
#include "library/run_state.hpp"
#include "problem/units/measure.hpp"
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

std::shared_ptr<RunAccount> account_of(const Plan& of) {
  const PlannedCase& planned = of.data()->planned;
  RunRecord record;
  record.profile = planned.profile.name;
  record.units = planned.problem.units;
  record.warnings = joined(of.data()->of.data().open.input.warnings, planned.warnings);
  return std::make_shared<RunAccount>(planned.prepared, std::move(record), planned.problem.outputs.histories,
                                      planned.problem.analysis->place);
}

/// Run in memory.
struct MemoryRun : Run::State {
  MemoryRun(const Plan& of, const Context& under)
      : State(of.data()->of, {of.data(), &of.data()->planned}, account_of(of), under.state().context),
        observer(what_is_told()),
        loop(prepared().scene, stepping(), usual_frame_interval(planned->problem, prepared().scene.settings),
             observer) {
    account->keep_histories();
    loop.tell_start();
    context.tell(nullptr, 0);
  }

  const Prepared& prepared() const { return planned->prepared; }
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
      account->add(report);
    };
    told.on_ledger = [this](const LedgerRow& row) { account->add(row); };
    told.on_state = [this](const Stepper& state) { account->add(state); };
    told.on_contacts = [this](const ContactFrames& now) { account->add(now, stepper->model()); };
    told.on_frame = [this](const keyblock::Frame& frame) {
      account->add(frame, stepper->model());
      if (!first) first = frame;
      last_frame = frame;
    };
    return told;
  }

  void end() override {
    account->record().outcome = loop.end();
    account->judge(*first, last_frame);
    outcome = outcome_of(prepared(), account->record());
  }

  std::optional<keyblock::Frame> first;
  keyblock::Frame last_frame;
  Observer observer;
  StepLoop loop;
};

bool is_balance(const Run::State& state, std::string_view history) {
  return history == kBalanceName && state.account->record().ledger.last() != nullptr;
}

std::vector<LedgerColumn> balance_columns(const Run::State& state) {
  return ledger_columns(state.scope, state.account->record().ledger_sums.first);
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
    throw Error(fmt::format("expected a quantity of the history {}, found {}", kBalanceName, quantity),
                ErrorCode::choice);
  std::vector<double> values;
  for (const LedgerRow& row : state.account->record().ledger.rows()) {
    values.push_back(row.time);
    values.push_back(column->value(row));
  }
  return {std::make_shared<const std::vector<double>>(std::move(values)), 2};
}

}  // namespace

inline namespace v1 {

const std::shared_ptr<Contacts>& Run::State::contacts_now() {
  if (!contacts_of_now_)
    contacts_of_now_ =
        std::make_shared<Contacts>([run = stepper, of = planned, lines = account->joints(), under = context] {
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
      return [run = stepper, of = planned, lines = account->joints(), later = stepper->contacts_later()] {
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
  const auto is_met = [&] {
    try {
      return until && until(*this);
    } catch (...) {
      end_early("the condition of the caller threw an exception");
      throw;
    }
  };
  while (advance())
    if (is_met()) {
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
    return Frame(std::make_shared<const Frame::Data>(Frame::Data{formats::columns_of(frame_now(stepper), {}, within),
                                                                 state_->contacts_now(), state_->planned->problem.units,
                                                                 state_->account->epoch(stepper.model())}));
  });
}

std::vector<std::string> Run::histories() const {
  return state_->account->histories().names();
}

std::vector<std::pair<std::string, std::string>> Run::quantities(std::string_view history) const {
  return guarded([&] {
    return is_balance(*state_, history) ? balance_quantities(*state_)
                                        : state_->account->histories().quantities(history);
  });
}

Column<double> Run::history(std::string_view history, std::string_view quantity) const {
  return guarded([&]() -> Column<double> {
    if (is_balance(*state_, history)) return balance_of(*state_, quantity);
    std::vector<double> values = state_->account->histories().values(history, quantity);
    const Under under(state_->context);
    if (const keyblock::State& now = state_->stepper->state(); state_->account->lacks_row(now.step))
      for (const FollowedValue& value : state_->account->values(*state_->stepper))
        if (value.name == history && value.quantity == quantity) values.insert(values.end(), {now.time, value.value});
    return {std::make_shared<const std::vector<double>>(std::move(values)), 2};
  });
}

const Outcome& Run::outcome() const {
  return state_->outcome;
}

}  // namespace v1
}  // namespace keyblock::api
