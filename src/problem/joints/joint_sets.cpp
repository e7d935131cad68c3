// Generates the traces of a joint set, row by row.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "problem/joints/joint_sets.hpp"

#include <fmt/format.h>
#include <gsl/gsl_randist.h>

#include <cmath>

#include "problem/units/unit_conversion.hpp"

namespace keyblock {
namespace {

class TraceMaker {
 public:
  TraceMaker(const JointSet& set, Point centre, double reach)
      : set_(set), centre_(centre), radius_(2 * reach), random_(set.seed, set.stream) {}

  std::vector<Segment> make() {
    double offset = -radius_ - random_.share() * draw(set_.spacing, random_);
    while ((offset += draw(set_.spacing, random_)) < radius_) {
      count();
      if (set_.trace_length)
        add_row(offset);
      else
        add(offset, 0, 3 * radius_);  // long enough to pass the whole circle at every rotation
    }
    return std::move(traces_);
  }

 private:
  void count() {
    if (++draws_ > kMostTraces)
      throw InputError(
          set_.place, fmt::format("expected a joint set of {} traces at most, found one of more; spacing, trace or gap "
                                  "is too small for the outline",
                                  kMostTraces));
  }

  void add_row(double offset) {
    const double half = std::sqrt(std::max(0.0, radius_ * radius_ - offset * offset));
    double length = draw(*set_.trace_length, random_);
    double gap = draw(set_.gap, random_);
    double start = -half - random_.share() * (length + gap);
    while (start < half) {
      count();
      add(offset, start + length / 2, length);
      start += length + gap;
      length = draw(*set_.trace_length, random_);
      gap = draw(set_.gap, random_);
    }
  }

  /// Adds a trace whose middle lies `offset` across and `along` the rows.
  void add(double offset, double along, double length) {
    const Point middle = centre_ + along * direction(set_.dip_deg) + offset * direction(set_.dip_deg + 90);
    const double turn = set_.dip_scatter == 0 ? 0 : gsl_ran_gaussian(random_.get(), 90 * set_.dip_scatter);
    const Point arm = (length / 2) * direction(set_.dip_deg + turn);
    traces_.push_back({middle - arm, middle + arm});
  }

  /// Returns an exact direction along the axes, so that level and upright sets stay so.
  static Point direction(double angle_deg) {
    const double turn = std::remainder(angle_deg, 360);
    if (turn == 0) return {1, 0};
    if (turn == 90) return {0, 1};
    if (turn == -90) return {0, -1};
    if (std::abs(turn) == 180) return {-1, 0};
    return {std::cos(kDegree * turn), std::sin(kDegree * turn)};
  }

  const JointSet& set_;
  Point centre_;
  double radius_;
  RandomStream random_;
  std::size_t draws_ = 0;
  std::vector<Segment> traces_;
};

}  // namespace

std::vector<Segment> traces(const JointSet& set, Point centre, double reach) {
  return TraceMaker(set, centre, reach).make();
}

}  // namespace keyblock
