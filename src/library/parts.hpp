// Defines the data of the opaque types of the public header, and converts errors.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <exception>
#include <functional>
#include <keyblock/keyblock.hpp>
#include <memory>
#include <mutex>
#include <new>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "api/plan.hpp"
#include "base/context.hpp"
#include "base/error.hpp"
#include "base/words/diagnostics.hpp"
#include "formats/case.hpp"
#include "formats/columns/contact_columns.hpp"
#include "formats/columns/frame_columns.hpp"
#include "settings/settings_table.hpp"

namespace keyblock::api {
inline namespace v1 {

struct Context::State {
  keyblock::Context context;
};

struct Case::Data {
  explicit Data(OpenCase of);
  static Case case_of(OpenCase open) { return Case(std::make_shared<const Data>(std::move(open))); }

  OpenCase open;
  std::vector<Warning> warnings;
};

struct Plan::Data {
  Case of;
  PlannedCase planned;
};

/// Contacts of one instant, computed when a frame is first asked for them. Any thread may ask.
class Contacts {
 public:
  explicit Contacts(std::function<ContactFrames()> make) : make_(std::move(make)) {}

  const formats::FramePart& part() {
    const std::lock_guard lock(mutex_);
    if (make_) part_ = formats::contact_part(make_());
    make_ = nullptr;
    return part_;
  }
  /// Replaces the function by one that does not need the present state of the run, unless it was called before.
  template <class Later>
  void keep(const Later& later) {
    const std::lock_guard lock(mutex_);
    if (make_) make_ = later();
  }

 private:
  std::mutex mutex_;
  std::function<ContactFrames()> make_;
  formats::FramePart part_;
};

struct Frame::Data {
  formats::FrameColumns columns;  ///< without contacts
  std::shared_ptr<Contacts> contacts;
  Units units;
  int epoch = 0;

  const formats::FramePart& part(std::string_view name) const {
    return name == "contacts" ? contacts->part() : columns.part(name);
  }
};

}  // namespace v1

/// Returns the word of the library for a choice: a member of `Drawing`, `Choices` or `Recording`, or an argument.
std::string word_of_choice(const std::string& option);

inline Place place_of(const keyblock::Place& place) {
  if (place.file.choice().empty()) return {place.file.text(), place.line, place.column};
  return {place.file.value(), place.line, place.column, word_of_choice(place.file.choice())};
}

/// Returns the error with the words of the library.
Error public_error(const keyblock::InputError& error);
Error public_error(const ChoiceError& error);

inline Facts public_facts(const keyblock::Facts& facts) {
  return {facts.numbers, facts.elements, facts.points, facts.names};
}

inline std::vector<Warning> public_warnings(const Warnings& warnings) {
  std::vector<Warning> all;
  for (const keyblock::Warning& warning : warnings)
    all.push_back({warning.name, warning.sentence, place_of(warning.place),
                   std::string(word_of(level_of(warning.name))), public_facts(warning.facts)});
  return all;
}

/// Returns names and values of all settings.
inline std::vector<std::pair<std::string, std::string>> public_settings(const Prepared& prepared) {
  std::vector<std::pair<std::string, std::string>> all;
  for (const SettingText& setting : list(prepared.scene.settings)) all.emplace_back(setting.name, setting.value);
  return all;
}

/// Returns the files and choices of a case under choices of the caller.
AskedCase asked_under(const Case& of, const Choices& choices);

/// Exception of a function of the caller. No handler but `guarded` catches it, which throws the exception again.
struct ThrownByCaller {
  std::exception_ptr error;
};

template <class... Values>
void call_back(const std::function<void(const Values&...)>& of_caller, const Values&... values) {
  if (!of_caller) return;
  try {
    of_caller(values...);
  } catch (...) {
    throw ThrownByCaller{std::current_exception()};
  }
}

/// Calls `work`; converts its exceptions to those of the public header.
template <class Work>
auto guarded(const Work& work) {
  try {
    return work();
  } catch (const ThrownByCaller& thrown) {
    std::rethrow_exception(thrown.error);
  } catch (const keyblock::InputError& error) {
    throw public_error(error);
  } catch (const ChoiceError& error) {
    throw public_error(error);
  } catch (const UsageError& error) {
    throw Error(error.what(), ErrorCode::choice);
  } catch (const std::invalid_argument& error) {
    throw Error(error.what(), ErrorCode::choice);
  } catch (const StopRequested& error) {
    throw Error(error.what(), ErrorCode::stopped);
  } catch (const OutputError& error) {
    throw Error(error.what(), ErrorCode::output);
  } catch (const Error&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    throw Error(error.what());
  }
}

}  // namespace keyblock::api
