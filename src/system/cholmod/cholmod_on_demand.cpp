// Loads CHOLMOD when it is first called: the functions here have the names and types of cholmod.h, find those of the
// library and call them. Loaded at the start of the program, CHOLMOD and its BLAS took a third of the time of `keyblock
// version`; most scenes of blocks never call them. The names stay hidden, because CHOLMOD's own calls must not come
// back here.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <cholmod.h>
#include <dlfcn.h>
#include <fmt/format.h>

#include <stdexcept>

namespace {

void* cholmod_library() {
  static void* const handle = dlopen(KEYBLOCK_CHOLMOD_NAME, RTLD_NOW | RTLD_LOCAL);
  if (!handle)
    throw std::runtime_error(fmt::format("expected the library {}, which solves for NMM bodies: {}",
                                         KEYBLOCK_CHOLMOD_NAME, dlerror()));
  return handle;
}

template <class Function>
Function* cholmod_function(const char* name) {
  void* const found = dlsym(cholmod_library(), name);
  if (!found) throw std::runtime_error(fmt::format("{} has no function {}", KEYBLOCK_CHOLMOD_NAME, name));
  return reinterpret_cast<Function*>(found);
}

}  // namespace

#pragma GCC visibility push(hidden)
extern "C" {

int cholmod_start(cholmod_common* common) {
  static const auto call = cholmod_function<decltype(cholmod_start)>("cholmod_start");
  return call(common);
}

int cholmod_finish(cholmod_common* common) {
  static const auto call = cholmod_function<decltype(cholmod_finish)>("cholmod_finish");
  return call(common);
}

cholmod_factor* cholmod_analyze(cholmod_sparse* matrix, cholmod_common* common) {
  static const auto call = cholmod_function<decltype(cholmod_analyze)>("cholmod_analyze");
  return call(matrix, common);
}

int cholmod_factorize_p(cholmod_sparse* matrix, double shift[2], int* columns, std::size_t count,
                        cholmod_factor* factor, cholmod_common* common) {
  static const auto call = cholmod_function<decltype(cholmod_factorize_p)>("cholmod_factorize_p");
  return call(matrix, shift, columns, count, factor, common);
}

cholmod_dense* cholmod_solve(int system, cholmod_factor* factor, cholmod_dense* right, cholmod_common* common) {
  static const auto call = cholmod_function<decltype(cholmod_solve)>("cholmod_solve");
  return call(system, factor, right, common);
}

double cholmod_rcond(cholmod_factor* factor, cholmod_common* common) {
  static const auto call = cholmod_function<decltype(cholmod_rcond)>("cholmod_rcond");
  return call(factor, common);
}

int cholmod_free_dense(cholmod_dense** dense, cholmod_common* common) {
  static const auto call = cholmod_function<decltype(cholmod_free_dense)>("cholmod_free_dense");
  return call(dense, common);
}

int cholmod_free_factor(cholmod_factor** factor, cholmod_common* common) {
  static const auto call = cholmod_function<decltype(cholmod_free_factor)>("cholmod_free_factor");
  return call(factor, common);
}

}  // extern "C"
#pragma GCC visibility pop
