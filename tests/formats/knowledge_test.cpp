// Every format has its row, and every sample is of its format.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/knowledge.hpp"

#include <gtest/gtest.h>

#include "formats/registry.hpp"

namespace keyblock::formats::knowledge_test {

TEST(Knowledge, every_sample_is_recognised_as_its_format_and_read) {
  for (const Format* format : all_formats()) {
    const Knowledge& knowledge = knowledge_of(*format);
    EXPECT_FALSE(knowledge.evidence.empty()) << format->name;
    if (knowledge.sample.empty() || !format->read) continue;
    const bool is_manifold = format->name == "nmm-analysis";
    const ReadHint hint{1, is_manifold ? 1 : 2, is_manifold ? GeometryKind::cover : GeometryKind::blocks};
    const Source source{"sample", std::string(knowledge.sample)};
    const Choice choice = recognise(source, hint.geometry);
    EXPECT_EQ(choice.format->read, format->read) << format->name << ": " << choice.format->name;
    EXPECT_GE(choice.recognition.fit, Recognition::Fit::surplus) << format->name;
    EXPECT_NO_THROW(format->read(source, hint)) << format->name;
  }
}

}  // namespace keyblock::formats::knowledge_test
