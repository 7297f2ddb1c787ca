#pragma once

#include <cassert>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace sfumato {

enum class StatusCode : std::uint8_t {
  ok,
  bad_input,  ///< The input cannot be understood or drawn; `where` says the place.
  limit,  ///< A limit of limits.hpp or the memory budget would be passed; nothing was allocated.
  cancelled,      ///< The caller's cancel flag was seen.
  io,             ///< The system refused a read or a write.
  out_of_memory,  ///< The allocator refused.
  unavailable,    ///< The machine lacks what was asked for: no GPU.
  internal,       ///< A mistake of ours.
};

/// A place in an input. line and column count from 1; 0 means unknown.
struct SourcePlace {
  std::string file;
  int line = 0;
  int column = 0;
};

/// What is worth telling of work that succeeded: what was overlooked, or cannot be shown.
struct Diagnostic {
  std::string message;
  SourcePlace where;
};

/// Success, or what went wrong, in words for the user: what is wrong, what was expected.
struct [[nodiscard]] Status {
  StatusCode code = StatusCode::ok;
  std::string message;
  SourcePlace where;
  /// Of StatusCode::limit: what the caller can set higher, a LimitName ("curves"), "memory" for the
  /// Budget or "time" for the Deadline. Empty: nothing, the bound is a data structure's.
  std::string_view limit;

  bool ok() const { return code == StatusCode::ok; }
  explicit operator bool() const { return ok(); }
};

inline Status ok_status() {
  return {};
}

inline Status make_error(StatusCode code, std::string message, SourcePlace where = {}) {
  return {code, std::move(message), std::move(where), {}};
}

/// "file:line:column: message", leaving out what is unknown.
std::string to_string(const Status& status);
std::string to_string(const Diagnostic& diagnostic);

/// A value, or the Status that says why there is none.
template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value) : value_(std::move(value)) {}
  /// Precondition: an error. Success without a value is StatusCode::internal.
  Result(Status error) : status_(std::move(error)) {
    assert(!status_.ok());
    if (status_.ok()) status_ = make_error(StatusCode::internal, "no value");
  }

  bool ok() const { return value_.has_value(); }
  explicit operator bool() const { return ok(); }
  const Status& status() const { return status_; }

  /// Precondition: ok().
  T& operator*() { return *value_; }
  const T& operator*() const { return *value_; }
  T* operator->() { return &*value_; }
  const T* operator->() const { return &*value_; }

 private:
  std::optional<T> value_;
  Status status_;
};

}  // namespace sfumato
