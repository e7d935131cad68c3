// Traces of joint sets have the requested statistics: dip, spacing, length, gap.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "problem/joints/joint_sets.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace keyblock::joint_sets_test {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

JointSet rows(double dip_deg) {
  JointSet set;
  set.dip_deg = dip_deg;
  set.spacing = {1, 0, Distribution::lognormal};
  set.trace_length = RandomLength{5, 0, Distribution::lognormal};
  set.gap = {2, 0, Distribution::lognormal};
  set.seed = 3;
  return set;
}

struct Sample {
  int count = 0;
  double mean = 0;
  double deviation = 0;
};

Sample sample_of(const std::vector<double>& values) {
  Sample s{static_cast<int>(values.size()), 0, 0};
  for (const double v : values) s.mean += v / s.count;
  for (const double v : values) s.deviation += (v - s.mean) * (v - s.mean);
  s.deviation = std::sqrt(s.deviation / (s.count - 1));
  return s;
}

/// A row: its offset across, and the starts and ends of its traces along it.
struct Row {
  double offset = 0;
  std::vector<std::pair<double, double>> traces;
};

/// Traces come row by row; within one their offsets differ by rounding only.
std::vector<Row> rows_of(const std::vector<Segment>& all, double dip_deg) {
  const Point along{std::cos(kDegree * dip_deg), std::sin(kDegree * dip_deg)}, across{-along.y, along.x};
  std::vector<Row> rows;
  for (const Segment& trace : all) {
    const double offset = dot(across, trace.start);
    if (rows.empty() || std::abs(rows.back().offset - offset) > 1e-9) rows.push_back({offset, {}});
    rows.back().traces.push_back({dot(along, trace.start), dot(along, trace.end)});
  }
  return rows;
}

void expect_sample(const std::vector<double>& values, double mean, double deviation) {
  const Sample s = sample_of(values);
  EXPECT_NEAR(s.mean, mean, 3 * deviation / std::sqrt(s.count)) << s.count;
  EXPECT_NEAR(s.deviation, deviation, 0.1 * deviation) << s.count;
}

}  // namespace

TEST(JointSets, spacing_length_and_gap_have_the_means_and_scatters_asked_for) {
  struct Case {
    Distribution law;
    double scatter;
  };
  for (const Case c :
       {Case{Distribution::lognormal, 0.3}, Case{Distribution::exponential, 1}, Case{Distribution::normal, 0.2}}) {
    JointSet set = rows(60);
    set.spacing = {1, c.scatter, c.law};
    set.trace_length = RandomLength{5, c.scatter, c.law};
    set.gap = {2, c.scatter, c.law};
    std::vector<double> spacings, lengths, gaps;
    double last = NAN;
    for (const auto& [offset, traces] : rows_of(traces(set, {10, -4}, 200), 60)) {
      if (!std::isnan(last)) spacings.push_back(offset - last);
      last = offset;
      for (std::size_t i = 0; i < traces.size(); ++i) {
        lengths.push_back(traces[i].second - traces[i].first);
        if (i > 0) gaps.push_back(traces[i].first - traces[i - 1].second);
      }
    }
    expect_sample(spacings, 1, c.scatter);
    expect_sample(lengths, 5, 5 * c.scatter);
    expect_sample(gaps, 2, 2 * c.scatter);
  }
}

TEST(JointSets, dip_scatters_by_its_share_of_a_quarter_turn) {
  JointSet set = rows(30);
  set.dip_scatter = 0.1;
  std::vector<double> dips;
  for (const Segment& trace : traces(set, {}, 60))
    dips.push_back(std::atan2(trace.end.y - trace.start.y, trace.end.x - trace.start.x) / kDegree);
  expect_sample(dips, 30, 9);
}

TEST(JointSets, without_a_length_traces_pass_the_whole_circle) {
  JointSet set = rows(90);
  set.trace_length.reset();
  const auto all = traces(set, {5, 5}, 10);
  EXPECT_NEAR(static_cast<double>(all.size()), 40, 1);
  for (const Segment& trace : all) {
    EXPECT_EQ(trace.start.x, trace.end.x) << "upright rows are exactly upright";
    EXPECT_LE(trace.start.y, -15);
    EXPECT_GE(trace.end.y, 25);
  }
}

TEST(JointSets, rows_do_not_begin_at_the_same_phase) {
  std::vector<double> phases;
  for (const auto& [offset, traces] : rows_of(traces(rows(0), {}, 100), 0))
    phases.push_back(std::fmod(traces.front().first + 7000, 7));
  // Uniform over one trace and its gap: mean 3.5, deviation 7 / √12.
  expect_sample(phases, 3.5, 7 / std::sqrt(12.0));
}

TEST(JointSets, more_traces_than_can_be_cut_are_refused) {
  JointSet set = rows(0);
  set.spacing.mean = 1e-9;
  EXPECT_THROW(traces(set, {}, 10), InputError);
  set = rows(0);
  set.trace_length->mean = set.gap.mean = 1e-7;
  EXPECT_THROW(traces(set, {}, 10), InputError);
}

}  // namespace keyblock::joint_sets_test
