// Sums the energy balance and computes its closure.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "result/ledger.hpp"

#include <algorithm>
#include <cmath>

namespace keyblock {
namespace {

double largest_of(const StoredEnergy& e, const StoredEnergy& start) {
  return std::max({e.kinetic, e.strain, std::abs(e.gravity - start.gravity), e.contact});
}

double largest_of(const EnergyFlow& f) {
  double largest = 0;
  for (double flow : {f.external, f.projection, f.geometric, f.creep, f.friction, f.damping, f.impact, f.closing,
                      f.clean_up, f.rupture, f.fracture, f.plastic, f.algorithmic, f.change})
    largest = std::max(largest, std::abs(flow));
  return largest;
}

double over(double part, double whole) {
  return whole > 0 ? part / whole : 0;
}

}  // namespace

EnergyFlow& EnergyFlow::operator+=(const EnergyFlow& other) {
  external += other.external;
  projection += other.projection;
  geometric += other.geometric;
  creep += other.creep;
  change += other.change;
  friction += other.friction;
  damping += other.damping;
  impact += other.impact;
  closing += other.closing;
  clean_up += other.clean_up;
  rupture += other.rupture;
  fracture += other.fracture;
  plastic += other.plastic;
  algorithmic += other.algorithmic;
  return *this;
}

Momentum& Momentum::operator+=(const Momentum& other) {
  linear = linear + other.linear;
  angular += other.angular;
  return *this;
}

void LedgerSums::add(const LedgerRow& row) {
  if (!is_begun) first = row;
  const double given = row.stored.total() - row.flow.external - row.flow.change + row.flow.fracture;
  const double apart_from_contact = given - row.stored.contact;
  if (!is_begun) least = given;
  is_begun = true;
  made = std::max(made, apart_from_contact - least);
  above_start = std::max(above_start, apart_from_contact - (first.stored.total() - first.stored.contact));
  least = std::min(least, given);
  largest_stored = std::max(largest_stored, largest_of(row.stored, first.stored));
  largest = std::max({largest, largest_of(row.stored, first.stored), largest_of(row.flow)});
  const double change = row.stored.total() - first.stored.total();
  energy_gap = std::max(energy_gap, std::abs(change - row.flow.gained() + row.flow.lost()));
  linear_gap = std::max(linear_gap, length(row.momentum.linear - first.momentum.linear - row.impulse.linear));
  linear_size = std::max(linear_size, row.momentum_size.linear);
  angular_gap = std::max(angular_gap, std::abs(row.momentum.angular - first.momentum.angular - row.impulse.angular));
  angular_size = std::max(angular_size, row.momentum_size.angular);
}

double LedgerSums::energy_closure() const {
  return over(energy_gap, largest);
}

double LedgerSums::linear_momentum_closure() const {
  return over(linear_gap, linear_size);
}

double LedgerSums::angular_momentum_closure() const {
  return over(angular_gap, angular_size);
}

double LedgerSums::energy_made(const LedgerScope& scope) const {
  return over(scope.has_flows ? made : above_start, largest_stored);
}

}  // namespace keyblock
