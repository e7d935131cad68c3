// Transforms matrix blocks of elements into those of covers.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "legacy/step/cover_unknowns.hpp"

#include <algorithm>
#include <numeric>

#include "legacy/step/hanging.hpp"
#include "model/shared_covers.hpp"

namespace keyblock {

CoverUnknowns::CoverUnknowns(const Model& model, const State& state)
    : model_(model), has_shared_covers_(!model.nodes.empty()) {
  for (ElementIndex e : indices(model.elements)) {
    const Element& element = model.elements[e];
    const auto last = static_cast<std::size_t>(*std::ranges::max_element(element.covers));
    if (sizes_.size() <= last) sizes_.resize(last + 1, 0);
    const int count = element.basis->unknown_count();
    for (const int cover : element.covers) sizes_[static_cast<std::size_t>(cover)] = element.is_on_covers() ? 2 : count;
    if (has_shared_covers_) parts_.push_back(parts_of(element, state.elements[e].centroid, state));
  }
  first_rows_.assign(sizes_.size() + 1, 0);
  std::partial_sum(sizes_.begin(), sizes_.end(), first_rows_.begin() + 1);
}

std::vector<CoverUnknowns::Part> CoverUnknowns::parts_of(const Element& element, Point centroid, const State& state) {
  const int count = element.basis->unknown_count();
  if (!element.is_on_covers()) return {{element.covers[0], UnknownBlock::Identity(count, count)}};
  const Eigen::Matrix<double, 6, 6> a = affine_from_nodes(element, centroid, state);
  std::vector<Part> parts;
  for (int i = 0; i < 3; ++i)
    parts.push_back({element.covers[static_cast<std::size_t>(i)], a.middleCols<2>(2 * i).topRows(count)});
  return parts;
}

System CoverUnknowns::of_covers(const System& of_elements) const {
  if (!has_shared_covers_) return of_elements;
  BlockMatrix::Pairs coupled;
  for (ElementIndex e : indices(parts_))
    for (const auto& [column, block] : of_elements.matrix.row(e.value))
      for (const Part& a : parts_[e])
        for (const Part& b : parts_[ElementIndex{column}])
          if (a.cover != b.cover) coupled.push_back(std::minmax(a.cover, b.cover));
  std::ranges::sort(coupled);
  const auto repeated = std::ranges::unique(coupled);
  coupled.erase(repeated.begin(), repeated.end());
  System system(sizes_, coupled);
  for (ElementIndex e : indices(parts_)) {
    const auto load = of_elements.load.segment(of_elements.matrix.first_row(e.value), of_elements.matrix.size(e.value));
    for (const Part& a : parts_[e]) system.load_of(a.cover) += a.share.transpose() * load;
    for (const auto& [column, block] : of_elements.matrix.row(e.value)) {
      const bool is_diagonal = column == e.value;
      for (const Part& a : parts_[e]) {
        const UnknownBlock rows = a.share.transpose() * block;
        for (const Part& b : parts_[ElementIndex{column}]) {
          if (is_diagonal && a.cover > b.cover) continue;  // the transpose of the entry at (b, a)
          const UnknownBlock share = rows * b.share;
          system.matrix.add(a.cover, b.cover, share);
          if (!is_diagonal && a.cover == b.cover) system.matrix.add(a.cover, a.cover, UnknownBlock(share.transpose()));
        }
      }
    }
  }
  return system;
}

std::optional<Solution> CoverUnknowns::solve(const System& of_elements, const SystemKind& kind, Solver& solver) const {
  return has_shared_covers_ ? solver.solve(of_covers(of_elements), kind) : solver.solve(of_elements, kind);
}

Eigen::VectorXd CoverUnknowns::steady(const State& state, double dt) const {
  if (has_shared_covers_) return {};
  Eigen::VectorXd increments(first_rows_.back());
  for (ElementIndex e : indices(model_.elements)) {
    const auto cover = static_cast<std::size_t>(e.value);
    increments.segment(first_rows_[cover], sizes_[cover]) = dt * state.elements[e].velocity;
  }
  return increments;
}

Unknowns CoverUnknowns::unknowns_of(const Solution& solution, ElementIndex element) const {
  const auto of_cover = [&](int cover) {
    const auto c = static_cast<std::size_t>(cover);
    return solution.x.segment(first_rows_[c], sizes_[c]);
  };
  if (!has_shared_covers_) return of_cover(element.value);
  Unknowns sum = Unknowns::Zero(model_.elements[element].basis->unknown_count());
  for (const Part& part : parts_[element]) sum += part.share * of_cover(part.cover);
  return sum;
}

Increments CoverUnknowns::increments(const Solution& solution) const {
  Increments increments(model_.elements.size());
  for (ElementIndex e : indices(model_.elements)) increments[e] = unknowns_of(solution, e);
  return increments;
}

std::vector<Point> CoverUnknowns::node_steps(const Solution& solution) const {
  std::vector<Point> steps(model_.nodes.size());
  const std::vector<bool> carry = carrying_nodes(model_);
  for (std::size_t node = 0; node < steps.size(); ++node)
    if (carry[node]) steps[node] = {solution.x[first_rows_[node]], solution.x[first_rows_[node] + 1]};
  return steps;
}

}  // namespace keyblock
