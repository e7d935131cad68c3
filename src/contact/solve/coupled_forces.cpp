// Assembles row by row, over the forces on the same bodies.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/solve/coupled_forces.hpp"

#include <utility>

namespace keyblock {

CoupledForces::CoupledForces(const ContactMatrix& w, const ActiveSet& set, const Eigen::VectorXd& added) {
  const auto size = static_cast<Eigen::Index>(set.rows.size());
  Eigen::SparseMatrix<double, Eigen::RowMajor> a(size, size);
  for (Eigen::Index u = 0; u < size; ++u) {
    const Eigen::Index force = set.rows[static_cast<std::size_t>(u)];
    a.startVec(u);
    Eigen::Index last = -1;  // both forces of a pair may depend on one unknown
    const auto put = [&](Eigen::Index unknown, double value) {
      if (unknown == last)
        a.data().value(static_cast<Eigen::Index>(a.data().size()) - 1) += value;
      else
        a.insertBack(u, unknown) = value;
      last = unknown;
    };
    for (const CoupledRows::Entry& entry : w.coupled().of(force)) {
      const ActiveSet::Column& column = set.columns[static_cast<std::size_t>(entry.row)];
      if (column.unknown < 0) continue;
      const double own = entry.row == force ? w.added()[force] + added[force] : 0;
      if (column.coupled != 0)
        put(set.columns[static_cast<std::size_t>(entry.row - 1)].unknown, column.coupled * entry.value);
      put(column.unknown, column.factor * (entry.value + own));
    }
  }
  a.finalize();
  const Eigen::SparseMatrix<double> by_columns(a);
  auto factor = std::make_unique<SparseLu>(by_columns);
  try {
    factor->factorise(by_columns);
    factor_ = std::move(factor);
  } catch (const SingularMatrix&) {  // is_regular reports it
  }
}

}  // namespace keyblock
