// Steps a run on request of the caller, with the checks and the judgement of `keyblock run`.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/run.hpp"

#include <functional>
#include <keyblock/record.hpp>
#include <memory>
#include <optional>

#include "job/recorded_run.hpp"
#include "job/run_doubts.hpp"
#include "job/run_report.hpp"
#include "job/run_warnings.hpp"
#include "job/verdict/end_of_motion.hpp"
#include "library/kept_histories.hpp"
#include "library/parts.hpp"
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

Outcome outcome_of(const Prepared& prepared, const RunRecord& record) {
  Outcome outcome;
  outcome.end = record.outcome.end == RunEnd::failed    ? End::failed
                : record.outcome.end == RunEnd::stopped ? End::stopped
                : record.doubts.empty()                 ? End::finished
                                                        : End::doubtful;
  put_failure(outcome, record.outcome);
  outcome.steps = record.outcome.steps;
  outcome.time = record.outcome.time;
  outcome.displacement = record.extremes.displacement;
  if (record.motion) outcome.speed = record.motion->speed;
  if (record.motion) outcome.sentences = sentences(prepared, record, *record.motion);
  outcome.warnings = public_warnings(record.warnings);
  outcome.doubts = public_warnings(record.doubts);
  return outcome;
}

Step step_of(const StepReport& report) {
  return {report.step, report.time, report.dt, report.passes, report.residual, report.greatest_penetration};
}

Outcome outcome_of(RecordedRun& run, const std::function<void(const Step&)>& on_step) {
  run.open();
  const bool has_begun = run.run([&](const StepReport& report) {
    if (on_step) on_step(step_of(report));
  });
  if (has_begun) run.finish();
  return outcome_of(run.prepared(), run.record());
}

}  // namespace

inline namespace v1 {

struct Run::State {
  State(const Plan& of, const Context& under)
      : plan(of),
        context(under.state().context),
        watch(prepared()),
        kept(plan.data()->planned),
        observer(what_is_told()),
        stepper(stepper_for(prepared().scene)),
        loop(prepared().scene, *stepper, usual_frame_interval(plan.data()->planned.problem, prepared().scene.settings),
             observer) {
    record.profile = plan.profile();
    record.units = plan.data()->planned.problem.units;
    record.warnings = joined(plan.data()->of.data().open.input.warnings, plan.data()->planned.warnings);
    const int stride = stride_of(prepared().scene.settings.step_count);
    record.steps = StepRows(stride);
    record.ledger = LedgerRows(stride);
    loop.tell_start();
    context.tell(nullptr, 0);
  }

  const Prepared& prepared() const { return plan.data()->planned.prepared; }

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

  void judge() {
    const keyblock::Place& place = plan.data()->planned.problem.analysis->place;
    record.outcome = loop.end();
    record.warnings = joined(record.warnings, watch.warnings(place));
    record.extremes = extremes_of(*first, last_frame, record.outcome.field);
    record.plastic = plastic_extremes_of(last_frame);
    keyblock::judge(record, prepared(), watch, *first, last_frame, place);
    outcome = outcome_of(prepared(), record);
  }

  Plan plan;
  keyblock::Context context;
  RunRecord record;
  StepWatch watch;
  KeptHistories kept;
  ContactFrames contacts;
  std::optional<keyblock::Frame> first;
  keyblock::Frame last_frame;
  Observer observer;
  /// Returns the contacts of now, which all frames of this step share.
  const std::shared_ptr<Contacts>& contacts_now() {
    if (!contacts_of_now)
      contacts_of_now = std::make_shared<Contacts>([run = stepper, of = plan, under = context] {
        const Under own(under);
        return run->contacts();
      });
    return contacts_of_now;
  }

  /// Before a step: frames that are still held keep what their contacts need.
  void leave_step() {
    if (contacts_of_now && contacts_of_now.use_count() > 1)
      contacts_of_now->keep([&]() -> std::function<ContactFrames()> {
        return [run = stepper, of = plan, later = stepper->contacts_later()] { return later(); };
      });
    contacts_of_now.reset();
  }

  std::shared_ptr<Stepper> stepper;
  StepLoop loop;
  Step last;
  Outcome outcome;
  std::shared_ptr<Contacts> contacts_of_now;
};

Run::Run(const Plan& plan, const Context& context) {
  state_ = guarded([&] {
    const Under under(context.state().context);
    return std::make_unique<State>(plan, context);
  });
}

Run::Run(Run&&) noexcept = default;
Run& Run::operator=(Run&&) noexcept = default;
Run::~Run() = default;

bool Run::advance() {
  return guarded([&] {
    const Under under(state_->context);
    if (state_->outcome.end != End::running) return false;
    state_->leave_step();
    const bool is_made = state_->loop.step();
    state_->context.tell(nullptr, 0);
    if (is_made) return true;
    state_->judge();
    return false;
  });
}

const Outcome& Run::go_on(const std::function<bool(const Run&)>& until) {
  while (advance())
    if (until && until(*this)) break;
  return state_->outcome;
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
                                                                 state_->contacts_now(), state_->record.units}));
  });
}

std::vector<std::string> Run::histories() const {
  return state_->kept.names();
}

std::vector<std::pair<std::string, std::string>> Run::quantities(std::string_view history) const {
  return state_->kept.quantities(history);
}

Column<double> Run::history(std::string_view history, std::string_view quantity) const {
  return state_->kept.values(history, quantity);
}

const Outcome& Run::outcome() const {
  return state_->outcome;
}

Outcome record(const Case& of, const std::string& folder, const Recording& how, const Choices& choices,
               const Context& context) {
  return guarded([&] {
    const Under under(context.state().context);
    OpenCase read = of.data().open;
    static_cast<AskedCase&>(read) = asked_under(of, choices);
    RecordedRun run(std::move(read), {folder,
                                      how.overwrite ? Overwrite::yes : Overwrite::no,
                                      Trace::no,
                                      how.checkpoint_every,
                                      how.every,
                                      {how.histories, how.contacts, {}, how.frames, how.pictures}});
    return outcome_of(run, how.on_step);
  });
}

Outcome resume(const std::string& folder, const std::function<void(const Step&)>& on_step, const Context& context) {
  return guarded([&] {
    // A part of it: the folder that paths of this run count from is not that of the caller's next call.
    const keyblock::Context own = context.state().context.part();
    const Under under(own);
    RecordedRun run(folder, Recording{}.checkpoint_every);
    return outcome_of(run, on_step);
  });
}

}  // namespace v1
}  // namespace keyblock::api
