// Makes failures of steps from values; see stepper.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/stepper.hpp"

#include <utility>

#include "base/sentences/sentences.hpp"

namespace keyblock {

StepFailure failed(std::string_view frame, const Facts& values, Finding cause, FailureKind kind) {
  std::string reason = framed(frame, values, cause);
  cause.facts.numbers.insert(cause.facts.numbers.end(), values.numbers.begin(), values.numbers.end());
  StepFailure failure{std::move(reason), {}, kind};
  failure.cause = std::move(cause);
  return failure;
}

}  // namespace keyblock
