// Declares the table; the samples were made for this project, and a test reads them.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/knowledge.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

namespace keyblock::formats {
namespace {

constexpr std::array<Knowledge, 20> kTable{{
    {"keyblock-case", "documented here: formats/case_file/keyblock_case.hpp, `keyblock formats --schema`",
     R"({
 "keyblock": 1,
 "units": {"length": "m", "mass": "kg", "time": "s"},
 "blocks": {
  "blocks": [
   {"material": 1, "outer": [[0, 0, 1], [4, 0, 1], [4, 1, 1], [0, 1, 1]]},
   {"material": 1, "outer": [[1, 1, 1], [2, 1, 1], [2, 2, 1], [1, 2, 1]]}
  ],
  "fixed_points": [[0.5, 0.5, 1], [3.5, 0.5, 1]],
  "measured_points": [[1.5, 1.5, 2]]
 },
 "analysis": {
  "velocity_carry_over": 1,
  "step_count": 100,
  "time_step": 0.001,
  "allowed_displacement_ratio": 0.01,
  "block_materials": [{"density": 2600, "unit_weight": 25506, "youngs_modulus": 5e9, "poissons_ratio": 0.25}],
  "joint_materials": [{"friction_angle_deg": 30}]
 },
 "run": {"profile": "standard"}
}
)"},
    {"dda-extended", "one mark in public source; layout lost", "#!0xDDA-v1.5\n"},
    {"ddaml", "data and public source",
     R"(<?xml version="1.0"?>
<DDA>
 <Geometry>
  <Edgenodedist distance="0.01"/>
  <Jointlist>
   <Joint type="1"> 0 0 4 0 </Joint> <Joint type="1"> 4 0 4 1 </Joint>
   <Joint type="1"> 4 1 0 1 </Joint> <Joint type="1"> 0 1 0 0 </Joint>
  </Jointlist>
  <Fixedpointlist> <Point> 1 0.5 </Point> </Fixedpointlist>
 </Geometry>
</DDA>
)"},
    {"dxf", "published layout",
     "0\nSECTION\n2\nENTITIES\n0\nLWPOLYLINE\n8\nBOUNDARY\n90\n4\n70\n1\n10\n0\n20\n0\n10\n4\n20\n0\n10\n4\n20\n1\n10\n"
     "0\n"
     "20\n1\n0\nLINE\n8\nJOINT_2\n10\n2\n20\n0\n11\n2\n21\n1\n0\nPOINT\n8\nFIXED\n10\n1\n20\n0.5\n0\nENDSEC\n0\nEOF\n"},
    {"dxf-layers", "documented here: formats/dxf/dxf_layer_table.hpp",
     "layer,part\nOutline,boundary\nBedding,joint 2\nSupport,fixed\nTitle block,ignored\n*,joint 1\n"},
    {"nmm-cover", "data, to the last number of 15 files",
     "2 1 1 2\n8 6 2 8\n0.25 0 1\n0.5 1 2\n0.75 0.5 1\n0.25 0.75 2\n5 7 1\n1 3 0\n0 0\n1 1\n0 1\n0 0\n0 0\n1 0\n1 1\n"
     "0 0\n0 0\n0 0\n1 0\n0 1\n1 1\n1 1\n1 3 5\n2 6 4\n1 3\n5 7\n5 1\n6 1\n7 2\n5 1\n1 2\n2 1\n3 1\n1 2\n"},
    {"berkeley-measured", "public source; no real file seen", "measpoint1=[\n1 .1 .1 5 6 0 0 0 0\n];\n"},
    {"berkeley-replay", "public source; no real file seen",
     "1 1 1 7\n1 0 0\n0 0 0\n1 1 3\n9 9 9\n1 0 0\n1 1 0\n1 0 1\n1 0 0\n0 0 0\n0 0 0\n0 0 0\n"
     "0 0 1 0 1 1 5 6 7\n0 0 0 0\n0 .1 .1 1\n"},
    {"dda-blocks", "public source",
     "1 0 8\n1 0 0\n1 1 4\n1 0 0\n1 4 0\n1 4 1\n1 0 1\n1 0 0\n0 2.06 4\n0 8 2\n0 2 0.5\n0 0.5 0.5 1\n"},
    {"dda-blocks-3", "comments of public source; never chosen for a file, to write it on request",
     "1 0 8\n1 0 0\n1 1 4\n1 0 0\n1 4 0\n1 4 1\n1 0 1\n1 0 0\n0 2.06 4\n0 8 2\n0 2 0.5\n0.5 0.5 1\n"},
    {"dda-geometry", "data and public source; bolt records and variants inferred",
     "0.01\n4 4\n0\n0\n1\n0\n1\n0\n0 0 4 0 1\n4 0 4 1 1\n4 1 0 1 1\n0 1 0 0 1\n1 0.5 1 0.5\n3 0.5\n"},
    {"dda-analysis-berkeley", "data", "1\n50\n1\n1\n0.01\n0.001\n2500 24525 5e9 0.25\n0 0 0\n0 0 0\n0 0 0\n30 0 0\n"},
    {"dda-analysis-shi", "comments of public source; over-relaxation inferred; no real file seen",
     "1 20 1 1 .006 .01 1e7\n0 2 2\n0 0 0 5 1 1\n0 7 7 5 8 8\n5 161 1e6 .25\n0 0 0 0 0 0 0 0 0\n30 0 0\n1.5\n"},
    {"nmm-analysis", "count and order from data (12 files); names partly inferred",
     "1 5 1 1 .01 .1 50\n2 -3\n.1 0 -1 10 .2  0 0 0 0 0 0 0 0 0\n30 0 0\n1.5 0 0 0\n"},
    {"disk-dda", "inferred", "1 0.25 0.5 100\n"},
    {"udec-deck", "manuals and public decks; recognised to be named, not read",
     "round 0.01\nblock 0 0 0 10 10 10 10 0\njset 45 0 20 0 0 0 2 0\nprop mat 1 d 2600 k 5e9 g 3e9\n"},
    {"motion-shake", "public source; no real file seen", "a quake\n3\n.1 .2 .3\n"},
    {"motion-matlab", "public source; no real file seen", ".01 3\n.1\n.2\n.3\n"},
    {"vtk", "documented by VTK; written for viewers, not read", ""},
    {"csv", "documented here: formats/views/views.hpp; not read", ""},
}};

}  // namespace

const Knowledge& knowledge_of(const Format& format) {
  const auto found = std::ranges::find(kTable, format.name, &Knowledge::format);
  if (found == kTable.end()) throw std::invalid_argument("a format without a row in the table of knowledge");
  return *found;
}

}  // namespace keyblock::formats
