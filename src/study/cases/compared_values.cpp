// Picks values from the frames of a run.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/cases/compared_values.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "base/error.hpp"
#include "model/continuum.hpp"
#include "settings/profile.hpp"

namespace keyblock::study {
namespace {

const char* noun_of(const ComparedValue& value) {
  const std::optional<Owner> owner = owner_of(value.quantity);
  if (owner == Owner::point) return "measured point";
  if (owner == Owner::tip) return "crack tip";
  return owner == Owner::support ? "prescribed displacement" : "block";
}

}  // namespace

bool ComparedValue::holds() const {
  return computed && std::abs(error()) <= tolerance;
}

bool ComparedValue::is_listed_miss() const {
  return is_judged && !listed_miss.empty() && computed && std::isfinite(*computed) && !holds();
}

std::vector<ComparedValue> values_to_find(const std::vector<ExpectedValue>& expected, const std::string& profile) {
  std::vector<ComparedValue> values;
  for (const ExpectedValue& e : expected)
    values.push_back({e.quantity,
                      e.block,
                      e.time,
                      e.value,
                      {},
                      e.tolerance,
                      e.tolerance_reason,
                      e.source,
                      e.listed_miss,
                      e.is_judged_in(rules_of(profile))});
  return values;
}

void require_numbers(const std::vector<ComparedValue>& values, const Model& model, const std::string& file) {
  const Continuum* bodies = model.continuum.get();
  const auto count_of = [&](std::optional<Owner> owner) {
    if (owner == Owner::point) return model.measured_points.size();
    if (owner == Owner::support) return bodies ? bodies->prescribed.size() : 0;
    if (owner == Owner::tip) return bodies ? bodies->manifold.tips.size() : 0;
    return model.elements.size();
  };
  for (const ComparedValue& v : values) {
    const std::size_t count = count_of(owner_of(v.quantity));
    if (v.block && (*v.block < 1 || *v.block > static_cast<int>(count)))
      throw InputError({file, 0, 0}, fmt::format("expected a {} from 1 to {}, found {}", noun_of(v), count, *v.block));
  }
}

void pick(std::vector<ComparedValue>& values, RunSoFar& run, const Frame& frame, double same) {
  const double last = run.now().time;
  std::vector<std::pair<ComparedValue*, double>> between;
  for (ComparedValue& v : values)
    if (!run.now().elements.empty() && v.time > last + same && v.time < frame.time - same)
      between.emplace_back(&v, quantity_of(run, v.quantity, v.block));
  run.add(frame);
  for (const auto& [v, before] : between)
    v->computed = std::lerp(before, quantity_of(run, v->quantity, v->block), (v->time - last) / (frame.time - last));
  for (ComparedValue& v : values)
    if (std::abs(frame.time - v.time) <= same) v.computed = quantity_of(run, v.quantity, v.block);
}

}  // namespace keyblock::study
