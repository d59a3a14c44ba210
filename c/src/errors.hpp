// From exceptions to error codes: nothing of C++ leaves the library.
#pragma once

#include <new>
#include <stdexcept>

#include "adit.h"

namespace adit::c_interface {

/// Keeps the text for adit_last_error() of this thread, cut to what fits.
void keep_error(const char* text) noexcept;

/// Runs work() and turns what it throws into a code.
template <class Work>
adit_error guarded(const Work& work) noexcept {
  try {
    work();
    return ADIT_OK;
  } catch (const std::invalid_argument& e) {
    keep_error(e.what());
    return ADIT_INVALID_ARGUMENT;
  } catch (const std::bad_alloc&) {
    keep_error("out of memory");
    return ADIT_OUT_OF_MEMORY;
  } catch (const std::exception& e) {
    keep_error(e.what());
    return ADIT_INTERNAL;
  } catch (...) {
    keep_error("an unknown exception");
    return ADIT_INTERNAL;
  }
}

/// @throws std::invalid_argument "finder is a null pointer"
template <class T>
T& given(T* pointer, const char* name) {
  if (pointer == nullptr) throw std::invalid_argument(std::string(name) + " is a null pointer");
  return *pointer;
}

}  // namespace adit::c_interface
