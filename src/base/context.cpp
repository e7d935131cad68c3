// A state of atomics for each context, linked to that of the whole. Name and share of a headway may be of two moments:
// they serve a line of progress.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/context.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>

#include "base/loop_threads.hpp"

namespace keyblock {
namespace {

using Clock = std::chrono::steady_clock;

thread_local const Context* of_thread = nullptr;

std::optional<Clock::time_point> end_of(const Limits& limits) {
  if (!limits.seconds) return std::nullopt;
  return Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(*limits.seconds));
}

struct ToldWay {
  std::atomic<const char*> what = nullptr;
  std::atomic<double> share = 0;
};

}  // namespace

double share_of_fall(double first, double now, double goal) {
  if (!(goal > 0) || !(first > goal) || !(now > 0)) return 0;
  return std::clamp(std::log(first / now) / std::log(first / goal), 0.0, 1.0);
}

struct Context::State {
  std::shared_ptr<State> whole;
  std::optional<Clock::time_point> end;
  std::optional<long long> most_systems;
  std::shared_ptr<ToldWay> way;
  std::shared_ptr<LoopThreads> threads;
  std::filesystem::path folder;
  std::atomic<bool> is_stopped = false;
  std::atomic<long long> systems = 0;

  State(const Limits& limits, std::shared_ptr<State> part_of)
      : whole(std::move(part_of)), end(end_of(limits)), most_systems(limits.systems) {
    way = whole ? whole->way : std::make_shared<ToldWay>();
    threads = whole ? whole->threads : loop_threads_of(0);
    if (whole) folder = whole->folder;
  }

  bool is_over() const { return is_stopped.load(std::memory_order_relaxed) || (end && Clock::now() >= *end); }
};

static_assert(std::atomic<bool>::is_always_lock_free, "signal handlers may set it");

Context::Context() : Context(Limits{}) {}
Context::Context(Limits limits) : Context(std::make_shared<State>(limits, nullptr)) {}
Context::Context(std::shared_ptr<State> state) : state_(std::move(state)) {}

Context Context::part(Limits limits) const {
  return Context(std::make_shared<State>(limits, state_));
}

void Context::stop() const noexcept {
  state_->is_stopped = true;
}

bool Context::is_stopped() const noexcept {
  for (const State* state = state_.get(); state; state = state->whole.get())
    if (state->is_over()) return true;
  return false;
}

void Context::begin_system() const {
  for (const State* state = state_.get(); state; state = state->whole.get())
    if (state->is_over() || (state->most_systems && state->systems >= *state->most_systems)) throw StopRequested();
  for (State* state = state_.get(); state; state = state->whole.get()) ++state->systems;
}

long long Context::systems() const noexcept {
  return state_->systems;
}

void Context::tell(const char* what, double share) const noexcept {
  state_->way->share = std::clamp(share, 0.0, 1.0);
  state_->way->what = what;
}

Headway Context::headway() const noexcept {
  return {state_->way->what, state_->way->share};
}

void Context::use_threads(int count) const {
  state_->threads = loop_threads_of(count);
}

LoopThreads& Context::threads() const {
  return *state_->threads;
}

void Context::use_folder(const std::filesystem::path& folder) const {
  state_->folder = folder;
}

const std::filesystem::path& Context::folder() const {
  return state_->folder;
}

const Context& context() {
  static const Context of_all;
  return of_thread ? *of_thread : of_all;
}

std::filesystem::path located(const std::filesystem::path& input) {
  return context().folder() / input;  // which is `input` if that is absolute or the folder empty
}

Under::Under(const Context& context) : before_(of_thread) {
  of_thread = &context;
}

Under::~Under() {
  of_thread = before_;
}

void leave_if_stopped() {
  if (context().is_stopped()) throw StopRequested();
}

}  // namespace keyblock
