// Every body of a scene as a rigid block, those on covers too: what impacts and their overlaps are settled on.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "step/standard_scene.hpp"

namespace keyblock {

/// Bodies on covers follow the elements of the model, one block each with three unknowns: forces between few blocks are few numbers,
/// where forces between covers couple with all others of their bodies.
class RigidView {
 public:
  /// At q. The scene must outlive it.
  RigidView(const StandardScene& scene, const UnknownsTable& q);

  /// Rows of the scene as rows of these blocks.
  ContactRows rows(ContactRows of_scene) const;
  const Flexibility& flexibility() const { return flexibility_; }
  /// B Gᵀ f as unknowns of the scene; `rows`: of these blocks.
  UnknownsTable answer(const ContactRows& rows, const Eigen::VectorXd& forces) const;

 private:
  ContactRow row(const ContactRow& of_scene) const;

  const StandardScene& scene_;
  int element_count_;
  std::shared_ptr<const RigidCovers> covers_;  ///< none where nothing hangs on covers
  Flexibility flexibility_;
};

}  // namespace keyblock
