// Holds the list of terms. A new term is a new file pair and a new row here.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "legacy/terms/assemble.hpp"

#include <array>
#include <utility>

#include "legacy/terms/body_acceleration.hpp"
#include "legacy/terms/body_force.hpp"
#include "legacy/terms/bolt.hpp"
#include "legacy/terms/damping.hpp"
#include "legacy/terms/elastic.hpp"
#include "legacy/terms/fixed_point.hpp"
#include "legacy/terms/inertia.hpp"
#include "legacy/terms/initial_stress.hpp"
#include "legacy/terms/point_load.hpp"

namespace keyblock {
namespace {

constexpr std::array<std::pair<TermKind, Term>, 9> kTerms{{
    {TermKind::fixed_point, add_fixed_point},
    {TermKind::bolt, add_bolt},
    {TermKind::elastic, add_elastic},
    {TermKind::initial_stress, add_initial_stress},
    {TermKind::body_force, add_body_force},
    {TermKind::body_acceleration, add_body_acceleration},
    {TermKind::point_load, add_point_load},
    {TermKind::inertia, add_inertia},
    {TermKind::damping, add_damping},
}};

}  // namespace

std::vector<Term> terms_for(const Requirements& requirements) {
  std::vector<Term> terms;
  for (const auto& [kind, term] : kTerms) {
    if (requirements.has(kind)) terms.push_back(term);
  }
  return terms;
}

System assemble(const std::vector<Term>& terms, const StepContext& context, const BlockMatrix::Pairs& coupled) {
  std::vector<int> sizes;
  for (const Element& element : context.model.elements) sizes.push_back(element.basis->unknown_count());
  System system(std::move(sizes), coupled);
  for (Term term : terms) term(context, system);
  return system;
}

}  // namespace keyblock
