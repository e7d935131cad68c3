// Replaces the operators; sizes come from the allocator, so that deleting needs no record.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/meter.hpp"

#include <malloc.h>

#include <atomic>
#include <cstdlib>
#include <ctime>
#include <new>
#include <pugixml.hpp>

namespace keyblock::support {
namespace {

std::atomic<std::size_t> held = 0;
std::atomic<std::size_t> peak = 0;

void* counted(void* block) {
  if (!block) return nullptr;
  const std::size_t now = held += malloc_usable_size(block);
  for (std::size_t before = peak; before < now && !peak.compare_exchange_weak(before, now);) continue;
  return block;
}

void release(void* block) {
  if (block) held -= malloc_usable_size(block);
  std::free(block);
}

void* allocate(std::size_t size) {
  return counted(std::malloc(size > 0 ? size : 1));
}

void* allocate_aligned(std::size_t size, std::align_val_t alignment) {
  const auto step = static_cast<std::size_t>(alignment);
  return counted(std::aligned_alloc(step, (size / step + 1) * step));
}

template <typename Pointer>
Pointer or_throw(Pointer block) {
  if (!block) throw std::bad_alloc();
  return block;
}

}  // namespace

std::size_t bytes_held() {
  return held;
}

std::size_t peak_bytes() {
  return peak;
}

void forget_peak() {
  peak = held.load();
}

void count_xml() {
  pugi::set_memory_management_functions(allocate, release);
}

double processor_seconds() {
  std::timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

}  // namespace keyblock::support

namespace kt = keyblock::support;

void* operator new(std::size_t size) {
  return kt::or_throw(kt::allocate(size));
}
void* operator new[](std::size_t size) {
  return kt::or_throw(kt::allocate(size));
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  return kt::allocate(size);
}
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept {
  return kt::allocate(size);
}
void* operator new(std::size_t size, std::align_val_t alignment) {
  return kt::or_throw(kt::allocate_aligned(size, alignment));
}
void* operator new[](std::size_t size, std::align_val_t alignment) {
  return kt::or_throw(kt::allocate_aligned(size, alignment));
}
void operator delete(void* block) noexcept {
  kt::release(block);
}
void operator delete[](void* block) noexcept {
  kt::release(block);
}
void operator delete(void* block, std::size_t) noexcept {
  kt::release(block);
}
void operator delete[](void* block, std::size_t) noexcept {
  kt::release(block);
}
void operator delete(void* block, const std::nothrow_t&) noexcept {
  kt::release(block);
}
void operator delete[](void* block, const std::nothrow_t&) noexcept {
  kt::release(block);
}
void operator delete(void* block, std::align_val_t) noexcept {
  kt::release(block);
}
void operator delete[](void* block, std::align_val_t) noexcept {
  kt::release(block);
}
void operator delete(void* block, std::size_t, std::align_val_t) noexcept {
  kt::release(block);
}
void operator delete[](void* block, std::size_t, std::align_val_t) noexcept {
  kt::release(block);
}
