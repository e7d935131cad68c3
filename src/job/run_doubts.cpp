// Each limit with its own sentence.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "job/run_doubts.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "material/elastic.hpp"
#include "model/body_load.hpp"

namespace keyblock {
namespace {

// Nothing else gives energy: the books of dynamics shi hold neither the work of other loads nor what bolts store.
bool is_of_weight_alone(const Prepared& prepared) {
  const Model& model = prepared.scene.model;
  const auto is_driven = [](const CarriedPoint& point) { return point.curve.times.size() > 1; };
  return model.loading_points.empty() && model.bolts.empty() && std::ranges::none_of(model.fixed_points, is_driven) &&
         !has_body_acceleration(prepared.scene.settings);
}

bool keeps_energy(const Prepared& prepared, const RunRecord& record) {
  if (record.is_static || !record.ledger_sums.is_begun) return false;
  return record.outcome.ledger_scope.has_flows || is_of_weight_alone(prepared);
}

std::string law_of(const Element& element) {
  if (!element.is_on_covers()) return {};
  return fmt::format("; the elastic law gives way below a stretch of {:.2g}", kSofteningStretch);
}

}  // namespace

Warnings doubts(const Prepared& prepared, const RunRecord& record, const Place& place) {
  const TrustLimits& limits = prepared.scene.settings.trust;
  Warnings found;
  if (const double share = record.totals.penetration_share; share > limits.penetration)
    found.push_back(
        {"sunk_beyond_limit", place,
         fmt::format("blocks lay as deep in one another as {:.2g} of the size of the smaller; beyond {:.2g} "
                     "(penetration_limit) the run is not trusted",
                     share, limits.penetration)});
  if (const double share = record.extremes.area_share; share < limits.crushing)
    found.push_back({"crushed_beyond_limit", place,
                     fmt::format("element {} is pressed to {:.2g} of its area{}; below {:.2g} (crushing_limit) the run "
                                 "is not trusted",
                                 record.extremes.crushed_element + 1, share,
                                 law_of(prepared.scene.model.elements[ElementIndex{record.extremes.crushed_element}]),
                                 limits.crushing)});
  if (!keeps_energy(prepared, record)) return found;
  if (const double made = record.ledger_sums.energy_made(record.outcome.ledger_scope); made > limits.energy)
    found.push_back({"energy_beyond_limit", place,
                     fmt::format("energy came from nothing: {:.2g} of the largest there was; beyond {:.2g} "
                                 "(energy_limit) the run is not trusted",
                                 made, limits.energy)});
  return found;
}

}  // namespace keyblock
