// Implements the public Context by that of the program, and names choices in errors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <string>
#include <string_view>

#include "base/bytes/build_id.hpp"
#include "base/bytes/source_facts.hpp"
#include "library/parts.hpp"

namespace keyblock::api {

std::string word_of_choice(const std::string& option) {
  constexpr std::array<std::array<std::string_view, 2>, 4> kWords{
      {{"force", "Recording::overwrite"}, {"history", "histories"}, {"output", "folder"}, {"resume", "folder"}}};
  for (const auto& [known, word] : kWords)
    if (option == known) return std::string(word);
  return option;
}

Error public_error(const keyblock::InputError& error) {
  const Place place = place_of(error.place());
  return Error(place.choice.empty() ? error.what() : place.choice + " " + place.file + ": error: " + error.sentence(),
               ErrorCode::input, place);
}

Error public_error(const ChoiceError& error) {
  const std::string word = word_of_choice(error.choice());
  return Error(error.before() + word + error.after(), ErrorCode::choice, {{}, 0, 0, word}, error.before().size());
}

inline namespace v1 {

Context::Context(int threads) : state_(std::make_shared<State>()) {
  constexpr int kMost = 256;  // as for --threads
  if (threads < 0 || threads > kMost)
    throw Error("expected 0 to 256 threads, found " + std::to_string(threads), ErrorCode::choice);
  state_->context.use_threads(threads);
}

void Context::stop() const noexcept {
  state_->context.stop();
}

bool Context::is_stopped() const noexcept {
  return state_->context.is_stopped();
}

std::pair<std::string, double> Context::headway() const {
  const Headway way = state_->context.headway();
  return {way.what ? way.what : "", way.share};
}

std::string version() {
  return KEYBLOCK_VERSION;
}

std::string build() {
  return guarded([] { return build_id(); });
}

std::string commit() {
  return source_commit();
}

std::string compiler() {
  return compiler_words();
}

}  // namespace v1
}  // namespace keyblock::api
