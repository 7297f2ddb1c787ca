#pragma once

#include <string>
#include <utility>

#include "base/no_throw.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/sfumato.h"

namespace sfumato::capi {

/// How a call of the C interface ended: as the library says, or by a mistake of the caller's.
struct Outcome {
  Outcome() = default;
  /// The codes of the library are those of the interface.
  Outcome(Status s) : code(static_cast<std::int32_t>(s.code)), status(std::move(s)) {}
  Outcome(std::int32_t c, Status s) : code(c), status(std::move(s)) {}

  std::int32_t code = SFUMATO_OK;
  Status status{};  ///< words and place
};

static_assert(static_cast<int>(StatusCode::internal) == SFUMATO_INTERNAL);

/// SFUMATO_BAD_USAGE with these words.
inline Outcome bad_usage(std::string what) {
  return {SFUMATO_BAD_USAGE, make_error(StatusCode::bad_input, std::move(what))};
}
/// The same for what the options of a call get wrong.
inline Outcome bad_usage(Status status) {
  return {SFUMATO_BAD_USAGE, std::move(status)};
}

/// Runs body(), which returns an Outcome; what it throws becomes one, also what a caller's function
/// throws through it. Needs no memory for that. WebAssembly is built without exceptions.
template <class Body>
Outcome caught(Body&& body) noexcept {
#if defined(__cpp_exceptions)
  try {
    return no_throw(body);
  } catch (...) {
    return make_error(StatusCode::internal, "an exception");
  }
#else
  return no_throw(body);
#endif
}

}  // namespace sfumato::capi
