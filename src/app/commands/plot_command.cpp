// `keyblock plot`: draws another quantity, or another step, of a completed run from the frames in its folder.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/command.hpp"
#include "app/handout/recorded_curves.hpp"
#include "app/helpers/picture_file.hpp"
#include "app/option_checks.hpp"
#include "base/bytes/file_bytes.hpp"
#include "base/error.hpp"
#include "formats/registry.hpp"
#include "formats/views/vtk.hpp"
#include "formats/views/vtu_reading.hpp"
#include "job/files.hpp"
#include "job/folder/frame_files.hpp"
#include "job/folder/output_files.hpp"
#include "job/run_heading.hpp"
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
  bool numbers = false;
  bool force = false;
  bool as_json = false;
  bool has_own_scale = false;
  std::vector<std::string> curves;
  std::string against = "time";
  std::optional<double> width;
};

fs::path frame_at(const std::map<int, fs::path>& frames, const PlotOptions& options) {
  if (!options.step) return frames.rbegin()->second;
  const auto found = frames.find(*options.step);
  if (found != frames.end()) return found->second;
  const auto nearest = std::ranges::min_element(
      frames, {}, [&](const auto& frame) { return std::abs(static_cast<double>(frame.first) - *options.step); });
  throw UsageError(fmt::format(
      "--step: there is no frame of step {} in {}; of the {} there are, of steps {} to {}, that "
      "of step {} is the nearest",
      *options.step, options.folder, frames.size(), frames.begin()->first, frames.rbegin()->first, nearest->first));
}

/// Returns the indices of the numbers in the frame.
std::vector<std::size_t> places_of(const std::vector<int>& numbers, const formats::VtuFrame& frame) {
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < frame.numbers.size(); ++i)
    if (std::ranges::find(numbers, frame.numbers[i]) != numbers.end()) places.push_back(i);
  return places;
}

/// Returns the numbers as in tables.
std::vector<int> numbers_of(const formats::VtuFrame& frame) {
  std::vector<int> numbers;
  for (const int number : frame.numbers) numbers.push_back(number + 1);
  return numbers;
}

/// Returns the common scale for pictures of all steps, so that they make a film.
report::FieldScale scale_of_all(const std::map<int, fs::path>& frames, const RunHeading& heading,
                                report::FieldShown shown) {
  const auto read = [&](const fs::path& path) {
    formats::VtuFrame frame = formats::read_vtu(formats::load(path.string()));
    const std::vector<std::size_t> left_out = places_of(heading.left_out, frame);
    for (auto i = left_out.rbegin(); i != left_out.rend(); ++i)
      frame.field.elements.erase(frame.field.elements.begin() + static_cast<std::ptrdiff_t>(*i));
    return frame.field;
  };
  return report::common_scale(read(frames.rbegin()->second), shown, heading.is_of_motion, [&](const auto& visit) {
    for (const auto& [step, path] : frames) visit(read(path));
  });
}

/// Without a requested field, returns the stress that varies most at the end: the same for all steps.
report::FieldShown field_asked(const PlotOptions& options, const fs::path& last) {
  if (!options.field.empty()) return report::field_of_word(options.field);
  return report::most_varied(formats::read_vtu(formats::load(last.string())).field);
}

/// Returns the files that a picture may not replace: the frames, the record and the tables.
std::vector<fs::path> kept_files(const fs::path& folder) {
  std::vector<fs::path> kept;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file() && entry.path().extension() != ".svg") kept.push_back(entry.path());
  return kept;
}

std::string default_name(const PlotOptions& options) {
  const std::string word = options.field.empty() ? "field" : "field_" + options.field;
  return (fs::path(options.folder) / (options.step ? fmt::format("{}_{}.svg", word, *options.step) : word + "_end.svg"))
      .string();
}

/// Returns the width of the page in its units. Letters of 11 units are 6.9 points high in print; narrower and wider
/// pages are scaled as a whole.
double units_wide(const std::optional<double>& millimetres) {
  constexpr double kUnitsAMillimetre = 4.5;
  constexpr double kNarrowest = 300, kWidest = 900;
  return std::clamp(millimetres.value_or(kWidest) * kUnitsAMillimetre, kNarrowest, kWidest);
}

/// Returns the time of a frame as its title shows it. Pictures of steps have the decimals that tell all frames of the
/// run apart, so that the letters of a film do not jump.
std::string time_in_title(const PlotOptions& options, double time, const Units& units) {
  constexpr int kMostDecimals = 9;
  std::vector<double> times;
  const fs::path list = fs::path(options.folder) / kFrameList;
  const std::string text = fs::is_regular_file(list) ? file_bytes(list.string()) : std::string();
  for (const formats::PvdEntry& entry : formats::read_pvd(text)) times.push_back(entry.time);
  double least = 0;
  for (std::size_t i = 1; i < times.size(); ++i)
    if (const double gap = times[i] - times[i - 1]; gap > 0) least = least > 0 ? std::min(least, gap) : gap;
  const std::string unit = units.time.empty() ? std::string() : " " + units.time;
  if (!options.step || !(least > 0)) return fmt::format("{:g}{}", time, unit);
  const int decimals = std::clamp(static_cast<int>(std::ceil(-std::log10(least))), 0, kMostDecimals);
  return fmt::format("{:.{}f}{}", time, decimals, unit);
}

/// Returns the names in the words of the command line, which commas separate.
std::vector<std::string> curve_names(const std::vector<std::string>& words) {
  std::vector<std::string> names;
  for (const std::string& word : words)
    for (std::size_t at = 0; at <= word.size();) {
      const std::size_t comma = std::min(word.find(',', at), word.size());
      names.push_back(word.substr(at, comma - at));
      at = comma + 1;
    }
  if (std::ranges::find(names, "") != names.end())
    throw UsageError("--curve: expected names of curves, with a comma between two, found an empty name");
  return names;
}

ExitCode plot_curves(PlotOptions options) {
  options.curves = curve_names(options.curves);
  const std::string file =
      options.file.empty() ? (fs::path(options.folder) / fmt::format("curve_{}.svg", options.curves.front())).string()
                           : options.file;
  require_writable({file}, kept_files(options.folder), overwrite_if(options.force));
  const RunHeading heading = heading_of(options.folder);
  const double wide = units_wide(options.width);
  write_picture(file,
                recorded_picture(options.folder, {options.curves, options.against}, heading.title, heading.units, wide),
                overwrite_if(options.force), options.width);
  if (options.as_json)
    fmt::print("{}\n", Json({{"file", file}, {"curves", options.curves}, {"against", options.against}})
                           .dump(-1, ' ', false, Json::error_handler_t::replace));
  spdlog::info("{}: {} over {}", file, fmt::join(options.curves, ", "), options.against);
  return ExitCode::ok;
}

ExitCode plot(const PlotOptions& options) {
  require_picture_name("-o", options.file);
  if (!options.curves.empty()) return plot_curves(options);
  const std::map<int, fs::path> frames = frames_in(options.folder);
  if (frames.empty())
    throw InputError({options.folder},
                     fmt::format("expected the folder of a run, with {}/*.vtu, found none", kFrameFolder));
  const std::string file = options.file.empty() ? default_name(options) : options.file;
  require_writable({file}, kept_files(options.folder), overwrite_if(options.force));
  RunHeading heading = heading_of(options.folder);
  const fs::path shown = frame_at(frames, options);
  const formats::VtuFrame frame = formats::read_vtu(formats::load(shown.string()));
  if (heading.units == Units{}) heading.units = frame.units;  // of a killed run, which has no record
  const FieldFrame& field = frame.field;
  const report::FieldShown quantity = field_asked(options, frames.rbegin()->second);
  const std::string word = report::kFieldWords.at(static_cast<std::size_t>(quantity));
  std::optional<report::FieldScale> scale;
  if (options.step && !options.has_own_scale) scale = scale_of_all(frames, heading, quantity);
  write_picture(file,
                report::field_picture(
                    {fmt::format("{}, time {}", heading.title, time_in_title(options, field.time, heading.units)),
                     {},
                     field,
                     {},
                     quantity,
                     heading.is_of_motion,
                     heading.units,
                     places_of(heading.left_out, frame),
                     options.numbers ? numbers_of(frame) : std::vector<int>(),
                     places_of(heading.held, frame),
                     scale,
                     units_wide(options.width)}),
                overwrite_if(options.force), options.width);
  if (options.as_json)
    fmt::print("{}\n", Json({{"file", file}, {"frame", shown.string()}, {"field", word}, {"time", field.time}})
                           .dump(-1, ' ', false, Json::error_handler_t::replace));
  spdlog::info("{}: {}, time {:g}", file, word, field.time);
  return ExitCode::ok;
}

}  // namespace

Action configure_plot(CLI::App& options) {
  const auto chosen = std::make_shared<PlotOptions>();
  options.add_option("RUN", chosen->folder, "results folder of a finished or stopped run")
      ->required()
      ->check(CLI::ExistingDirectory);
  CLI::Option* field =
      options
          .add_option("--field", chosen->field,
                      "quantity: a stress component, s1 (greatest principal stress), s3 (least), von Mises stress, "
                      "displacement, "
                      "or crosses of principal stresses (default: the component that varies most)")
          ->check(one_word_of(std::vector<std::string>(report::kFieldWords.begin(), report::kFieldWords.end())));
  CLI::Option* step = options.add_option("--step", chosen->step, "step to draw (default: the last frame)");
  options
      .add_option("-o,--output", chosen->file,
                  "picture to write: .svg, .pdf or .png (default: RUN/field_FIELD_end.svg, or the step instead of "
                  "end)")
      ->type_name("FILE");
  CLI::Option* curve =
      options
          .add_option(
              "--curve", chosen->curves,
              "curves instead of the field: columns of history.csv and ledger.csv (dx1, kinetic), or a name and a "
              "quantity of histories.csv (crest.displacement_x)")
          ->type_name("NAME")
          ->excludes(field)
          ->excludes(step);
  options.add_option("--against", chosen->against, "what the curves are drawn over (default: time)")
      ->type_name("NAME")
      ->needs(curve);
  options
      .add_option("--width", chosen->width,
                  "width of the printed picture, 20 to 1,000 mm; PNG then has 300 dots an inch")
      ->type_name("MM")
      ->check(CLI::Range(20.0, 1000.0));
  options.add_flag("--numbers", chosen->numbers, "write block or element numbers into the picture if they fit")
      ->excludes(curve);
  options
      .add_flag(
          "--own-scale", chosen->has_own_scale,
          "scale colours, magnification and frame to this step alone (default: to all steps, so that the pictures "
          "make an animation)")
      ->needs(step);
  options.add_flag("--force", chosen->force, "overwrite the file if it exists");
  options.add_flag("--json", chosen->as_json, "print file, frame, field and time as JSON");
  return [chosen] { return plot(*chosen); };
}

}  // namespace keyblock
