// Chooses the next factor to try and draws conclusions from the trials so far.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/strength/factor_of_safety.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "base/context.hpp"
#include "base/decimals.hpp"

namespace keyblock::study {
namespace {

constexpr double kDown = 0.8;
constexpr double kFarthest = 16;  // times the first factor, or divided by it
// Fraction of half the scene's extent below which displacements count as zero, as for rigid blocks.
constexpr double kNoDisplacement = 1e-5;
// Fraction of half the scene's extent: an equilibrium farther from the drawing needs a reference. At kStrong of the
// factor, which is a hundred times the strength, nothing slides, and only softness and open gaps are left.
constexpr double kSlid = 0.01;
constexpr double kStrong = 0.01;
// Least limit of a trial. One of a slope of 20 blocks near its factor took 34,000 linear systems before it was decided.
constexpr long long kFewestSystems = 100'000;
constexpr long long kTimesLongest = 10;

using Trials = std::map<double, TrialOutcome>;  // by factor

std::string growth_in_words(const StrengthTrial& told) {
  return fmt::format("{:.3g} times those at {:.4g}", told.growth, told.growth_from);
}

class FactorSearch {
 public:
  FactorSearch(const StrengthTrials& trials, const SearchOptions& options) : trials_(trials), options_(options) {
    first_ = options.from.value_or(options.guess);
    most_ = options.to.value_or(std::max(1.0, first_) * kFarthest);
  }

  /// Returns the blocks to leave out before the factor of the others can be found; the search ended there.
  const std::vector<int>& loose() const { return loose_; }

  FactorOfSafety run() {
    try {
      result_.end = search();
    } catch (const StopRequested&) {
      result_.end = SearchEnd::stopped;
    }
    put_trials();
    put_states();
    return std::move(result_);
  }

 private:
  SearchEnd search() {
    Verdict verdict = made_at(first_);
    if (verdict == Verdict::stands) verdict = beside_reference(first_);
    double factor = first_;
    if (verdict == Verdict::falls && options_.from && !bracket_of(verdict_).stands) return SearchEnd::falls;
    while (verdict == Verdict::stands && factor < most_)
      verdict =
          made_at(factor = std::min(most_, options_.to && options_.from ? most_ : short_decimal(factor * options_.up)));
    if (verdict == Verdict::stands) {
      close_service();
      return SearchEnd::stands;
    }
    while (verdict == Verdict::falls && !bracket_of(verdict_).stands && factor > first_ / kFarthest)
      verdict = made_at(factor = short_decimal(factor * kDown));
    if (verdict == Verdict::stands) verdict = beside_reference(factor);
    if (verdict == Verdict::falls && !bracket_of(verdict_).stands) return SearchEnd::falls;
    if (verdict == Verdict::undecided || !bisect(verdict_)) return SearchEnd::undecided;
    close_service();
    return SearchEnd::bracketed;
  }

  void close_service() {
    const Bracket service = bracket_of(service_);
    if (options_.seeks_knee && service.is_closed() && *service.falls < *bracket_of(verdict_).stands) bisect(service_);
  }

  /// Makes a trial of strong joints and rock if the equilibrium at `factor` may have been reached after a slide only.
  /// Returns the verdict of that factor afterwards; undecided without such a reference.
  Verdict beside_reference(double factor) {
    const StrengthTrial& told = made_.at(factor).told;
    const bool may_have_slid =
        told.displacement > kSlid * trials_.prepared().scene.model.scale || told.farthest.share() > kFarFromDrawing;
    if (may_have_slid && made_at(short_decimal(kStrong * factor)) != Verdict::stands) return Verdict::undecided;
    return made_.at(factor).told.verdict;
  }

  using Sign = std::function<Verdict(const StrengthTrial&)>;

  // Returns false if a trial is undecided.
  bool bisect(const Sign& sign) {
    for (Bracket at = bracket_of(sign); at.width() > options_.within * (1 + 1e-9); at = bracket_of(sign)) {
      const double middle = at.middle();
      if (middle <= *at.stands || middle >= *at.falls) return true;  // no floating-point number lies between them
      if (made_at(middle) == Verdict::undecided) return false;
    }
    return true;
  }

  Bracket bracket_of(const Sign& sign) const {
    Bracket bracket;
    for (const auto& [factor, made] : made_)
      if (sign(made.told) == Verdict::falls) {
        bracket.falls = factor;
        break;
      }
    for (const auto& [factor, made] : made_)
      if (sign(made.told) == Verdict::stands && (!bracket.falls || factor < *bracket.falls)) bracket.stands = factor;
    return bracket;
  }

  Verdict made_at(double factor) {
    options_.on_begin(factor);
    TrialOutcome outcome = tried_at(factor);
    if (outcome.told.verdict == Verdict::falls && trials_.may_leave_out(outcome.restless)) {
      loose_ = outcome.restless;
      outcome.told.verdict = Verdict::undecided;
    }
    order_.push_back(factor);
    made_[factor] = std::move(outcome);
    judge();
    forget();
    options_.on_trial(made_.at(factor).told);
    return made_.at(factor).told.verdict;
  }

  TrialOutcome tried_at(double factor) {
    long long longest = 0;
    for (const auto& [_, made] : made_)
      if (made.told.verdict != Verdict::undecided) longest = std::max(longest, made.told.systems);
    return trials_.run(factor, trial_limit(options_.trial_limit, longest));
  }

  void judge() {
    const double none = kNoDisplacement * trials_.prepared().scene.model.scale;
    const auto first = std::ranges::find_if(made_, [](const auto& entry) { return entry.second.told.is_balanced; });
    if (first == made_.end()) return;
    const StrengthTrial& least = first->second.told;
    const double still = std::max(none, least.displacement);
    for (auto& [factor, made] : made_) {
      StrengthTrial& told = made.told;
      if (!told.is_balanced) continue;
      told.is_far = told.farthest.share() - least.farthest.share() > kFarFromDrawing;
      told.is_past_knee = told.displacement > kKnee * still;
      told.verdict = told.is_far ? Verdict::falls : Verdict::stands;
      told.why.clear();
      if (told.is_past_knee) {
        told.growth = told.displacement / still;
        told.growth_from = least.factor;
        told.why = "displacements " + growth_in_words(told);
      }
      if (told.is_far)
        told.why =
            fmt::format("in equilibrium, but far from the drawing: {} {} has moved by {:.3g}, {:.2g} of its width",
                        told.farthest.is_body ? "the body of element" : "block", told.farthest.number + 1,
                        told.farthest.way, told.farthest.share());
    }
  }

  // States are large, so that those of trials no longer needed are dropped.
  void forget() {
    const Bracket at = bracket_of(verdict_);
    for (auto& [factor, made] : made_) {
      const bool is_near = !at.stands || !at.falls || (factor >= *at.stands && factor <= *at.falls);
      if (is_near || (previous_ && factor == *previous_)) continue;
      made.state = {};
      made.attempt.reset();
      made.attempt_frame.reset();
    }
    if (at.stands && (!last_ || *last_ != *at.stands)) {
      previous_ = last_;
      last_ = at.stands;
    }
  }

  void put_trials() {
    for (const double factor : order_) result_.trials.push_back(made_.at(factor).told);
    result_.bracket = bracket_of(verdict_);
    result_.service = bracket_of(service_);
    result_.has_bolts = !trials_.prepared().scene.model.bolts.empty();
    result_.what = trials_.what();
    result_.within = options_.within;
    result_.is_lower_estimate = flows_below_friction(trials_.problem(), trials_.what(), trials_.exempt());
    result_.notes = trials_.notes();
    result_.left_out = trials_.left_out();
  }

  void put_states() {
    const Bracket& at = result_.bracket;
    if (at.stands) result_.standing = std::move(made_.at(*at.stands).state);
    if (previous_ && previous_ != at.stands) result_.standing_before = std::move(made_.at(*previous_).state);
    if (!at.falls) return;
    TrialOutcome& fallen = made_.at(*at.falls);
    if (fallen.told.is_far) {
      result_.falling = std::move(fallen.state.field);
      result_.falling_frame = std::move(fallen.state.frame);
      return;
    }
    result_.falling = std::move(fallen.attempt);
    result_.falling_frame = std::move(fallen.attempt_frame);
    result_.before_fall = std::move(fallen.state.field);
  }

  const StrengthTrials& trials_;
  const SearchOptions& options_;
  double first_ = 1;
  double most_ = 1;
  Trials made_;
  std::vector<double> order_;
  std::optional<double> last_;      ///< largest factor that stands
  std::optional<double> previous_;  ///< largest one before `last_` was found
  std::vector<int> loose_;
  FactorOfSafety result_;
  Sign verdict_ = [](const StrengthTrial& told) { return told.verdict; };
  Sign service_ = [](const StrengthTrial& told) { return told.is_past_knee ? Verdict::falls : told.verdict; };
};

/// Names the reason, and the known results on either side of the undecided trial.
std::string why_undecided(const FactorOfSafety& result) {
  const StrengthTrial& last = result.trials.back();
  const Bracket& at = result.bracket;
  std::string known = "; nothing is known ";
  if (at.is_closed())
    known += fmt::format("between {:.6g} and {:.6g}", *at.stands, *at.falls);
  else if (at.stands)
    known += fmt::format("above {:.6g}", *at.stands);
  else if (at.falls)
    known += fmt::format("below {:.6g}", *at.falls);
  else
    known = "; nothing is known";
  return fmt::format(
      "statics does not decide at {:.6g}: it finds neither an equilibrium nor a block that accelerates ({}){}",
      last.factor, last.why, known);
}

/// Returns a note if even the trial of the greatest strength ends far from the drawing: the verdicts of others are
/// relative to it.
std::string far_reference(const FactorOfSafety& result) {
  const StrengthTrial* least = nullptr;
  for (const StrengthTrial& trial : result.trials)
    if (trial.is_balanced && (least == nullptr || trial.factor < least->factor)) least = &trial;
  if (least == nullptr || least->farthest.share() <= kFarFromDrawing) return {};
  return fmt::format(
      "even at F = {:.4g} {} {} moves by {:.3g}, {:.2g} of its width: a gap in the drawing, soft rock, or a joint "
      "without strength. The factor is that of the state after this motion",
      least->factor, least->farthest.is_body ? "the body of element" : "block", least->farthest.number + 1,
      least->farthest.way, least->farthest.share());
}

void add_notes(FactorOfSafety& result) {
  std::vector<std::string>& notes = result.notes;
  if (result.is_lower_estimate)
    notes.emplace_back(
        "the dilation angle is below the friction angle, so that no theorem bounds the factor. The search may lose "
        "equilibrium before the rock does: apart from the mesh error, the factor is a lower estimate");
  if (result.grows_before_it_falls()) {
    const StrengthTrial& after = result.trial_at(*result.service.falls);
    notes.push_back(
        fmt::format("serviceability: displacements grow from F = {:.4g} on, where they are {} ({:.3g}); equilibrium "
                    "exists up to {:.4g}{}",
                    *result.service.falls, growth_in_words(after), after.displacement, *result.bracket.stands,
                    result.has_bolts ? "; joints slip there until stretched bolts carry the remaining load" : ""));
  }
  if (result.has_bolts)
    notes.emplace_back(
        "bolts break at their strength and then carry nothing, and joints that slip lose their cohesion. Limit "
        "analysis, in which all keep their full strength, gives a factor at least as high");
  if (result.end == SearchEnd::undecided) notes.push_back(why_undecided(result));
  if (const std::string note = far_reference(result); !note.empty()) notes.push_back(note);
}

}  // namespace

std::optional<long long> trial_limit(std::optional<long long> asked, long long longest_before) {
  if (asked) return *asked > 0 ? asked : std::nullopt;
  return std::max(kFewestSystems, kTimesLongest * longest_before);
}

const StrengthTrial& FactorOfSafety::trial_at(double factor) const {
  const auto found = std::ranges::find(trials, factor, &StrengthTrial::factor);
  if (found == trials.end()) throw std::out_of_range(fmt::format("no trial at {}", factor));
  return *found;
}

bool FactorOfSafety::grows_before_it_falls() const {
  return bracket.stands && service.is_closed() && *service.falls < *bracket.stands;
}

std::string name_of(SearchEnd end) {
  constexpr std::array<const char*, 5> kNames{"bracketed", "falls", "stands", "undecided", "stopped"};
  return kNames.at(static_cast<std::size_t>(end));
}

FactorOfSafety factor_of_safety(const StrengthTrials& given, const SearchOptions& options) {
  StrengthTrials trials = given;
  while (true) {
    FactorSearch search(trials, options);
    FactorOfSafety result = search.run();
    if (search.loose().empty() || result.end == SearchEnd::stopped) {
      add_notes(result);
      return result;
    }
    trials.leave_out(search.loose());
    if (options.on_loose) options.on_loose(trials.notes().back());
  }
}

}  // namespace keyblock::study
