// Reads a file by its format and draws it; see pictures.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "serve/pictures.hpp"

#include "formats/registry.hpp"
#include "report/blocks_picture.hpp"
#include "report/thumbnail.hpp"

namespace keyblock::serve {
namespace {

formats::Content content_of(const std::filesystem::path& file) {
  return formats::read(formats::load_text(file.string())).content;
}

/// Thumbnails are elements of a page: a file of its own needs the name of its language.
std::string as_document(const std::string& svg) {
  const std::string opening = "<svg";
  if (!svg.starts_with(opening) || svg.find("xmlns=") != std::string::npos) return svg;
  return opening + " xmlns=\"http://www.w3.org/2000/svg\"" + svg.substr(opening.size());
}

}  // namespace

std::string thumbnail_of(const std::filesystem::path& file) {
  const formats::Content content = content_of(file);
  std::vector<std::vector<Point>> cracks;
  if (content.covers)
    for (const CrackPlan& crack : content.covers->cracks) cracks.push_back(crack.along);
  if (content.blocks) return as_document(report::thumbnail(*content.blocks, cracks));
  if (content.cover) return as_document(report::thumbnail(*content.cover, cracks));
  if (content.drawing) return as_document(report::thumbnail(*content.drawing, cracks));
  return {};
}

std::string blocks_picture_of(const std::filesystem::path& file, bool has_numbers) {
  const formats::Content content = content_of(file);
  if (content.blocks)
    return report::blocks_picture(*content.blocks, content.units.value_or(Units{}),
                                  has_numbers ? report::Numbers::all : report::Numbers::none, content.names.rocks,
                                  content.names.joints);
  return content.cover ? as_document(report::thumbnail(*content.cover)) : std::string();
}

}  // namespace keyblock::serve
