// Plans the case, records its request, and passes both to the job that writes the folder.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "job/recorded_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "base/bytes/sha256.hpp"
#include "base/context.hpp"
#include "base/decimals.hpp"
#include "base/error.hpp"
#include "formats/registry.hpp"
#include "job/run_heading.hpp"
#include "job/run_report.hpp"
#include "run/run.hpp"
#include "settings/settings_table.hpp"

namespace keyblock {

namespace fs = std::filesystem;

namespace {

/// Names the choice in an error about its text.
template <class Read>
auto read_choice(const char* choice, const Read& read) {
  try {
    return read();
  } catch (const std::invalid_argument& error) {
    throw ChoiceError(choice, error.what());
  }
}

std::optional<StopCriterion> criterion_of(const std::string& text, const Units& units) {
  if (text.empty()) return std::nullopt;
  return read_choice("stop-when", [&] { return stop_criterion_of(text, units); });
}

RunRequest request_of(const RecordingOptions& options, const OpenCase& read, const PlannedCase& plan,
                      const RunRecord& record) {
  const Settings& settings = plan.prepared.scene.settings;
  const fs::path& from = context().folder();
  RunRequest request{this_program(),
                     fs::weakly_canonical(fs::absolute(options.folder)).string(),
                     (from.empty() ? fs::current_path() : from).string(),
                     read.files,
                     record.profile,
                     {},
                     record.record_every,
                     options.trace == Trace::yes,
                     {},
                     {},
                     {},
                     options.outputs.histories,
                     options.outputs.contacts,
                     options.outputs.field,
                     read.choices.unit,
                     read.choices.join,
                     options.outputs.frames,
                     options.outputs.has_pictures,
                     options.outputs.has_page,
                     options.checkpoint_every};
  for (const ChangedValue& value : read.values) request.values.push_back(text_of(value));
  for (const auto& [name, value] : plan.asked) request.sets.push_back(fmt::format("{}={}", name, value));
  for (const InputRecord& input : record.inputs) {
    request.read.push_back(input.file);
    request.digests.push_back(input.sha256);
  }
  for (const SettingText& setting : list(settings)) request.settings.push_back(setting.name + "=" + setting.value);
  return request;
}

std::vector<Override> overrides_in(const std::vector<std::string>& sets) {
  std::vector<Override> overrides;
  for (const std::string& text : sets) {
    const std::size_t equals = text.find('=');
    overrides.emplace_back(text.substr(0, equals), text.substr(std::min(equals, text.size() - 1) + 1));
  }
  return overrides;
}

std::vector<ChangedValue> values_in(const std::vector<std::string>& texts) {
  std::vector<ChangedValue> values;
  for (const std::string& text : texts) values.push_back(case_value_of(text));
  return values;
}

PlannedCase planned_with(const OpenCase& read, const OutputOptions& outputs) {
  Problem problem = read.input.problem;
  problem.outputs = outputs_asked(problem.outputs, outputs);
  return planned(read, problem);
}

// Returns path, checksum and format of each file of the case, and of the file that a setting names, if any.
std::vector<InputRecord> input_records(const std::vector<formats::FileReading>& readings, const std::string& named) {
  std::vector<InputRecord> records;
  for (const formats::FileReading& file : readings)
    records.push_back({file.path, sha256(file.source.text), std::string(file.choice->format->name),
                       file.choice->recognition.evidence});
  if (!named.empty())
    records.push_back(
        {named, sha256(formats::load(named).text), "table", "accelerations over time", "body_acceleration_file"});
  return records;
}

}  // namespace

nlohmann::ordered_json origin_json(const Units& units, const std::vector<formats::FileReading>& readings,
                                   const ConfiguredCase& made) {
  nlohmann::ordered_json json;
  if (units != Units{}) json["units"] = units_json(units);
  const std::vector<std::string> named = named_files(made);
  json["inputs"] = inputs_json(input_records(readings, named.empty() ? "" : named.back()));
  return json;
}

RecordedRun::Beginning RecordedRun::saved_in(const std::string& folder, std::optional<double> checkpoint_every) {
  Beginning beginning;
  if (folder.empty()) throw ChoiceError("resume", "expected the name of a folder, found an empty one");
  const std::string whole = fs::absolute(folder).string();
  beginning.checkpoint = std::make_unique<Archive>(read_checkpoint(checkpoint_in(whole)));
  Archive& saved = *beginning.checkpoint;
  RunRequest& request = beginning.request.emplace();
  saved.group("request", [&] { describe(saved, request); });
  require_own(checkpoint_in(whole), request);
  if (!fs::is_directory(request.working_folder))
    saved.refuse("working_folder", fmt::format("expected the folder {}, found none", request.working_folder));
  context().use_folder(request.working_folder);
  if (request.record_every < 1 || request.files.empty())
    saved.refuse("request", "expected files and a frame every so many steps, found none");
  beginning.options = {
      whole,
      Overwrite::no,
      request.has_trace ? Trace::yes : Trace::no,
      checkpoint_every.value_or(request.checkpoint_every),
      request.record_every,
      {request.histories, request.contacts, request.field, request.frames, request.has_pictures, request.has_page}};
  beginning.read = opened(asked_case({request.files,
                                      {},
                                      request.profile,
                                      overrides_in(request.sets),
                                      {request.unit, request.join},
                                      values_in(request.values)}));
  return beginning;
}

RecordedRun::RecordedRun(const std::string& folder, std::optional<double> checkpoint_every)
    : RecordedRun(saved_in(folder, checkpoint_every)) {}

RecordedRun::RecordedRun(OpenCase read, const RecordingOptions& options)
    : RecordedRun(Beginning{.options = options, .read = std::move(read)}) {}

RecordedRun::RecordedRun(const AskedCase& asked, const RecordingOptions& options)
    : RecordedRun(Beginning{.options = options, .read = opened(asked)}) {}

RecordedRun::RecordedRun(Beginning beginning)
    : last_(beginning.at),
      options_(std::move(beginning.options)),
      read_(std::move(beginning.read)),
      checkpoint_(std::move(beginning.checkpoint)) {
  const formats::Case& input = read_.input;
  RunRecord record;
  record.units = input.problem.units;
  record.values = read_.values;
  record.timings.read = to_microseconds(lap());
  plan_ = std::make_shared<const PlannedCase>(planned_with(read_, options_.outputs));
  record.inputs = input_records(read_.read_files(), plan_->prepared.scene.settings.body_acceleration.file);
  record.profile = plan_->profile.name;
  record.profile_because = plan_->profile.why;
  record.record_every = options_.record_every > 0
                            ? options_.record_every
                            : usual_frame_interval(plan_->problem, plan_->prepared.scene.settings);
  record.warnings = joined(input.warnings, plan_->warnings);
  record.timings.prepare = to_microseconds(lap());
  title_ = title_of(read_.files.front(), record.profile);
  RunRequest request = request_of(options_, read_, *plan_, record);
  if (beginning.request) require_same(checkpoint_in(options_.folder), *beginning.request, request);
  for (const InputRecord& read : record.inputs) require_not_below(read.file, options_.folder);
  job_ = std::make_unique<RunJob>(
      plan_->prepared, std::move(record), std::move(request),
      RunJobOptions{options_.folder, options_.overwrite, options_.trace, options_.checkpoint_every,
                    plan_->problem.analysis->place, plan_->problem.outputs, options_.outputs.field,
                    formats::names_of(input.files),
                    read_choice("frames", [&] { return formats::vtk_coding_of(options_.outputs.frames); }),
                    options_.outputs.has_pictures, options_.outputs.has_page,
                    criterion_of(options_.stop_when, plan_->problem.units)},
      checkpoint_.get());
}

std::string RecordedRun::finish() {
  return job_->finish(title_, lap());
}

double RecordedRun::lap() {
  const Time now = std::chrono::steady_clock::now();
  return std::chrono::duration<double>(now - std::exchange(last_, now)).count();
}

}  // namespace keyblock
