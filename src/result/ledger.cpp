// Sums of the ledger and how well they close.
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
                      f.clean_up, f.rupture, f.algorithmic})
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
  friction += other.friction;
  damping += other.damping;
  impact += other.impact;
  closing += other.closing;
  clean_up += other.clean_up;
  rupture += other.rupture;
  algorithmic += other.algorithmic;
  return *this;
}

Momentum& Momentum::operator+=(const Momentum& other) {
  linear = linear + other.linear;
  angular += other.angular;
  return *this;
}

double largest_energy(const Ledger& ledger) {
  double largest = 0;
  for (const LedgerRow& row : ledger.rows)
    largest = std::max({largest, largest_of(row.stored, ledger.rows.front().stored), largest_of(row.flow)});
  return largest;
}

double energy_closure(const Ledger& ledger) {
  double greatest = 0;
  for (const LedgerRow& row : ledger.rows) {
    const double change = row.stored.total() - ledger.rows.front().stored.total();
    greatest = std::max(greatest, std::abs(change - row.flow.gained() + row.flow.lost()));
  }
  return over(greatest, largest_energy(ledger));
}

double linear_momentum_closure(const Ledger& ledger) {
  double greatest = 0;
  double size = 0;
  for (const LedgerRow& row : ledger.rows) {
    greatest =
        std::max(greatest, length(row.momentum.linear - ledger.rows.front().momentum.linear - row.impulse.linear));
    size = std::max(size, row.momentum_size.linear);
  }
  return over(greatest, size);
}

double angular_momentum_closure(const Ledger& ledger) {
  double greatest = 0;
  double size = 0;
  for (const LedgerRow& row : ledger.rows) {
    greatest =
        std::max(greatest, std::abs(row.momentum.angular - ledger.rows.front().momentum.angular - row.impulse.angular));
    size = std::max(size, row.momentum_size.angular);
  }
  return over(greatest, size);
}

}  // namespace keyblock
