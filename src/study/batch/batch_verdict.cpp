// Judges the outcome first, then the answers.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/batch/batch_verdict.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

namespace keyblock::study {
namespace {

// Times that differ by less than this fraction are the same end; runs with cut steps end earlier.
constexpr double kSameEnd = 0.01;

using report::CatalogueAnswer;
using report::CatalogueVerdict;

std::string place_of(const CatalogueAnswer& answer) {
  return fmt::format("{:.4g} in {} (element {})", answer.measures->displacement, answer.profile,
                     answer.measures->displaced_element);
}

/// Describes different ends of two answers; empty if they are the same.
std::string of_their_ends(const CatalogueAnswer& one, const CatalogueAnswer& other) {
  if (std::abs(one.time - other.time) <= kSameEnd * std::max(one.time, other.time)) return {};
  return fmt::format("; {} ends at time {:.4g}, {} at {:.4g}", one.profile, one.time, other.profile, other.time);
}

/// Describes the difference of two answers; empty if they agree.
std::string how_they_differ(const CatalogueAnswer& one, const CatalogueAnswer& other) {
  if (!one.measures || !other.measures) return {};
  const double larger = std::max(one.measures->displacement, other.measures->displacement);
  if (!(larger > 0)) return {};
  const double anywhere = std::abs(one.measures->displacement - other.measures->displacement) / larger;
  if (anywhere > kAgreement)
    return fmt::format("greatest displacement {} and {}: {:.0f} % apart{}", place_of(one), place_of(other),
                       100 * anywhere, of_their_ends(one, other));
  if (one.of_what.empty() || one.of_what != other.of_what) return {};
  const double apart = std::hypot(one.dx - other.dx, one.dy - other.dy);
  if (apart <= kAgreement * larger) return {};
  return fmt::format("{} ends {:.4g} apart in {} and {}: {:.0f} % of the greatest displacement{}", one.of_what, apart,
                     one.profile, other.profile, 100 * apart / larger, of_their_ends(one, other));
}

bool is_finished(const CatalogueAnswer& answer) {
  return answer.end == "finished";
}

/// Describes the result of each profile if the only failures are scenes without equilibrium; otherwise empty.
std::string without_equilibrium(const report::CatalogueRow& row) {
  std::string why;
  bool has_none = false;
  for (const CatalogueAnswer& answer : row.answers) {
    const bool falls = answer.failure == "no_equilibrium";
    if (!falls && !is_finished(answer)) return {};
    has_none = has_none || falls;
    why += fmt::format("{}{}: {}", why.empty() ? "" : "; ", answer.profile,
                       falls ? answer.reason : fmt::format("came to its end, {} steps", answer.steps));
  }
  return has_none ? why : std::string();
}

/// Returns the reason why a profile did not run the case; empty if all ran it.
std::string not_run(const report::CatalogueRow& row) {
  for (const CatalogueAnswer& answer : row.answers)
    if (!is_finished(answer) && !answer.measures) return fmt::format("not run by {}: {}", answer.profile, answer.end);
  return {};
}

}  // namespace

CatalogueVerdict verdict_of(const report::CatalogueRow& row, BatchAim aim) {
  if (std::string why = without_equilibrium(row); !why.empty()) return {"no equilibrium", std::move(why)};
  if (row.outcome == "failed") return {"failed", row.message};
  if (row.outcome == "listed") return {"listed", "no case"};
  if (aim == BatchAim::convert) return {"converted", ""};
  if (aim == BatchAim::check) return {"read", ""};
  if (row.answers.empty()) return {"read", "nothing to run: no geometry or no analysis goes with it"};
  if (row.answers.size() > 1)
    if (std::string how = how_they_differ(row.answers.front(), row.answers.back()); !how.empty())
      return {"differs", std::move(how)};
  if (std::string why = not_run(row); !why.empty()) return {"ran", std::move(why)};
  return {"ran", row.outcome == "warnings" ? row.message : ""};
}

}  // namespace keyblock::study
