#pragma once

#include <new>
#include <stdexcept>

#include "sfumato/base/status.hpp"

namespace sfumato {

inline Status out_of_memory() {
  return make_error(StatusCode::out_of_memory, "out of memory");  // needs no allocation
}

/// Calls body(), which returns a Status or a Result; returns out_of_memory if an allocation in it
/// fails. Every public function works through this, so that no exception reaches the caller.
/// Everything that the body holds is released, with its charges. WebAssembly is built without
/// exceptions: there a failed allocation traps.
///
/// No C function may be on the stack between this and an allocation of the body; see
/// codecs/jpeg/jpeg_encode.cpp.
template <class Body>
auto no_throw(Body&& body) -> decltype(body()) {
#if defined(__cpp_exceptions)
  try {
    return body();
  } catch (const std::bad_alloc&) {
    return out_of_memory();
  } catch (const std::length_error&) {  // more elements than any memory holds
    return out_of_memory();
  }
#else
  return body();
#endif
}

}  // namespace sfumato
