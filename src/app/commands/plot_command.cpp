// `keyblock plot`: another quantity, or another step, of a run that is over, drawn from the frames in its folder.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/command.hpp"
#include "base/error.hpp"
#include "formats/registry.hpp"
#include "formats/views/vtu_reading.hpp"
#include "job/files.hpp"
#include "job/folder/frame_files.hpp"
#include "job/folder/output_files.hpp"
#include "report/field_picture.hpp"

namespace keyblock {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

struct PlotOptions {
  std::string folder;
  std::string field;
  std::optional<int> step;
  std::string file;
  bool force = false;
  bool as_json = false;
};

/// What the record of a run says of its pictures; a run that was killed has none.
struct RunHeading {
  std::string title;
  Units units;
  bool is_of_motion = true;
};

RunHeading heading_of(const fs::path& folder) {
  RunHeading heading{fs::absolute(folder).lexically_normal().filename().string(), {}, true};
  const fs::path file = folder / kRecord;
  if (!fs::is_regular_file(file)) return heading;
  const Json record = Json::parse(formats::load(file.string()).text, nullptr, false);
  if (!record.is_object()) throw InputError({file.string()}, "expected the record of a run (JSON), found another file");
  const auto text = [](const Json& of, const char* key) {
    return of.is_object() && of.contains(key) && of[key].is_string() ? of[key].get<std::string>() : std::string();
  };
  const Json inputs = record.value("inputs", Json::array());
  if (inputs.is_array() && !inputs.empty())
    heading.title =
        fmt::format("{}, profile {}", fs::path(text(inputs[0], "file")).stem().string(), text(record, "profile"));
  const Json units = record.value("units", Json::object());
  heading.units = {text(units, "length"), text(units, "mass"), text(units, "time")};
  heading.is_of_motion = !(record.contains("is_linear") && record["is_linear"] == true);
  return heading;
}

fs::path frame_at(const std::map<int, fs::path>& frames, const PlotOptions& options) {
  if (!options.step) return frames.rbegin()->second;
  const auto found = frames.find(*options.step);
  if (found != frames.end()) return found->second;
  const auto after = frames.lower_bound(*options.step);
  const int nearest = after == frames.end() ? frames.rbegin()->first : after->first;
  throw UsageError(fmt::format("--step: {} has no frame of step {}, only {}, from {} to {}; the next is {}",
                               options.folder, *options.step, frames.size(), frames.begin()->first,
                               frames.rbegin()->first, nearest));
}

std::string default_name(const PlotOptions& options) {
  const std::string word = options.field.empty() ? "field" : "field_" + options.field;
  return (fs::path(options.folder) / (options.step ? fmt::format("{}_{}.svg", word, *options.step) : word + "_end.svg"))
      .string();
}

ExitCode plot(const PlotOptions& options) {
  const std::map<int, fs::path> frames = frames_in(options.folder);
  if (frames.empty())
    throw InputError({options.folder},
                     fmt::format("expected the folder of a run, with {}/*.vtu, found none", kFrameFolder));
  const std::string file = options.file.empty() ? default_name(options) : options.file;
  require_writable({file}, {}, overwrite_if(options.force));
  const RunHeading heading = heading_of(options.folder);
  const FieldFrame start = formats::read_vtu(formats::load(frames.begin()->second.string()));
  const fs::path shown = frame_at(frames, options);
  const FieldFrame end = formats::read_vtu(formats::load(shown.string()));
  const std::string& unit = heading.units.time;
  const std::string title = fmt::format("{}, time {:g}{}{}", heading.title, end.time, unit.empty() ? "" : " ", unit);
  const report::FieldShown field =
      options.field.empty() ? report::most_varied(end) : report::field_of_word(options.field);
  write_output(
      file,
      report::field_picture(
          {title, start, end, {}, field, heading.is_of_motion, heading.units, report::left_out_of(start, end)}),
      overwrite_if(options.force));
  if (options.as_json)
    fmt::print("{}\n", Json({{"file", file},
                             {"frame", shown.string()},
                             {"field", report::kFieldWords.at(static_cast<std::size_t>(field))},
                             {"time", end.time}})
                           .dump());
  spdlog::info("{}: {}, time {:g}", file, report::kFieldWords.at(static_cast<std::size_t>(field)), end.time);
  return ExitCode::ok;
}

}  // namespace

Action configure_plot(CLI::App& options) {
  const auto chosen = std::make_shared<PlotOptions>();
  options.add_option("RUN", chosen->folder, "the folder that a run wrote, also of one that was stopped")
      ->required()
      ->check(CLI::ExistingDirectory);
  options
      .add_option("--field", chosen->field,
                  "a component of stress, a principal one (s1 the greatest, s3 the least), the von Mises stress, the "
                  "displacement, or principal stresses as crosses (default: the component that varies most)")
      ->check(CLI::IsMember(std::vector<std::string>(report::kFieldWords.begin(), report::kFieldWords.end())));
  options.add_option("--step", chosen->step, "the step whose frame is drawn (default: the last that has one)");
  options
      .add_option("-o,--output", chosen->file,
                  "the picture to write, SVG (default: RUN/field_FIELD_end.svg, or with the step in place of end)")
      ->type_name("FILE");
  options.add_flag("--force", chosen->force, "overwrite the file if it exists");
  options.add_flag("--json", chosen->as_json, "print file, frame, field and time as JSON");
  return [chosen] { return plot(*chosen); };
}

}  // namespace keyblock
