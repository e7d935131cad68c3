// Compares steps, frames and polygons of a rerun with the tables of a trace.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/cases/trace.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <sstream>

#include "base/worse.hpp"
#include "formats/case.hpp"
#include "formats/text/csv.hpp"
#include "run/prepare.hpp"
#include "run/run.hpp"

namespace keyblock::study {

namespace fs = std::filesystem;

namespace {

// Step sizes and penalties are printed with nine digits.
constexpr double kPrinted = 1e-8;
// Fraction of the largest modulus below which a stress is round-off of zero.
constexpr double kStressNoise = 1e-15;

// Table with named numeric cells.
class Numbers {
 public:
  explicit Numbers(const fs::path& file) : table_(formats::read_csv(formats::load(file.string()))) {}

  std::size_t size() const { return table_.rows.size(); }
  double operator()(std::size_t row, const char* column) const {
    return formats::csv_real(table_, table_.rows[row], formats::csv_column(table_, column));
  }
  const std::string& text(std::size_t row, const char* column) const {
    return table_.rows[row].cells[formats::csv_column(table_, column)];
  }

 private:
  formats::CsvTable table_;
};

// Returns the last step to compare. `compared_steps.csv` beside the trace folders lists traces that round-off separates
// earlier.
int last_step(const CaseFolder& folder, int steps_in_trace) {
  const fs::path file = folder.folder.parent_path() / "compared_steps.csv";
  if (!fs::exists(file)) return steps_in_trace;
  const Numbers limits(file);
  for (std::size_t row = 0; row < limits.size(); ++row) {
    if (limits.text(row, "trace") == fs::absolute(folder.folder).lexically_normal().filename())
      return static_cast<int>(limits(row, "last_step"));
  }
  return steps_in_trace;
}

class Follower {
 public:
  Follower(const CaseFolder& folder, double greatest_modulus)
      : steps_(folder.folder / "steps.csv"), blocks_(folder.folder / "blocks.csv") {
    difference_.name = folder.name;
    difference_.steps_in_trace = static_cast<int>(steps_.size());
    int steps = difference_.steps_in_trace;
    for (std::size_t row = 0; row < blocks_.size(); ++row)
      steps = std::max(steps, static_cast<int>(blocks_(row, "step")));
    last_ = last_step(folder, steps);
    stress_scale_ = kStressNoise * greatest_modulus / kTraceTolerance;
    for (std::size_t row = 0; row < steps_.size(); ++row)
      ratio_scale_ = std::max(ratio_scale_, steps_(row, "disp_ratio"));
    for (std::size_t row = 0; row < blocks_.size(); ++row) {
      if (blocks_(row, "step") > last_) continue;
      rows_[static_cast<int>(blocks_(row, "step"))].push_back(row);
      for (const char* c : {"cx", "cy"}) position_scale_ = std::max(position_scale_, std::abs(blocks_(row, c)));
      for (const char* c : {"sxx", "syy", "sxy"}) stress_scale_ = std::max(stress_scale_, std::abs(blocks_(row, c)));
    }
  }

  int last() const { return last_; }

  void step(const StepReport& report) {
    const std::size_t row = static_cast<std::size_t>(report.step) - 1;
    if (row >= steps_.size()) return missing("steps.csv", report.step);
    equal("step number", report.step, steps_(row, "step"), report.step, 0);
    difference_.steps = report.step;
    equal("dt", report.step, steps_(row, "dt"), report.dt, kPrinted);
    equal("oci", report.step, steps_(row, "oci"), report.passes, 0);
    equal("contacts", report.step, steps_(row, "contacts"), report.contacts, 0);
    equal("closed", report.step, steps_(row, "closed"), report.closed, 0);
    equal("penalty", report.step, steps_(row, "penalty"), report.penalty, kPrinted);
    const double off = std::abs(steps_(row, "disp_ratio") - report.displacement_ratio);
    difference_.disp_ratio = worse(difference_.disp_ratio, off / ratio_scale_);
  }

  void frame(const Frame& frame) {
    const auto rows = rows_.find(frame.step);
    if (rows == rows_.end()) return;
    equal("rows of blocks.csv", frame.step, static_cast<double>(rows->second.size()),
          static_cast<double>(frame.elements.size()), 0);
    for (std::size_t row : rows->second) {
      const auto block = static_cast<std::size_t>(blocks_(row, "block")) - 1;
      if (block < frame.elements.size()) compare(row, frame.elements[block]);
    }
  }

  void polygons(const Numbers& table, const Frame& start) {
    equal("blocks", 0, static_cast<double>(table.size()), static_cast<double>(start.elements.size()), 0);
    for (std::size_t row = 0; row < std::min(table.size(), start.elements.size()); ++row)
      polygon(table.text(row, "polygon"), start.elements[row], row + 1);
  }

  void end(const RunOutcome& outcome) {
    if (outcome.end != RunEnd::finished) difference_.unequal.push_back(outcome.reason);
  }

  const TraceDifference& difference() const { return difference_; }

 private:
  void missing(const std::string& table, int step) {
    if (seen_.insert({table, step}).second)
      difference_.unequal.push_back(fmt::format("{} has no step {}", table, step));
  }

  void equal(const std::string& what, int step, double expected, double found, double relative) {
    if (std::abs(found - expected) <= relative * std::abs(expected)) return;
    if (!seen_.insert({what, step}).second) return;  // only the first step of each kind
    difference_.unequal.push_back(fmt::format("{} in step {}: {} for {}", what, step, found, expected));
  }

  void compare(std::size_t row, const ElementFrame& e) {
    ++difference_.rows;
    const auto off = [&](const char* column, double found) { return std::abs(blocks_(row, column) - found); };
    for (double d :
         {off("cx", e.centroid.x), off("cy", e.centroid.y), off("dx", e.displacement.x), off("dy", e.displacement.y)})
      difference_.position = worse(difference_.position, d / position_scale_);
    difference_.rotation = worse(difference_.rotation, off("rot", e.rotation));
    for (double d : {off("sxx", e.stress.xx), off("syy", e.stress.yy), off("sxy", e.stress.xy)})
      difference_.stress = worse(difference_.stress, d / stress_scale_);
  }

  void polygon(const std::string& text, const ElementFrame& element, std::size_t number) {
    std::istringstream stream(text);
    std::vector<double> numbers{std::istream_iterator<double>(stream), {}};
    const std::vector<Point>& loop = element.loops.front();
    equal(fmt::format("vertices of block {}", number), 0, static_cast<double>(numbers.size()) / 2,
          static_cast<double>(loop.size()), 0);
    for (std::size_t i = 0; i < std::min(loop.size(), numbers.size() / 2); ++i)
      difference_.polygon =
          worse(difference_.polygon, distance(loop[i], {numbers[2 * i], numbers[2 * i + 1]}) / position_scale_);
  }

  Numbers steps_;
  Numbers blocks_;
  std::map<int, std::vector<std::size_t>> rows_;
  std::map<std::string, int> seen_;
  int last_ = 0;
  double position_scale_ = std::numeric_limits<double>::min();
  double stress_scale_ = 0;
  double ratio_scale_ = std::numeric_limits<double>::min();
  TraceDifference difference_;
};

double greatest_modulus(const Analysis& analysis) {
  return std::ranges::max(analysis.block_materials, {}, &BlockMaterial::youngs_modulus).youngs_modulus;
}

}  // namespace

bool TraceDifference::holds() const {
  const auto is_small = [](double d) { return d <= kTraceTolerance; };
  return unequal.empty() && steps > 0 && rows > 0 && is_small(polygon) && is_small(position) && is_small(rotation) &&
         is_small(stress);
}

TraceDifference follow_trace(const CaseFolder& folder) {
  const OpenCase open = opened(asked_case({{folder.folder.string()}, {}, "legacy", {}}));
  Follower follower(folder, greatest_modulus(*open.input.problem.analysis));
  const std::vector<Override> as_long{{"steps", fmt::format("{}", follower.last())}};
  const Prepared prepared = prepared_case(configured_under("legacy", open, open.input.problem, as_long));
  Observer observer;
  observer.on_step = [&](const StepReport& report) { follower.step(report); };
  observer.on_frame = [&](const Frame& frame) {
    if (frame.step == 0) follower.polygons(Numbers(folder.folder / "cut_blocks.csv"), frame);
    follower.frame(frame);
  };
  follower.end(run(prepared.scene, 1, observer));
  return follower.difference();
}

}  // namespace keyblock::study
