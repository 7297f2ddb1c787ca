#pragma once

#include <string>
#include <utility>

#include "base/no_throw.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/sfumato.h"

namespace sfumato::capi {

/// The result of a call of the C interface: the library's status, or a mistake of the caller.
struct Outcome {
  Outcome() = default;
  /// The codes of the library equal the codes of the interface.
  Outcome(Status s) : code(static_cast<std::int32_t>(s.code)), status(std::move(s)) {}
  Outcome(std::int32_t c, Status s) : code(c), status(std::move(s)) {}

  /// Whether the call succeeded.
  explicit operator bool() const { return code == SFUMATO_OK; }

  std::int32_t code = SFUMATO_OK;
  Status status{};  ///< words and place
};

static_assert(static_cast<int>(StatusCode::internal) == SFUMATO_INTERNAL);

/// Returns SFUMATO_BAD_USAGE with this message.
inline Outcome bad_usage(std::string what) {
  return {SFUMATO_BAD_USAGE, make_error(StatusCode::bad_input, std::move(what))};
}
/// Returns SFUMATO_BAD_USAGE for an error in the options of a call.
inline Outcome bad_usage(Status status) {
  return {SFUMATO_BAD_USAGE, std::move(status)};
}

/// Runs body(), which returns an Outcome. Turns its exceptions into an Outcome, also exceptions
/// that a caller's function throws through it, without needing memory. WebAssembly is built without
/// exceptions.
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

namespace sfumato {

/// As for a Status: SFUMATO_TRY() takes outcomes too.
inline capi::Outcome&& status_of(capi::Outcome&& outcome) {
  return std::move(outcome);
}

}  // namespace sfumato
