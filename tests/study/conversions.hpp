// Converts contents and reads the result back, for tests.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "formats/case_file/keyblock_case.hpp"
#include "study/convert/convert.hpp"

namespace keyblock::study {

inline formats::FileReading file_of(const formats::Format& format, const std::string& text,
                                    const formats::Content& content) {
  formats::FileReading file;
  file.path = "f";
  file.source = {"f", text};
  file.choice = formats::Choice{&format, {}};
  file.reading = formats::Reading{content, {}};
  return file;
}

inline formats::FileReading file_of(const formats::Format& format, const formats::Content& content) {
  return file_of(format, format.write(content), content);
}

inline Conversion converted(const formats::Content& content, const Target& target) {
  return convert({file_of(formats::kKeyblockCase, content)}, target, Faults::none);
}

inline formats::Content read_back(const Conversion& conversion) {
  formats::Content back;
  for (const ConvertedFile& file : conversion.files) {
    const formats::Content read = file.format->read({"f", file.text}, conversion.hint).content;
    if (read.drawing) back.drawing = read.drawing;
    if (read.blocks) back.blocks = read.blocks;
    if (read.cover) back.cover = read.cover;
    if (read.covers) back.covers = read.covers;
    if (read.analysis) back.analysis = read.analysis;
    if (read.units) back.units = read.units;
    if (read.choices) back.choices = read.choices;
    if (read.outputs) back.outputs = read.outputs;
    if (!read.stages.empty()) back.stages = read.stages;
    if (read.motion) back.motion = read.motion;
    if (!read.frames.empty()) back.frames = read.frames;
    if (!read.tracks.empty()) back.tracks = read.tracks;
  }
  return back;
}

inline std::vector<std::string> items(const std::vector<Loss>& losses) {
  std::vector<std::string> names;
  for (const Loss& loss : losses) names.push_back(loss.item);
  return names;
}

}  // namespace keyblock::study
