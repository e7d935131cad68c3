// `keyblock cut`: cuts a drawing into a block file or a cover file; on request writes a picture and the counts of
// cutting.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <variant>

#include "app/command.hpp"
#include "app/commands/mesh_options.hpp"
#include "app/helpers/picture_file.hpp"
#include "app/input/drawing_options.hpp"
#include "app/messages.hpp"
#include "base/error.hpp"
#include "base/printable.hpp"
#include "cut/bodies/cut_blocks.hpp"
#include "cut/covers/absorb.hpp"
#include "cut/covers/cut_cover.hpp"
#include "cut/covers/to_cover.hpp"
#include "formats/case.hpp"
#include "formats/shi/dda_blocks.hpp"
#include "formats/shi/nmm_cover.hpp"
#include "job/files.hpp"
#include "job/run_report.hpp"
#include "report/blocks_picture.hpp"
#include "report/field_picture.hpp"

namespace keyblock {
namespace {

using Json = nlohmann::ordered_json;

struct CutOptions {
  std::string drawing;
  std::string output;
  std::string picture;
  bool numbers = false;  ///< in the picture
  NodeMerging merging = NodeMerging::nearest_first;
  NearPieces near_pieces = NearPieces::led_through;
  MeshOptions mesh;
  bool absorbs = false;
  bool may_overwrite = false;
  bool as_json = false;
  DrawingOptions reading;
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
          {"near_pieces_deleted", r.deleted},
          {"scale", r.tolerances.scale},
          {"merging_distance", r.tolerances.merge},
          {"snaps", std::move(snaps)},
          {"warnings", warning_list_json(cut.warnings)}};
}

/// Returns the drawing of a case that was read and checked.
const Drawing& drawing_of(const formats::Case& loaded, const std::string& path) {
  const Drawing* drawing = std::get_if<Drawing>(&loaded.problem.geometry);
  if (drawing == nullptr) throw InputError({path, 0, 0}, "expected a drawing (lines to cut), found none");
  return *drawing;
}

/// Warns of holes: a block file cannot hold them.
void warn_of_holes(const Blocks& blocks) {
  for (const BlockPolygon& block : blocks.blocks) {
    if (block.holes.empty()) continue;
    log_warnings(
        {{"holes_not_written", blocks.place, "a block file holds no holes: blocks inside others overlap them there"}});
    return;
  }
}

/// Returns the elements after cutting.
FieldFrame field_of(const Manifold& manifold) {
  FieldFrame field;
  for (const ManifoldElement& element : manifold.elements) {
    FieldElement& out = field.elements.emplace_back();
    out.body = element.body;
    out.material = manifold.body_materials[static_cast<std::size_t>(element.body)];
    for (const auto& loop : manifold.polygon(element)) {
      out.loops.emplace_back();
      for (const Point p : loop) out.loops.back().push_back({p, {}, {}});
    }
  }
  return field;
}

/// Cuts the drawing on a mesh: writes the cover file and the picture, and adds the counts to those of cutting.
void cut_on_mesh(const CutOptions& options, const BodyCut& cut, Json& counts) {
  FittedMesh fitted = mesh_asked_for(options.mesh, cut.graph);
  Manifold manifold = cut_cover(cut.graph, std::move(fitted.mesh));
  const int absorbed = options.absorbs ? absorb_small_pieces(manifold) : 0;
  if (!cut.blocks.blocks.bolts.empty())
    log_warnings({{"bolts_not_written", cut.blocks.blocks.place, "a cover file holds no bolts"}});
  if (!options.output.empty())
    write_output(options.output, formats::kNmmCover.write({{}, {}, {}, to_cover(manifold, cut.blocks.blocks)}),
                 overwrite_if(options.may_overwrite));
  if (!options.picture.empty())
    write_picture(
        options.picture,
        report::mesh_picture(
            fmt::format("{} elements on {} physical covers", manifold.elements.size(), manifold.covers.size()),
            field_of(manifold), {}, options.numbers ? report::Numbers::all : report::Numbers::none),
        overwrite_if(options.may_overwrite));
  counts["elements"] = manifold.elements.size();
  counts["covers"] = manifold.covers.size();
  counts["boundary_loops"] = manifold.boundary_loops.size();
  counts["absorbed"] = absorbed;
  counts["mesh_nodes_snapped"] = fitted.snapped;
}

ExitCode cut_file(const CutOptions& options) {
  const bool has_mesh = is_asked_for(options.mesh);
  if (options.absorbs && !has_mesh) throw UsageError("--absorb requires --mesh or --mesh-side");
  require_picture_name("--svg", options.picture);
  require_no_picture_name("-o", options.output, "--svg");
  require_writable({options.output, options.picture}, {options.drawing}, overwrite_if(options.may_overwrite));
  std::vector<std::string> inputs{options.drawing};
  take_layers(inputs, options.reading.layers);
  const formats::Case loaded = formats::load_case(inputs, options.reading.choices);
  log_warnings(loaded.warnings);  // before a drawing that cannot be cut: they may give the reason
  const Drawing& drawing = drawing_of(loaded, options.drawing);
  BodyCut bodies = has_mesh ? cut_bodies(drawing, options.merging, options.near_pieces)
                            : BodyCut{cut_blocks(drawing, options.merging, options.near_pieces), {}};
  CutResult& cut = bodies.blocks;
  log_warnings(cut.warnings);
  cut.warnings = joined(loaded.warnings, cut.warnings);
  Json counts = json_of(cut);
  if (has_mesh) {
    cut_on_mesh(options, bodies, counts);
  } else if (!options.output.empty()) {
    warn_of_holes(cut.blocks);
    write_output(options.output, formats::kDdaBlocks.write({std::nullopt, cut.blocks, std::nullopt}),
                 overwrite_if(options.may_overwrite));
  }
  if (!options.picture.empty() && !has_mesh) {
    const formats::MaterialNames names = formats::names_of(loaded.files);
    write_picture(options.picture,
                  report::blocks_picture(cut.blocks, loaded.problem.units,
                                         options.numbers ? report::Numbers::all : report::Numbers::none, names.rocks,
                                         names.joints),
                  overwrite_if(options.may_overwrite));
  }
  if (options.as_json) {
    fmt::print("{}\n", counts.dump(2, ' ', false, Json::error_handler_t::replace));
  } else {
    fmt::print("{}: {} blocks from {} lines, {} fixed, {} loading and {} measured points\n", printable(options.drawing),
               cut.blocks.blocks.size(), cut.report.lines, cut.blocks.fixed_points.size(),
               cut.blocks.loading_points.size(), cut.blocks.measured_points.size());
    if (has_mesh)
      fmt::print("{} elements on {} physical covers, {} boundary loops, {} small pieces absorbed\n",
                 counts["elements"].get<std::size_t>(), counts["covers"].get<std::size_t>(),
                 counts["boundary_loops"].get<std::size_t>(), counts["absorbed"].get<int>());
  }
  return ExitCode::ok;
}

}  // namespace

Action configure_cut(CLI::App& app) {
  auto options = std::make_shared<CutOptions>();
  app.add_option("GEO", options->drawing,
                 "drawing: DXF, a case file, or a geometry file of Shi's or the Berkeley program")
      ->required();
  add_drawing_options(app, options->reading);
  app.add_option("-o,--output", options->output, "block file to write; with a mesh, cover file")->type_name("FILE");
  CLI::Option* picture =
      app.add_option("--svg", options->picture, "picture of the blocks, or of the mesh and its elements, to write")
          ->type_name("FILE");
  app.add_flag("--numbers", options->numbers, "write block or element numbers into the picture if they fit")
      ->needs(picture);
  app.add_option("--merging", options->merging,
                 "merging of close crossings: nearest_first (independent of the order of lines) or in_order_found (as "
                 "Shi's programs and profile legacy)")
      ->transform(CLI::CheckedTransformer(std::map<std::string, NodeMerging>{
          {"nearest_first", NodeMerging::nearest_first}, {"in_order_found", NodeMerging::in_order_found}}));
  app.add_option("--near-pieces", options->near_pieces,
                 "line pieces that pass a node within the merging distance: led_through it, or deleted (as Shi's "
                 "programs and profile legacy)")
      ->transform(CLI::CheckedTransformer(std::map<std::string, NearPieces>{{"led_through", NearPieces::led_through},
                                                                            {"deleted", NearPieces::deleted}}));
  add_mesh_options(app, options->mesh);
  app.add_flag("--absorb", options->absorbs,
               "give elements alone on a cover and smaller than 0.2 of the mean area the covers of their neighbour, as "
               "Shi's manifold program does");
  app.add_flag("--force", options->may_overwrite, "overwrite files that exist");
  app.add_flag("--json", options->as_json, "print counts, warnings and snaps as JSON");
  return [options] { return cut_file(*options); };
}

}  // namespace keyblock
