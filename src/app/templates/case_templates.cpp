// Defines commented example cases: `keyblock new` writes them, tests run them.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/templates/case_templates.hpp"

namespace keyblock {
namespace {

constexpr const char* kSlopeCase = R"case({
 // A jointed slope of 45 degrees: two sets of joints in an outline.
 // keyblock check slope.json; keyblock run slope.json -o out; then open out/picture.svg.
 // To use your own drawing instead of the rows below: "drawing": "slope.dxf" (layers: keyblock formats dxf).
 // Editors complete and check keys by this schema: keyblock formats --schema > keyblock-case.schema.json
 "$schema": "keyblock-case.schema.json",
 "keyblock": 2,  // layout 2: motion in time, plane strain and gravity of 9.81 m/s2, unless the file says otherwise
 "units": {"length": "m", "mass": "kg", "time": "s"},  // values with units of their own are converted
 "drawing": {
  "edge_node_ratio": 0.001,  // crossings nearer than this share of the size become one
  "boundary_count": 6,  // the first rows are the outline
  "joints": [  // x1, y1, x2, y2, joint material: its name, or its number from 1
   [0, 0, 30, 0, "bedding"],
   [30, 0, 30, 14, "bedding"],
   [30, 14, 18, 14, "bedding"],
   [18, 14, 8, 4, "bedding"],
   [8, 4, 0, 4, "bedding"],
   [0, 4, 0, 0, "bedding"],
   [27.415, 0, 30, 0.549, "bedding"],
   [16.834, 0, 30, 2.799, "bedding"],
   [6.253, -0, 30, 5.048, "bedding"],
   [0, 0.92, 30, 7.297, "bedding"],
   [0, 3.169, 3.908, 4, "bedding"],
   [9.104, 5.104, 30, 9.546, "bedding"],
   [11.961, 7.961, 30, 11.795, "bedding"],
   [14.817, 10.817, 29.792, 14, "bedding"],
   [17.673, 13.673, 19.21, 14, "bedding"],
   [30, 6.52, 28.41, 14, "cross joint"],
   [28.421, -0, 25.445, 14, "cross joint"],
   [25.456, 0, 22.48, 14, "cross joint"],
   [22.491, 0, 19.516, 14, "cross joint"],
   [19.527, 0, 16.805, 12.805, "cross joint"],
   [16.562, 0, 14.36, 10.36, "cross joint"],
   [13.597, 0, 11.915, 7.915, "cross joint"],
   [10.632, 0, 9.47, 5.47, "cross joint"],
   [7.668, -0, 6.817, 4, "cross joint"],
   [4.703, 0, 3.853, 4, "cross joint"],
   [1.738, 0, 0.888, 4, "cross joint"],
  ],
  // Base and sides are fixed.
  "fixed_lines": [[-1, 0.01, 31, 0.01], [29.99, -1, 29.99, 15], [0.01, -1, 0.01, 5]],  // fix where they cross edges
  "measured_points": [[18.5, 13.5]],  // crest; its displacement goes to history.csv
 },
 "analysis": {
  "step_count": 300,
  "time_step": "1 ms",
  // Contact springs: stiffer ones overlap less and cost more.
  "contact_penalty": "5 GPa",
  "block_materials": [
   {"name": "rock", "like": "limestone", "youngs_modulus": "5 GPa"},  // a jointed mass is softer than intact rock
  ],
  "joint_materials": [
   {"name": "bedding", "friction_angle_deg": "35 deg"},
   {"name": "cross joint", "friction_angle_deg": "30 deg", "cohesion": "10 kPa"},
  ],
 },
 // "run": {"set": {"motion": "static"}} computes the equilibrium itself,
 // `keyblock fos slope.json` the factor of safety.
}
)case";

constexpr const char* kArchCase = R"case({
 // A semicircular arch of 11 stones on two abutments. It stands while its thickness is more than 0.107 of its radius
 // (Heyman 1995); this one has 0.18.
 // keyblock run arch.json -o out; then open out/picture.svg.
 // Editors complete and check keys by this schema: keyblock formats --schema > keyblock-case.schema.json
 "$schema": "keyblock-case.schema.json",
 "keyblock": 2,  // layout 2: motion in time, plane strain and gravity of 9.81 m/s2, unless the file says otherwise
 "units": {"length": "m", "mass": "kg", "time": "s"},  // values with units of their own are converted
 "blocks": {
  "blocks": [  // corners counter-clockwise: x, y, joint material of the edge that arrives there
   {"material": 1, "outer": [[4, 0, 1], [4.8, 0, 1], [4.6056, 1.3523, 1], [3.838, 1.1269, 1]]},
   {"material": 1, "outer": [[3.838, 1.1269, 1], [4.6056, 1.3523, 1], [4.038, 2.5951, 1], [3.365, 2.1626, 1]]},
   {"material": 1, "outer": [[3.365, 2.1626, 1], [4.038, 2.5951, 1], [3.1433, 3.6276, 1], [2.6194, 3.023, 1]]},
   {"material": 1, "outer": [[2.6194, 3.023, 1], [3.1433, 3.6276, 1], [1.994, 4.3662, 1], [1.6617, 3.6385, 1]]},
   {"material": 1, "outer": [[1.6617, 3.6385, 1], [1.994, 4.3662, 1], [0.6831, 4.7511, 1], [0.5693, 3.9593, 1]]},
   {"material": 1, "outer": [[0.5693, 3.9593, 1], [0.6831, 4.7511, 1], [-0.6831, 4.7511, 1], [-0.5693, 3.9593, 1]]},
   {"material": 1, "outer": [[-0.5693, 3.9593, 1], [-0.6831, 4.7511, 1], [-1.994, 4.3662, 1], [-1.6617, 3.6385, 1]]},
   {"material": 1, "outer": [[-1.6617, 3.6385, 1], [-1.994, 4.3662, 1], [-3.1433, 3.6276, 1], [-2.6194, 3.023, 1]]},
   {"material": 1, "outer": [[-2.6194, 3.023, 1], [-3.1433, 3.6276, 1], [-4.038, 2.5951, 1], [-3.365, 2.1626, 1]]},
   {"material": 1, "outer": [[-3.365, 2.1626, 1], [-4.038, 2.5951, 1], [-4.6056, 1.3523, 1], [-3.838, 1.1269, 1]]},
   {"material": 1, "outer": [[-3.838, 1.1269, 1], [-4.6056, 1.3523, 1], [-4.8, 0, 1], [-4, 0, 1]]},
   {"material": 1, "outer": [[3.7, -0.6, 1], [5.1, -0.6, 1], [5.1, 0, 1], [3.7, 0, 1]]},
   {"material": 1, "outer": [[-3.7, 0, 1], [-5.1, 0, 1], [-5.1, -0.6, 1], [-3.7, -0.6, 1]]},
  ],
  // x, y, number of the block: the abutments
  "fixed_points": [[3.9, -0.5, 12], [4.9, -0.5, 12], [-3.9, -0.5, 13], [-4.9, -0.5, 13]],
  "measured_points": [[0, 4.4, 6]],  // the keystone
 },
 "analysis": {
  "step_count": 200,
  "time_step": "1 ms",
  "block_materials": [
   {"name": "masonry", "density": "2400 kg/m3", "youngs_modulus": "10 GPa", "poissons_ratio": 0.2},
  ],
  "joint_materials": [{"name": "joint", "friction_angle_deg": "35 deg"}],
 },
}
)case";

constexpr const char* kBeamCase = R"case({
 // A clamped beam under its own weight, modelled with NMM covers, so that it bends; a single block would not.
 // Its tip settles by about w l^4/(8 E' I), E' = E/(1 - nu^2): 22.6 mm, plus a little by shear.
 // keyblock run beam.json -o out; then open out/field.svg.
 // Editors complete and check keys by this schema: keyblock formats --schema > keyblock-case.schema.json
 "$schema": "keyblock-case.schema.json",
 "keyblock": 2,  // layout 2: motion in time, plane strain and gravity of 9.81 m/s2, unless the file says otherwise
 "units": {"length": "m", "mass": "kg", "time": "s"},  // values with units of their own are converted
 "blocks": {
  "blocks": [
   {"material": "rock", "outer": [[0, 0, "joint"], [10, 0, "joint"], [10, 1, "joint"], [0, 1, "joint"]]},
  ],
  "measured_points": [[10, 0.5, 1]],  // the tip
 },
 "covers": {
  "functions": "derived",
  "mesh": {"side": "0.25 m"},
  "displacements": [{"along": [[0, 1], [0, 0]]}],  // the left end is fixed: a chain of points on the boundary
  // "tractions": [{"along": [[10, 0], [10, 1]], "y": -1000}],  // a load on the other end, Pa
 },
 "analysis": {
  "velocity_carry_over": 0,  // statics
  "step_count": 1,
  "time_step": 1,
  "block_materials": [{"name": "rock", "like": "sandstone"}],
  "joint_materials": [{"name": "joint"}],
 },
}
)case";

constexpr const char* kTunnelCase = R"case({
 // A tunnel in jointed rock, excavated and bolted in stages.
 // keyblock run tunnel.json -o out; then open out/picture.svg.
 // Editors complete and check keys by this schema: keyblock formats --schema > keyblock-case.schema.json
 "$schema": "keyblock-case.schema.json",
 "keyblock": 2,  // layout 2: motion in time, plane strain and gravity of 9.81 m/s2, unless the file says otherwise
 "units": {"length": "m", "mass": "kg", "time": "s"},  // values with units of their own are converted
 "drawing": {
  "edge_node_ratio": 0.001,
  "boundary_count": 4,  // the first rows are the outline
  "joints": [  // x1, y1, x2, y2, joint material
   [-10, 0, 10, 0, "joint"],
   [10, 0, 10, 16, "joint"],
   [10, 16, -10, 16, "joint"],
   [-10, 16, -10, 0, "joint"],
   [9.11, 0, 10, 3.32, "joint"],
   [6.419, 0, 10, 13.366, "joint"],
   [3.727, 0, 8.014, 16, "joint"],
   [1.035, 0, 5.322, 16, "joint"],
   [-1.656, 0, 2.631, 16, "joint"],
   [-4.348, 0, -0.061, 16, "joint"],
   [-7.04, -0, -2.753, 16, "joint"],
   [-9.732, -0, -5.444, 16, "joint"],
   [-10, 9.044, -8.136, 16, "joint"],
   [4.031, 0, 10, 1.052, "joint"],
   [-8.638, 0, 10, 3.286, "joint"],
   [-10, 1.994, 10, 5.52, "joint"],
   [-10, 4.228, 10, 7.754, "joint"],
   [-10, 6.462, 10, 9.988, "joint"],
   [-10, 8.696, 10, 12.222, "joint"],
   [-10, 10.93, 10, 14.456, "joint"],
   [-10, 13.164, 6.087, 16, "joint"],
   [-10, 15.397, -6.583, 16, "joint"],
  ],
  "fixed_lines": [[-11, 0.01, 11, 0.01], [-9.99, -1, -9.99, 17], [9.99, -1, 9.99, 17]],  // fix where they cross edges
  "measured_points": [[0, 10.5]],  // above the crown
 },
 "analysis": {
  "step_count": 1,  // stages have steps of their own
  "time_step": "2 ms",
  "block_materials": [{"name": "rock", "like": "sandstone", "youngs_modulus": "2 GPa"}],
  "joint_materials": [{"name": "joint", "friction_angle_deg": "35 deg"}],
 },
 "run": {"set": {"mass_damping": "5"}},  // 1/s: each stage comes to rest
 "stages": [  // each ends where forces are balanced to this share, or after so many steps
  {"name": "in situ", "steps": 400, "equilibrium": 1e-3},
  {
   "name": "heading", "steps": 400, "equilibrium": 1e-3,
   "excavations": [
    {"outline": [[-2, 7], [2, 7], [2, 8.6], [1.4, 9.6], [0, 10], [-1.4, 9.6], [-2, 8.6]], "joint_material": "joint"},
   ],
  },
  // x1, y1, x2, y2, stiffness, strength, pretension (of a slice one metre thick), type
  {
   "name": "bolts", "steps": 200, "equilibrium": 1e-3,
   "bolts": [
    [0, 10.4, 0, 13, 2e7, 0, 5e4, 1],
    [-1.2, 10, -2.2, 12.4, 2e7, 0, 5e4, 1],
    [1.2, 10, 2.2, 12.4, 2e7, 0, 5e4, 1],
   ],
  },
 ],
}
)case";

constexpr const char* kBlockCase = R"case({
 // A block that slides down a plane of 30 degrees. With 20 degrees of friction it slides by
 // g t^2/2 (sin 30 - cos 30 tan 20) = 0.906 m in one second.
 // keyblock run block.json -o out; then open out/picture.svg.
 // Editors complete and check keys by this schema: keyblock formats --schema > keyblock-case.schema.json
 "$schema": "keyblock-case.schema.json",
 "keyblock": 2,  // layout 2: motion in time, plane strain and gravity of 9.81 m/s2, unless the file says otherwise
 "units": {"length": "m", "mass": "kg", "time": "s"},  // values with units of their own are converted
 "blocks": {
  "blocks": [  // corners counter-clockwise: x, y, joint material of the edge that arrives there
   {"material": "rock", "outer": [[0, 0, 1], [10, 0, 1], [0, 5.7735, 1]]},
   {"material": "rock", "outer": [[4.80385, 3, 1], [5.30385, 3.86603, 1], [3.5718, 4.86603, 1], [3.0718, 4, 1]]},
  ],
  "fixed_points": [[1, 1, 1], [8, 0.5, 1]],  // x, y, number of the block that is fixed there
  "measured_points": [[4.18782, 3.93301, 2]],
 },
 "analysis": {
  "step_count": 100,
  "time_step": "10 ms",
  "block_materials": [{"name": "rock", "like": "sandstone"}],  // keyblock formats --materials: the library
  "joint_materials": [{"name": "joint", "friction_angle_deg": "20 deg"}],
 },
}
)case";

constexpr std::array<CaseTemplate, 5> kTemplates{{
    {"slope", "jointed slope of 45 degrees", kSlopeCase},
    {"arch", "semicircular arch of eleven stones", kArchCase},
    {"beam", "clamped beam on NMM covers", kBeamCase},
    {"tunnel", "tunnel in jointed rock, in stages with bolts", kTunnelCase},
    {"block", "block that slides down a plane", kBlockCase},
}};

}  // namespace

std::span<const CaseTemplate> case_templates() {
  return kTemplates;
}

}  // namespace keyblock
