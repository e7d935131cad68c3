// Applies the product rule; see tip_shape.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/tips/tip_shape.hpp"

namespace keyblock {

void TipShape::add_values(Point x, Eigen::RowVectorXd& values) const {
  std::vector<Eigen::RowVector4d> of_branch;
  for (const Branch& b : branches) of_branch.push_back(near_tip_functions(b.tip, b.middle, x));
  Eigen::Index place = first;
  for (const Function& f : functions) values(place++) += f.weight.at(x) * of_branch[f.branch].dot(f.mix);
}

void TipShape::add_gradients(Point x, Eigen::Matrix2Xd& gradients) const {
  std::vector<NearTipValues> of_branch;
  for (const Branch& b : branches) of_branch.push_back(near_tip_values(b.tip, b.middle, x));
  Eigen::Index place = first;
  for (const Function& f : functions) {
    const NearTipValues& v = of_branch[f.branch];
    const Eigen::Vector2d of_weight(f.weight.gradient.x, f.weight.gradient.y);
    gradients.col(place++) += f.weight.at(x) * (v.gradients * f.mix) + v.values.dot(f.mix) * of_weight;
  }
}

}  // namespace keyblock
