#pragma once

#include <new>
#include <stdexcept>

#include "sfumato/base/status.hpp"

namespace sfumato {

inline Status out_of_memory() {
  return make_error(StatusCode::out_of_memory, "out of memory");  // too short to be allocated
}

/// body(), which returns a Status or a Result; out_of_memory where an allocation in it fails. Every
/// public function does its work through this, so that nothing is thrown at who calls it. What the
/// body holds is released on the way, and charges with it. WebAssembly is built without exceptions:
/// there a failed allocation is a trap.
///
/// No frame of C may lie between this and an allocation of the body: see codecs/jpeg_encode.cpp.
template <class Body>
auto no_throw(Body&& body) -> decltype(body()) {
#if defined(__cpp_exceptions)
  try {
    return body();
  } catch (const std::bad_alloc&) {
    return out_of_memory();
  } catch (const std::length_error&) {  // of more elements than any memory holds
    return out_of_memory();
  }
#else
  return body();
#endif
}

}  // namespace sfumato
