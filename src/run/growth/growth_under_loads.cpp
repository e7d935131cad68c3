// Makes a step, checks the tips and recuts the bodies; see growth_under_loads.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/growth/growth_under_loads.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <stdexcept>
#include <utility>

#include "base/error.hpp"
#include "model/continuum.hpp"
#include "result/describe.hpp"
#include "run/growth/growth_failures.hpp"
#include "run/growth/parents.hpp"
#include "run/growth/solution_of.hpp"
#include "run/stages/chain.hpp"

namespace keyblock {
namespace {

/// Returns the new pieces of cracks. A crack that started is one piece from front to back.
std::vector<std::pair<Point, Point>> gained(const std::vector<CrackPlan>& before, const std::vector<CrackPlan>& after) {
  std::vector<std::pair<Point, Point>> pieces;
  for (std::size_t c = 0; c < after.size(); ++c) {
    const std::vector<Point>& now = after[c].along;
    if (c >= before.size()) {
      pieces.emplace_back(now.front(), now.back());
      continue;
    }
    if (now.front() != before[c].along.front()) pieces.emplace_back(now[1], now[0]);
    if (now.back() != before[c].along.back()) pieces.emplace_back(now[now.size() - 2], now.back());
  }
  return pieces;
}

/// Returns the part in rock of a piece whose middle lies in rock: a crack that starts beside a line may reach beyond
/// it.
std::pair<Point, Point> part_in_rock(Point from, Point to, const std::function<bool(Point)>& is_rock) {
  constexpr int kHalvings = 40;
  const Point middle = 0.5 * (from + to);
  const auto end_in_rock = [&](Point end) {
    if (is_rock(end)) return end;
    Point inner = middle;
    for (int i = 0; i < kHalvings; ++i) {
      const Point half = 0.5 * (inner + end);
      (is_rock(half) ? inner : end) = half;
    }
    return inner;
  };
  return {end_in_rock(from), end_in_rock(to)};
}

/// Returns new faces that part gradually, under the former stress of the rock. NMM elements are numbered from
/// `first_on_covers`.
PartingFaces new_faces(const StandardStepper& now, int first_on_covers, const Place& plan, const Segment& piece,
                       double energy) {
  const Manifold& manifold = now.model().continuum->manifold;
  const CoverDisplacement moved = *now.on_covers();
  const auto element = [&](Point p) { return element_of(manifold, CrackTip{p, {}}); };
  const auto [first, last] = part_in_rock(piece.start, piece.end, [&](Point p) { return element(p) >= 0; });
  const auto place = [&](Point p) {
    const int e = element(p);
    if (e < 0) throw InputError(plan, fmt::format("no rock at ({:.6g}, {:.6g})", p.x, p.y));
    return p + displacement_at(moved, e, p);
  };
  const Point along = place(last) - place(first);
  const double stretch = length(along) / distance(first, last);
  const Point out = (stretch / length(along)) * Point{along.y, -along.x};
  const auto traction = [&](Point p) {
    const int e = element(p);
    if (e < 0) return Point{};
    const Stress s = now.stress_at({first_on_covers + e}, p);
    return Point{s.xx * out.x + s.xy * out.y, s.xy * out.x + s.yy * out.y};
  };
  const double modulus = rock_at(*now.model().continuum, {0.5 * (first + last), along}).effective_modulus();
  return parting_faces(first, last, energy * distance(first, last), modulus, along, traction);
}

/// Returns the pulls on faces; NMM elements are numbered from `first`.
std::vector<FacePull> pulls_of(const std::vector<PartingFaces>& parting, const Pulls& pulls, int first) {
  std::vector<FacePull> all;
  for (std::size_t i = 0; i < parting.size(); ++i)
    for (std::size_t k = 0; k < parting[i].points.size(); ++k) {
      const PartingPoint& point = parting[i].points[k];
      if (point.left < 0) continue;
      all.push_back({{first + point.left}, point.at, pulls[i][k]});
      all.push_back({{first + point.right}, point.at, -1.0 * pulls[i][k]});
    }
  return all;
}

/// Returns the pulls at the start of the next step.
std::vector<FacePull> first_pulls(const std::vector<PartingFaces>& parting, int first) {
  return pulls_of(parting, PullsOfStep(parting).pulls(), first);
}

DisplacementAt displacement_in(const CoverDisplacement& moved) {
  return [moved](int e, Point p) { return displacement_at(moved, e, p); };
}

void describe_point(Archive& archive, const char* x, const char* y, Point& p) {
  archive.value(x, p.x);
  archive.value(y, p.y);
}

void describe_faces(Archive& archive, PartingFaces& faces) {
  describe_point(archive, "from_x", "from_y", faces.from);
  describe_point(archive, "to_x", "to_y", faces.to);
  archive.value("energy", faces.energy);
  archive.value("wide", faces.wide);
  archive.value("taken", faces.taken);
  archive.value("parted", faces.parted);
  archive.value("farthest", faces.farthest);
  archive.list("points", faces.points, [&](PartingPoint& p) {
    describe_point(archive, "x", "y", p.at);
    describe_point(archive, "pull_x", "pull_y", p.pull);
    describe_point(archive, "opening_x", "opening_y", p.opening);
  });
}

/// Returns the energy per length of an extending tip, K_Ic²/E': behind its kink it is of mode I at the toughness.
double energy_of(const Continuum& continuum, const TipState& tip) {
  return energy_release(rock_at(continuum, tip_of(continuum.manifold, tip)), {tip.toughness, 0});
}

[[noreturn]] void refuse(const PartingFaces& faces, const Place& place) {
  throw InputError(place,
                   fmt::format("no rock on both sides of the new faces from ({:.6g}, {:.6g}) to ({:.6g}, {:.6g})",
                               faces.from.x, faces.from.y, faces.to.x, faces.to.y));
}

/// Returns the speed of Rayleigh waves in the rock around a tip.
double speed_at(const Continuum& continuum, const TipState& tip) {
  const CrackTip& place = tip_of(continuum.manifold, tip);
  const int e = element_of(continuum.manifold, place);
  if (e < 0) throw std::logic_error("a tip lies in no element");
  return rayleigh_speed(rock_at(continuum, place), continuum.material(e).density);
}

/// Returns the first scene with other cracks.
Scene scene_with(const Scene& first, const std::vector<CrackPlan>& cracks, const std::vector<RefinedPoint>& refined) {
  Scene scene = first.growth->remade(cracks, refined);
  scene.growth.reset();
  scene.model.scale = first.model.scale;  // tolerances of a run stay those of its beginning
  return scene;
}

// Contact forces of crack faces are not included.
CoverSolution solution_with_pulls(const StandardStepper& now, int first_on_covers) {
  CoverSolution solution = *solution_of(now);
  for (const FacePull& pull : now.scene().pulls)
    solution.face_forces.push_back({pull.element.value - first_on_covers, pull.start, pull.force});
  return solution;
}

void place_on(const Manifold& manifold, std::vector<PartingFaces>& parting, const Place& place) {
  for (PartingFaces& faces : parting) {
    put_elements(faces, manifold);
    if (std::ranges::none_of(faces.points, [](const PartingPoint& point) { return point.left >= 0; }))
      refuse(faces, place);
  }
}

}  // namespace

GrowthUnderLoads::GrowthUnderLoads(Scene first) : first_(std::move(first)) {
  front_.cracks = first_.growth->cracks;
  next_number_ = static_cast<int>(first_.model.elements.size());
  now_ = std::make_unique<StandardStepper>(first_);
}

GrowthUnderLoads::GrowthUnderLoads(Scene first, Archive& saved) : first_(std::move(first)) {
  describe(saved);
  Scene scene =
      front_.cracks.empty() && first_.growth->cracks.empty() ? first_ : scene_with(first_, front_.cracks, refined_);
  saved.group("scene", [&] {
    restore_names(saved, scene.model);
    now_ = std::make_unique<StandardStepper>(std::move(scene), saved);
  });
  place_on(model().continuum->manifold, parting_, first_.growth->plan.place);
  now_->put_pulls(first_pulls(parting_, first_on_covers()));
}

void GrowthUnderLoads::save(Archive& archive) {
  describe(archive);
  archive.group("scene", [&] {
    save_names(archive, model());
    now_->save(archive);
  });
}

void GrowthUnderLoads::describe(Archive& archive) {
  keyblock::describe(archive, "cracks", next_);
  keyblock::describe(archive, front_);
  archive.group("notes", [&] { keyblock::describe(archive, notes_); });
  archive.list("pieces", pieces_, [&](Piece& piece) {
    describe_point(archive, "x", "y", piece.from);
    archive.value("energy", piece.energy);
  });
  archive.list("refined", refined_, [&](RefinedPoint& refined) {
    describe_point(archive, "x", "y", refined.at);
    archive.value("side", refined.side);
  });
  archive.list("arrivals", arrivals_, [&](Arrival& arrival) {
    describe_point(archive, "x", "y", arrival.at);
    archive.value("time", arrival.time);
  });
  archive.list("parting", parting_, [&](PartingFaces& faces) { describe_faces(archive, faces); });
  archive.value("next_number", next_number_);
}

bool GrowthUnderLoads::is_in_time() const {
  return settings().standard.motion == MotionRule::dynamic;
}

LedgerScope GrowthUnderLoads::ledger_scope() const {
  LedgerScope scope = now_->ledger_scope();
  scope.has_changes = true;
  scope.may_crack = is_in_time();
  return scope;
}

int GrowthUnderLoads::first_on_covers() const {
  return static_cast<int>(model().elements.size() - model().continuum->manifold.elements.size());
}

void GrowthUnderLoads::begin_to_part(const std::vector<CrackPlan>& after) {
  for (const auto& [from, to] : gained(front_.cracks, after)) {
    const auto piece = std::ranges::find(pieces_, from, &Piece::from);
    if (piece == pieces_.end()) throw std::logic_error("a crack gained a piece whose energy of fracture is not known");
    if (piece->energy > 0)
      parting_.push_back(new_faces(*now_, first_on_covers(), first_.growth->plan.place, {from, to}, piece->energy));
  }
}

std::unique_ptr<StandardStepper> GrowthUnderLoads::recut() {
  auto change = std::make_shared<SceneChange>();
  std::unique_ptr<StandardStepper> of_before;
  CrackFront before = front_;
  const std::vector<CrackPlan> wanted = next_;
  const std::vector<PartingFaces> parting_before = parting_;
  const std::vector<RefinedPoint> refined_before = refined_;
  try {
    if (is_in_time()) begin_to_part(next_);
    front_ = {wanted, {}, {}};
    next_.clear();
    refined_.clear();
    for (const PartingFaces& faces : parting_)
      for (const Point end : {faces.from, faces.to}) refined_.push_back({end, first_.growth->tip_side});
    Scene scene = scene_with(first_, front_.cracks, refined_);
    const Table<ElementIndex, ElementIndex> parents = parents_by_place(model(), scene.model);
    *change = change_between(model(), std::move(scene), parents, next_number_);
    const Manifold& manifold = change->scene.model.continuum->manifold;
    const int first = static_cast<int>(change->scene.model.elements.size() - manifold.elements.size());
    place_on(manifold, parting_, first_.growth->plan.place);
    now_.swap(of_before = std::make_unique<StandardStepper>(*now_, *change, first_pulls(parting_, first)));
  } catch (...) {
    next_ = wanted;
    front_ = std::move(before);
    parting_ = parting_before;
    refined_ = refined_before;
    throw;
  }
  for (PartingFaces& faces : parting_) look_at_openings(faces, displacement_in(*now_->on_covers()));
  pieces_.clear();
  return of_before;
}

std::optional<std::variant<StepReport, StepFailure>> GrowthUnderLoads::correct() {
  const CrackFront front = front_;
  const std::vector<Piece> pieces = pieces_;
  const std::vector<RefinedPoint> refined = refined_;
  const int next_number = next_number_;
  const std::vector<CrackPlan> wanted = next_;
  std::unique_ptr<StandardStepper> before = recut();
  const auto go_back = [&] {
    now_ = std::move(before);
    front_ = front;
    pieces_ = pieces;
    refined_ = refined;
    next_number_ = next_number;
    next_ = wanted;
  };
  std::vector<double> more;
  try {
    std::variant<StepReport, StepFailure> trial = now_->advance();
    if (std::holds_alternative<StepFailure>(trial)) return trial;
    more = kink_corrections(
        front, tips_of(solution_with_pulls(*now_, first_on_covers()), front_.cracks, first_.growth->plan.criterion));
    if (std::ranges::all_of(more, [](double turn) { return turn == 0; })) return trial;
  } catch (...) {  // a stop in the trial leaves the step unmade
    go_back();
    throw;
  }
  go_back();
  put_next(more);
  return std::nullopt;
}

// Arrivals at the end of the step belong to `next_`, which may be set a second time.
void GrowthUnderLoads::put_next(const std::vector<double>& more) {
  next_ = prolonged(front_, model().continuum->manifold, first_.growth->plan.increment, more);
  std::erase_if(arrivals_, [&](const Arrival& arrival) { return arrival.time == state().time; });
  for (const auto& [from, to] : gained(front_.cracks, next_)) arrivals_.push_back({to, state().time});
  for (std::size_t c = next_.size() - front_.starts.size(); c < next_.size(); ++c)
    arrivals_.push_back({next_[c].along.front(), state().time});
}

// A tip without a field of its own extends only if it arrived there by growth.
bool GrowthUnderLoads::may_go_on(const TipState& tip, double speed) const {
  const auto arrival = std::ranges::find(arrivals_, tip.at, &Arrival::at);
  const bool has_come = arrival != arrivals_.end();
  if (!(tip.toughness > 0)) return false;
  const double increment = first_.growth->plan.increment;
  if (is_in_time() && has_come && (state().time - arrival->time) * speed < increment) return false;
  if (tip.has_room) return tip.equivalent >= tip.toughness;
  const Manifold& manifold = model().continuum->manifold;
  return has_come && way_through(manifold, tip_of(manifold, tip), increment).has_value();
}

void GrowthUnderLoads::look_at_tips() {
  const GrowthPlan& plan = first_.growth->plan;
  const CoverSolution now = solution_with_pulls(*now_, first_on_covers());
  const Continuum& continuum = *model().continuum;
  front_.tips = tips_of(now, front_.cracks, plan.criterion);
  front_.starts = crack_starts(now);
  std::erase_if(front_.starts, [](const CrackStart& start) { return start.nearness() < 1; });
  for (TipState& tip : front_.tips) {
    tip.goes_on = may_go_on(tip, speed_at(continuum, tip));
    if (tip.goes_on) pieces_.push_back({tip.at, energy_of(continuum, tip)});
  }
  if (pieces_.empty() && front_.starts.empty()) return;
  for (const CrackStart& start : front_.starts) {
    const PlaneElasticity rock = rock_at(continuum, {start.at, start.along});
    pieces_.push_back({start.at - start.half_length * start.along, energy_release(rock, {start.toughness, 0})});
  }
  put_next(std::vector<double>(front_.tips.size(), 0));
}

std::variant<StepReport, StepFailure> GrowthUnderLoads::advance() {
  const CrackFront before = front_;
  std::optional<std::variant<StepReport, StepFailure>> tried;
  if (!next_.empty()) try {
      const bool may_turn = std::ranges::any_of(front_.tips, &TipState::goes_on);
      if (may_turn && !is_in_time() && first_.growth->plan.has_corrector) tried = correct();
      if (!tried) recut();
    } catch (const InputError& error) {
      return cannot_go_on(state().step + 1, error);
    } catch (const std::invalid_argument& error) {
      return cannot_go_on(state().step + 1, error);
    }
  PullsOfStep pulls(parting_);
  const auto better = [&](const CoverDisplacement& end, std::vector<FacePull>& on_faces) {
    if (pulls.are_found(displacement_in(end))) return false;
    on_faces = pulls_of(parting_, pulls.pulls(), first_on_covers());
    return true;
  };
  std::variant<StepReport, StepFailure> made = tried ? std::move(*tried) : now_->advance(better);
  if (std::holds_alternative<StepFailure>(made)) {
    now_->put_pulls(first_pulls(parting_, first_on_covers()));
    return parted(std::get<StepFailure>(made), *now_);
  }
  for (std::size_t i = 0; i < parting_.size(); ++i)
    part(parting_[i], pulls.pulls()[i], displacement_in(*now_->on_covers()));
  look_at_tips();
  if (!is_in_time()) note_bends(notes_, state().step, before, front_);
  note_front(notes_, state().step, front_);
  std::erase_if(parting_, &PartingFaces::have_parted);
  now_->put_pulls(first_pulls(parting_, first_on_covers()));
  return made;
}

}  // namespace keyblock
