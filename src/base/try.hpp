#pragma once

#include <utility>

#include "sfumato/base/status.hpp"

namespace sfumato {

/// Returns the status of a value that SFUMATO_TRY() checks.
inline Status&& status_of(Status&& status) {
  return std::move(status);
}
/// As for a temporary Status.
inline const Status& status_of(const Status& status) {
  return status;
}
/// As for a Status.
template <class T>
const Status& status_of(const Result<T>& result) {
  return result.status();
}

}  // namespace sfumato

/// Evaluates an expression of type Status or Result. Returns its status from the calling function
/// if it is an error.
#define SFUMATO_TRY(...)                                                                       \
  do {                                                                                         \
    auto&& try_value = (__VA_ARGS__);                                                          \
    if (!try_value) return ::sfumato::status_of(std::forward<decltype(try_value)>(try_value)); \
  } while (false)

/// Evaluates an expression of type Result. Returns its status from the calling function if it is an
/// error; otherwise moves its value to `target`: a variable, or the declaration of a reference to
/// the value, which lives until the end of the block.
///
///     SFUMATO_TRY_ASSIGN(mesh_, mesh_of(context, curves));
///     SFUMATO_TRY_ASSIGN(const Box& box, bounds_of(context, curves));
///     SFUMATO_TRY_ASSIGN(auto&& image, rasterize(context, picture));
#define SFUMATO_TRY_ASSIGN(target, ...) \
  SFUMATO_TRY_ASSIGN_AT(SFUMATO_TRY_JOIN(try_result_, __LINE__), target, __VA_ARGS__)
#define SFUMATO_TRY_ASSIGN_AT(result, target, ...) \
  auto result = (__VA_ARGS__);                     \
  if (!result) return result.status();             \
  target = std::move(*result)
#define SFUMATO_TRY_JOIN(a, b) SFUMATO_TRY_JOIN_NOW(a, b)
#define SFUMATO_TRY_JOIN_NOW(a, b) a##b
