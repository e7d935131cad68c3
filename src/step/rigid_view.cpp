// Entries of cover functions are summed to the three of their bodies.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/rigid_view.hpp"

#include <utility>

namespace keyblock {

RigidView::RigidView(const StandardScene& scene, const UnknownsTable& q)
    : scene_(scene),
      element_count_(static_cast<int>(scene.bodies.size())),
      flexibility_{rigid_mass_inverses(scene.bodies)} {
  if (!scene.covers) return;
  covers_ = scene.covers->rigid(q.covers);
  for (const Eigen::Matrix3d& inverse : covers_->inverse()) flexibility_.blocks.push_back(inverse);
}

ContactRow RigidView::row(const ContactRow& of_scene) const {
  ContactRow row = of_scene;
  row.covers.clear();
  const auto side = [&](ElementIndex e, ElementIndex& element, ContactRow::Row& part) {
    if (!scene_.reference.is_on_covers(e)) return;
    const int body = scene_.covers->body_of(e);
    element = ElementIndex{element_count_ + body};
    part = covers_->project(body, of_scene.covers).transpose();
  };
  side(of_scene.vertex_element, row.vertex_element, row.of_vertex);
  side(of_scene.edge_element, row.edge_element, row.of_edge);
  // Both sides of one body are in its projection already.
  if (row.vertex_element == row.edge_element && !of_scene.covers.empty()) row.of_edge.setZero();
  return row;
}

ContactRows RigidView::rows(ContactRows of_scene) const {
  if (!covers_) return of_scene;
  for (ContactRow& of : of_scene) of = row(of);
  return of_scene;
}

UnknownsTable RigidView::answer(const ContactRows& rows, const Eigen::VectorXd& forces) const {
  UnknownsTable all = answer_of_blocks(rows, flexibility_.blocks, forces);
  if (!covers_) return all;
  UnknownsTable of_scene;
  for (ElementIndex e : indices(scene_.bodies)) of_scene.push_back(std::move(all[e]));
  of_scene.covers = Eigen::VectorXd::Zero(covers_->size());
  for (std::size_t b = 0; b < covers_->inverse().size(); ++b)
    covers_->add(static_cast<int>(b), all[ElementIndex{element_count_ + static_cast<int>(b)}], of_scene.covers);
  return of_scene;
}

}  // namespace keyblock
