// Runs a case, at once or step by step, with its results in a folder.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <keyblock/record.hpp>
#include <optional>
#include <utility>

#include "job/recorded_run.hpp"
#include "library/run_state.hpp"

namespace keyblock::api {
namespace {

/// Run that writes its results. Its folder is free again after the end.
struct FolderRun : Run::State {
  FolderRun(Case what, std::unique_ptr<RecordedRun> of, std::function<void(const Step&)> call,
            const keyblock::Context& under)
      : State(std::move(what), of->plan(), of->account(), under), on_step(std::move(call)), recorded(std::move(of)) {
    account->keep_histories();
    recorded->open();
    RunCalls calls;
    calls.on_step = [this](const StepReport& report) {
      last = step_of(report);
      call_back(on_step, last);
    };
    recorded->start(std::move(calls));
    stepper = recorded->stepper();
    scope = stepper->ledger_scope();
    last.number = stepper->state().step;
    last.time = stepper->state().time;
    context.tell(nullptr, 0);
  }

  bool is_recorded() const override { return true; }
  bool step() override { return recorded->step(); }
  void end_early(const std::string& why) override {
    if (recorded) recorded->end_early(why);
  }
  void end() override {
    recorded->end();
    recorded->finish();
    outcome = outcome_of(planned->prepared, account->record());
    recorded.reset();
  }

  std::function<void(const Step&)> on_step;
  std::unique_ptr<RecordedRun> recorded;  ///< null after the end
};

RecordingOptions options_of(const std::string& folder, const Recording& how) {
  if (folder.empty()) throw ChoiceError("output", "expected the name of a folder, found an empty one");
  if (how.every < 0) throw ChoiceError("every", fmt::format("expected at least 0, found {}", how.every));
  if (!(how.checkpoint_every >= 0))
    throw ChoiceError("checkpoint_every", fmt::format("expected at least 0 seconds, found {}", how.checkpoint_every));
  return {std::filesystem::absolute(folder).string(),  // the caller may change the working folder
          how.overwrite ? Overwrite::yes : Overwrite::no,
          Trace::no,
          how.checkpoint_every,
          how.every,
          {how.histories, how.contacts, {}, how.frames, how.pictures}};
}

std::unique_ptr<RecordedRun> begun(const Case& of, const std::string& folder, const Recording& how,
                                   const Choices& choices) {
  OpenCase read = of.data().open;
  static_cast<AskedCase&>(read) = asked_under(of, choices);
  return std::make_unique<RecordedRun>(std::move(read), options_of(folder, how));
}

Outcome run_to_end(RecordedRun& run, const std::function<void(const Step&)>& on_step) {
  run.open();
  const bool has_begun = run.run([&](const StepReport& report) { call_back(on_step, step_of(report)); });
  if (has_begun) run.finish();
  return outcome_of(run.prepared(), run.record());
}

}  // namespace

inline namespace v1 {

Outcome record(const Case& of, const std::string& folder, const Recording& how, const Choices& choices,
               const Context& context) {
  return guarded([&] {
    const Under under(context.state().context);
    return run_to_end(*begun(of, folder, how, choices), how.on_step);
  });
}

Outcome resume(const std::string& folder, const std::function<void(const Step&)>& on_step, const Context& context) {
  return guarded([&] {
    // A part of it: the folder that paths of this run count from is not that of the caller's next call.
    const keyblock::Context own = context.state().context.part();
    const Under under(own);
    RecordedRun run(folder);
    return run_to_end(run, on_step);
  });
}

// A part of the context: the run stops it to end early.
Run recorded(const Case& of, const std::string& folder, const Recording& how, const Choices& choices,
             const Context& context) {
  return guarded([&] {
    const keyblock::Context own = context.state().context.part();
    const Under under(own);
    return Run(std::make_unique<FolderRun>(of, begun(of, folder, how, choices), how.on_step, own));
  });
}

Run resumed(const std::string& folder, const Context& context) {
  return guarded([&] {
    const keyblock::Context own = context.state().context.part();
    const Under under(own);
    auto run = std::make_unique<RecordedRun>(folder);
    Case of = Case::Data::case_of(run->read());
    return Run(std::make_unique<FolderRun>(std::move(of), std::move(run), std::function<void(const Step&)>(), own));
  });
}

}  // namespace v1
}  // namespace keyblock::api
