// `keyblock cut`: a drawing in, a block file out, and on request a picture and the counts of cutting.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <variant>

#include "app/command.hpp"
#include "app/files.hpp"
#include "app/run_report.hpp"
#include "cut/cut_blocks.hpp"
#include "formats/case.hpp"
#include "formats/dda_blocks.hpp"
#include "report/blocks_picture.hpp"

namespace keyblock {
namespace {

using Json = nlohmann::ordered_json;

struct CutOptions {
  std::string drawing;
  std::string output;
  std::string picture;
  NodeMerging merging = NodeMerging::nearest_first;
  bool may_overwrite = false;
  bool as_json = false;
};

Json json_of(const CutResult& cut) {
  Json snaps = Json::array();
  for (const Snap& snap : cut.snaps) {
    snaps.push_back({{"kind", to_string(snap.kind)},
                     {"line", snap.place.line},
                     {"from", {snap.from.x, snap.from.y}},
                     {"to", {snap.to.x, snap.to.y}},
                     {"distance", distance(snap.from, snap.to)}});
  }
  const CutReport& r = cut.report;
  return {{"blocks", cut.blocks.blocks.size()},
          {"fixed_points", cut.blocks.fixed_points.size()},
          {"loading_points", cut.blocks.loading_points.size()},
          {"measured_points", cut.blocks.measured_points.size()},
          {"bolts", cut.blocks.bolts.size()},
          {"lines", r.lines},
          {"crossings", r.crossings},
          {"nodes", r.nodes},
          {"edges", r.edges},
          {"dangling_edges", r.dangling_edges},
          {"bridge_edges", r.bridge_edges},
          {"scale", r.tolerances.scale},
          {"merging_distance", r.tolerances.merge},
          {"snaps", std::move(snaps)},
          {"warnings", warning_list_json(cut.warnings)}};
}

/// The drawing of a case that is read and checked.
const Drawing& drawing_of(const formats::Case& loaded, const std::string& path) {
  const Drawing* drawing = std::get_if<Drawing>(&loaded.problem.geometry);
  if (drawing == nullptr) throw InputError({path, 0, 0}, "expected a drawing (lines to cut), found none");
  return *drawing;
}

/// A block file cannot hold holes.
void warn_of_holes(const Blocks& blocks) {
  for (const BlockPolygon& block : blocks.blocks) {
    if (block.holes.empty()) continue;
    spdlog::warn("{}", to_string(Warning{"holes_not_written", blocks.place,
                                         "a block file holds no holes: blocks inside others overlap them there"}));
    return;
  }
}

ExitCode cut_file(const CutOptions& options) {
  // Before any work is done, so that a long cut is not lost to a file that is there already.
  const Overwrite overwrite = options.may_overwrite ? Overwrite::yes : Overwrite::no;
  for (const std::string& file : {options.output, options.picture})
    if (!file.empty()) {
      require_not_input(file, options.drawing);
      require_free(file, overwrite);
      require_folder_of(file);
    }
  const formats::Case loaded = formats::load_case({options.drawing});
  CutResult cut = cut_blocks(drawing_of(loaded, options.drawing), options.merging);
  cut.warnings = joined(loaded.warnings, cut.warnings);
  log_warnings(cut.warnings);
  if (!options.output.empty()) {
    warn_of_holes(cut.blocks);
    write_file(options.output, formats::kDdaBlocks.write({std::nullopt, cut.blocks, std::nullopt}));
  }
  if (!options.picture.empty()) write_file(options.picture, report::blocks_picture(cut.blocks));
  if (options.as_json) {
    fmt::print("{}\n", json_of(cut).dump(2, ' ', false, Json::error_handler_t::replace));
  } else {
    fmt::print("{}: {} blocks from {} lines, {} fixed, {} loading and {} measured points\n", options.drawing,
               cut.blocks.blocks.size(), cut.report.lines, cut.blocks.fixed_points.size(),
               cut.blocks.loading_points.size(), cut.blocks.measured_points.size());
  }
  return ExitCode::ok;
}

}  // namespace

Action configure_cut(CLI::App& app) {
  auto options = std::make_shared<CutOptions>();
  app.add_option("GEO", options->drawing, "the drawing: a geometry file of the old programs")->required();
  app.add_option("-o,--output", options->output, "the block file to write");
  app.add_option("--svg", options->picture, "a picture of the blocks to write");
  app.add_option(
         "--merging", options->merging,
         "how near crossings become one node: nearest_first, independent of the order of lines, or in_order_found, "
         "as the old programs and profile legacy do")
      ->transform(CLI::CheckedTransformer(std::map<std::string, NodeMerging>{
          {"nearest_first", NodeMerging::nearest_first}, {"in_order_found", NodeMerging::in_order_found}}));
  app.add_flag("--force", options->may_overwrite, "overwrite files that exist");
  app.add_flag("--json", options->as_json, "print counts, warnings and snaps as JSON");
  return [options] { return cut_file(*options); };
}

}  // namespace keyblock
