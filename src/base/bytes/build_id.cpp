// Finds the note of the linker among the segments that this code was loaded with.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/bytes/build_id.hpp"

#include <elf.h>
#include <fmt/format.h>
#include <link.h>

#include <algorithm>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string_view>

namespace keyblock {
namespace {

constexpr std::size_t kNoteAlignment = 4;

std::size_t aligned(std::size_t size) {
  return (size + kNoteAlignment - 1) / kNoteAlignment * kNoteAlignment;
}

// A note is a header, a name and what it describes, each filled up to four bytes.
std::string id_in(std::span<const char> notes) {
  while (notes.size() >= sizeof(ElfW(Nhdr))) {
    const auto* note = reinterpret_cast<const ElfW(Nhdr)*>(notes.data());
    const std::size_t name = sizeof *note, content = name + aligned(note->n_namesz);
    const std::size_t end = content + aligned(note->n_descsz);
    if (end > notes.size()) return {};
    if (note->n_type == NT_GNU_BUILD_ID &&
        std::string_view(notes.data() + name, note->n_namesz) == std::string_view(ELF_NOTE_GNU, sizeof ELF_NOTE_GNU)) {
      std::string id;
      for (const char byte : notes.subspan(content, note->n_descsz))
        id += fmt::format("{:02x}", static_cast<unsigned char>(byte));
      return id;
    }
    notes = notes.subspan(end);
  }
  return {};
}

// Puts the id of a loaded object into `id` if the object holds this code.
int look_at(dl_phdr_info* object, std::size_t, void* id) {
  const std::span segments(object->dlpi_phdr, object->dlpi_phnum);
  const auto here = reinterpret_cast<std::uintptr_t>(&build_id);
  const auto begin = [&](const ElfW(Phdr) & segment) { return object->dlpi_addr + segment.p_vaddr; };
  const auto holds_this = [&](const ElfW(Phdr) & segment) {
    return segment.p_type == PT_LOAD && here >= begin(segment) && here < begin(segment) + segment.p_memsz;
  };
  if (std::ranges::none_of(segments, holds_this)) return 0;
  auto& found = *static_cast<std::string*>(id);
  for (const ElfW(Phdr) & segment : segments)
    if (segment.p_type == PT_NOTE && found.empty())
      found = id_in({reinterpret_cast<const char*>(begin(segment)), segment.p_memsz});
  return 1;
}

}  // namespace

std::string build_id() {
  std::string id;
  dl_iterate_phdr(look_at, &id);
  if (id.empty()) throw std::logic_error("the linker left no build id (--build-id)");
  return id;
}

}  // namespace keyblock
