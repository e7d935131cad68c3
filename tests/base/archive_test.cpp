// Saved values come back, and a mismatch is refused by name.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/archive.hpp"

#include <gtest/gtest.h>

#include <map>

namespace keyblock::archive_test {
namespace {

struct Scene {
  double time = 0;
  bool is_moving = false;
  std::string name;
  std::vector<int> rows;
  std::map<int, double> forces;

  bool operator==(const Scene&) const = default;
};

void describe(Archive& archive, Scene& scene) {
  archive.value("time", scene.time);
  archive.value("moving", scene.is_moving);
  archive.value("name", scene.name);
  archive.list("rows", scene.rows, [&](int& row) { archive.value("row", row); });
  archive.map("forces", scene.forces, [&](int& key, double& force) {
    archive.value("key", key);
    archive.value("force", force);
  });
}

std::unique_ptr<ArchiveNode> copy_of(const ArchiveNode& node) {
  auto copy = std::make_unique<ArchiveNode>();
  copy->name = node.name;
  copy->column = node.column;
  for (const auto& child : node.children) copy->children.push_back(copy_of(*child));
  return copy;
}

Archive saved(Scene scene) {
  Archive archive;
  describe(archive, scene);
  return {"f.h5", copy_of(archive.root())};
}

template <class Restore>
std::string refusal(Archive archive, Restore restore) {
  try {
    restore(archive);
    return {};
  } catch (const InputError& error) {
    return error.what();
  }
}

const Scene kScene{0.1 + 0.2, true, "slope", {3, -4, 5}, {{-1, 0.5}, {7, -0.25}}};

}  // namespace

TEST(Archive, what_is_saved_comes_back_to_the_last_bit) {
  Archive archive = saved(kScene);
  EXPECT_TRUE(archive.is_restoring());
  Scene scene{9, false, "other", {1}, {{2, 2}}};
  describe(archive, scene);
  EXPECT_EQ(scene, kScene);
}

TEST(Archive, a_value_that_is_missing_or_of_another_kind_is_refused_by_its_name) {
  double number = 0;
  std::string text;
  const auto ask_for_speed = [&](Archive& archive) { archive.value("speed", number); };
  const auto ask_for_a_text = [&](Archive& archive) { archive.value("time", text); };
  const auto ask_twice = [&](Archive& archive) {
    archive.value("time", number);
    archive.value("time", number);
  };
  EXPECT_EQ(refusal(saved(kScene), ask_for_speed), "f.h5: error: expected a saved value, found none (speed)");
  EXPECT_EQ(refusal(saved(kScene), ask_for_a_text), "f.h5: error: expected a saved value of another kind (time)");
  EXPECT_EQ(refusal(saved(kScene), ask_twice), "f.h5: error: expected more than 1 values, found no more (time)");
}

TEST(Archive, rows_of_a_table_must_be_as_many_as_the_model_has) {
  std::vector<double> three(3), two(2);
  Archive saving;
  saving.table("loads", three, [&](double& load) { saving.value("load", load); });
  EXPECT_NE(refusal({"f.h5", copy_of(saving.root())},
                    [&](Archive& archive) {
                      archive.table("loads", two, [&](double& load) { archive.value("load", load); });
                    }),
            "");
}

}  // namespace keyblock::archive_test
