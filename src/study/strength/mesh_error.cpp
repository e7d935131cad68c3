// Makes one more search on a coarser mesh, from the factor found.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/strength/mesh_error.hpp"

#include <fmt/format.h>

#include <cmath>
#include <exception>

#include "base/context.hpp"

namespace keyblock::study {
namespace {

constexpr double kUp = 1.05;  // ratio of factors on the way to the first that falls: errors are small

MeshError none(const std::string& why) {
  MeshError error;
  error.why_none = why;
  return error;
}

}  // namespace

MeshError mesh_error(const StrengthTrials& trials, const FactorOfSafety& found, SearchOptions options) {
  options.guess = *found.bracket.stands;
  options.from.reset();
  options.to.reset();
  options.up = kUp;
  options.seeks_knee = false;
  try {
    const FactorOfSafety coarse = factor_of_safety(trials.on_coarser_mesh(kCoarserTimes), options);
    if (coarse.end != SearchEnd::bracketed) {
      MeshError error = none(fmt::format("the search on a coarser mesh is {}", name_of(coarse.end)));
      error.is_stopped = coarse.end == SearchEnd::stopped;
      return error;
    }
    MeshError error;
    error.coarse = coarse.bracket;
    const double fine = found.bracket.middle();
    const double difference = coarse.bracket.middle() - fine;
    const auto of_power = [&](double power) { return difference / fine / (std::pow(kCoarserTimes, power) - 1); };
    error.share = of_power(1.5);
    error.least = of_power(2);
    error.most = of_power(1);
    error.uncertainty = (found.bracket.width() + coarse.bracket.width()) / 2 / fine;
    error.extrapolated = fine * (1 - error.share);
    return error;
  } catch (const StopRequested&) {
    MeshError error = none("the search on a coarser mesh is stopped");
    error.is_stopped = true;
    return error;
  } catch (const std::exception& error) {  // the factor found is not lost
    return none(fmt::format("no coarser mesh can be made ({})", error.what()));
  }
}

std::string in_words(const MeshError& error) {
  if (!error.coarse) return fmt::format("mesh error not estimated: {}", error.why_none);
  const std::string because =
      fmt::format("sides {:g} times as long give {:.4g}", kCoarserTimes, error.coarse->middle());
  if (std::abs(error.most) <= error.uncertainty)
    return fmt::format("mesh error below {:.2g} %: {}", 100 * error.uncertainty, because);
  return fmt::format("mesh error about {:+.2g} % ({:+.2g} to {:+.2g} %): {}; finer meshes are {}, towards {:.4g}",
                     100 * error.share, 100 * error.least, 100 * error.most, because,
                     error.share > 0 ? "lower" : "higher", error.extrapolated);
}

}  // namespace keyblock::study
