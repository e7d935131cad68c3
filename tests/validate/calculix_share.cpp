// Solves a clamped beam by covers of constant functions and by CalculiX (ccx) on the same triangles: displacement and
// time of both.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/os.h>
#include <sys/resource.h>
#include <sys/wait.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "cut/covers/cut_cover.hpp"
#include "cut/mesh/fit_mesh.hpp"
#include "tests/support/continuum_scenes.hpp"

namespace {

using namespace keyblock;

constexpr double kLength = 10;
constexpr double kDepth = 1;
// Largest difference of the tip: the clamped edge, which Nitsche's method fixes here and nodes fix there.
constexpr double kSame = 2e-3;

struct Timing {
  double wall = 0;
  double cpu = 0;
};

struct Answer {
  double tip = 0;
  Timing time;
};

double cpu_of(int who) {
  rusage usage{};
  getrusage(who, &usage);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

template <class Work>
Timing timed(int who, Work work) {
  const auto wall = std::chrono::steady_clock::now();
  const double cpu = cpu_of(who);
  work();
  return {std::chrono::duration<double>(std::chrono::steady_clock::now() - wall).count(), cpu_of(who) - cpu};
}

/// Triangles that follow the beam's edges: covers of constant functions on them are triangles of constant strain.
Continuum beam(double side) {
  BlockPolygon block;
  for (const Point p : rectangle_corners({0, 0}, {kLength, kDepth})) block.outer.push_back({p, 0});
  const BodyGraph graph = graph_of(block);
  MeshPlan plan;
  plan.kind = MeshKind::unstructured;
  plan.side = side;
  plan.placement = MeshPlacement::aligned;
  Continuum continuum;
  continuum.manifold = cut_cover(graph, fitted_mesh(plan, graph).mesh);
  continuum.materials = {elastic_material(1000, 0.3)};
  continuum.plane = Plane::stress;
  continuum.functions = CoverFunctions::constant;
  continuum.prescribed = {{{{0, 0}, {0, kDepth}}, Held::both, [](Point, Point) { return Point{}; }}};
  continuum.tractions = {{{{kLength, 0}, {kLength, kDepth}}, [](Point, Point) { return Point{0, 1}; }}};
  return continuum;
}

Point node_of(const Manifold& manifold, std::size_t cover) {
  return manifold.mesh.nodes[static_cast<std::size_t>(manifold.covers[cover].node)];
}

/// Mean deflection of the loaded edge: by the work of the load.
Answer by_covers(const Continuum& continuum) {
  Answer answer;
  answer.time = timed(RUSAGE_SELF, [&] {
    const ContinuumSolution solution = solve_static(continuum);
    for (const ElementSide& side : sides_along(continuum.manifold, continuum.tractions[0].along)) {
      const double share = length(side.edge.end - side.edge.start) / kDepth;
      const double ends =
          solution.displacement(side.element, side.edge.start).y + solution.displacement(side.element, side.edge.end).y;
      answer.tip += share * ends / 2;
    }
  });
  return answer;
}

/// The parts of the load in the nodes of the loaded edge.
std::vector<double> node_loads(const Continuum& continuum) {
  std::vector<double> loads(continuum.manifold.covers.size(), 0);
  for (const ElementSide& side : sides_along(continuum.manifold, continuum.tractions[0].along)) {
    const ManifoldElement& element = continuum.manifold.elements[static_cast<std::size_t>(side.element)];
    for (const int cover : element.covers) {
      const Point p = node_of(continuum.manifold, static_cast<std::size_t>(cover));
      if (distance(p, side.edge.start) > 1e-9 && distance(p, side.edge.end) > 1e-9) continue;
      loads[static_cast<std::size_t>(cover)] += length(side.edge.end - side.edge.start) / 2;
    }
  }
  return loads;
}

// CalculiX makes solids of plane elements and keeps u and v equal through the thickness. If that is not small beside
// the depth, the change of thickness along the beam is sheared (2.3 % too stiff at a thickness of 1).
constexpr double kThickness = 1e-3;

void write_input(const Continuum& continuum, const std::vector<double>& loads, const std::string& file) {
  auto out = fmt::output_file(file);
  const Manifold& manifold = continuum.manifold;
  out.print("*NODE, NSET=ALL\n");
  for (std::size_t i = 0; i < manifold.covers.size(); ++i)
    out.print("{},{:.16g},{:.16g},0\n", i + 1, node_of(manifold, i).x, node_of(manifold, i).y);
  out.print("*ELEMENT, TYPE=CPS3, ELSET=BEAM\n");
  for (std::size_t e = 0; e < manifold.elements.size(); ++e) {
    const auto& c = manifold.elements[e].covers;
    out.print("{},{},{},{}\n", e + 1, c[0] + 1, c[1] + 1, c[2] + 1);
  }
  out.print("*MATERIAL, NAME=M\n*ELASTIC\n1000,0.3\n*SOLID SECTION, ELSET=BEAM, MATERIAL=M\n{}\n*BOUNDARY\n",
            kThickness);
  for (std::size_t i = 0; i < manifold.covers.size(); ++i)
    if (std::abs(node_of(manifold, i).x) < 1e-9) out.print("{},1,2,0\n", i + 1);
  out.print("*NSET, NSET=TIP\n");
  for (std::size_t i = 0; i < loads.size(); ++i)
    if (loads[i] > 0) out.print("{}\n", i + 1);
  out.print("*STEP\n*STATIC\n*CLOAD\n");
  for (std::size_t i = 0; i < loads.size(); ++i)
    if (loads[i] > 0) out.print("{},2,{:.16g}\n", i + 1, kThickness * loads[i]);
  out.print("*NODE PRINT, NSET=TIP\nU\n*END STEP\n");
}

Answer by_calculix(const Continuum& continuum, const std::filesystem::path& folder) {
  const std::vector<double> loads = node_loads(continuum);
  write_input(continuum, loads, (folder / "beam.inp").string());
  Answer answer;
  const std::string command = fmt::format("cd {} && OMP_NUM_THREADS=1 ccx beam > beam.log 2>&1", folder.string());
  int status = 0;
  answer.time = timed(RUSAGE_CHILDREN, [&] { status = std::system(command.c_str()); });
  std::ifstream table(folder / "beam.dat");
  std::string line;
  while (std::getline(table, line)) {
    std::istringstream words(line);
    std::size_t node = 0;
    double ux = 0, uy = 0;
    if (words >> node >> ux >> uy) answer.tip += loads.at(node - 1) * uy;
  }
  if (status != 0 || answer.tip == 0)
    throw std::runtime_error("ccx gave no displacements; see beam.log in " + folder.string());
  return answer;
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<double> sides{0.015, 0.0085, 0.0047};
  CLI::App app{"The same triangles by covers and by CalculiX"};
  app.add_option("--sides", sides, "longest sides of the meshes");
  CLI11_PARSE(app, argc, argv);
  if (std::system("command -v ccx > /dev/null 2>&1") != 0) {
    fmt::print("skipped: CalculiX (Debian package calculix-ccx) is not installed\n");
    return 0;
  }
  const std::filesystem::path folder = std::filesystem::temp_directory_path() / "keyblock_calculix";
  std::filesystem::create_directories(folder);
  fmt::print("{:>9} {:>9} {:>12} {:>12} {:>11} {:>8} {:>8} {:>8} {:>8} {:>7}\n", "unknowns", "elements", "covers",
             "CalculiX", "difference", "wall s", "cpu s", "ccx wall", "ccx cpu", "ratio");
  int missed = 0;
  for (const double side : sides) {
    const Continuum continuum = beam(side);
    const Answer ours = by_covers(continuum);
    const Answer theirs = by_calculix(continuum, folder);
    const double difference = ours.tip / theirs.tip - 1;
    fmt::print("{:>9} {:>9} {:>12.6f} {:>12.6f} {:>11.1e} {:>8.1f} {:>8.1f} {:>8.1f} {:>8.1f} {:>7.1f}\n",
               2 * continuum.manifold.covers.size(), continuum.manifold.elements.size(), ours.tip, theirs.tip,
               difference, ours.time.wall, ours.time.cpu, theirs.time.wall, theirs.time.cpu,
               theirs.time.cpu / ours.time.cpu);
    std::fflush(stdout);
    if (std::abs(difference) > kSame) ++missed;
  }
  std::filesystem::remove_all(folder);
  if (missed > 0) fmt::print("MISSED: {} meshes differ by more than {} %\n", missed, 100 * kSame);
  return missed == 0 ? 0 : 1;
}
