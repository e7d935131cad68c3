// Defines the data of the opaque types of the public header, and converts errors.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <keyblock/keyblock.hpp>
#include <new>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "api/plan.hpp"
#include "base/context.hpp"
#include "base/error.hpp"
#include "formats/case.hpp"
#include "formats/columns/frame_columns.hpp"

namespace keyblock::api {
inline namespace v1 {

struct Context::State {
  keyblock::Context context;
};

struct Case::Data {
  OpenCase open;
  std::vector<Warning> warnings;
};

struct Plan::Data {
  Case of;
  PlannedCase planned;
};

struct Frame::Data {
  formats::FrameColumns columns;
};

}  // namespace v1

inline Place place_of(const keyblock::Place& place) {
  return {place.file.text(), place.line, place.column};
}

inline std::vector<Warning> public_warnings(const Warnings& warnings) {
  std::vector<Warning> all;
  for (const keyblock::Warning& warning : warnings)
    all.push_back({warning.name, warning.sentence, place_of(warning.place)});
  return all;
}

/// Returns the files and choices of a case under choices of the caller.
AskedCase asked_under(const Case& of, const Choices& choices);

/// Calls `work`; converts its exceptions to those of the public header.
template <class Work>
auto guarded(const Work& work) {
  try {
    return work();
  } catch (const keyblock::InputError& error) {
    throw InputError(error.what(), place_of(error.place()));
  } catch (const UsageError& error) {
    throw SettingError(error.what());
  } catch (const std::invalid_argument& error) {
    throw SettingError(error.what());
  } catch (const StopRequested& error) {
    throw Stopped(error.what());
  } catch (const Error&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    throw Error(error.what());
  }
}

}  // namespace keyblock::api
