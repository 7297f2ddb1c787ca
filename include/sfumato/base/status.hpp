#pragma once

#include <cassert>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace sfumato {

/// What kind of error a Status is.
enum class StatusCode : std::uint8_t {
  ok,             ///< Success.
  bad_input,      ///< The input or an option is invalid; for a file, Status::where gives the place.
  limit,          ///< A limit of limits.hpp, the memory budget or the deadline was exceeded.
  cancelled,      ///< The caller set the cancel flag.
  io,             ///< The system refused to read or write.
  out_of_memory,  ///< The allocator refused; everything was released.
  unavailable,    ///< The machine lacks what was asked for: a GPU, or an instruction set.
  internal,       ///< A mistake in the library, or an unexpected error of one that it uses.
};

/// A place in an input.
struct SourcePlace {
  std::string file;  ///< the name that the caller gave the input; empty: unknown
  int line = 0;      ///< counted from 1; 0: unknown
  int column = 0;    ///< bytes, counted from 1; 0: unknown
};

/// A remark on work that succeeded: what was ignored, or cannot be shown.
struct Diagnostic {
  std::string message;  ///< for people; without a full stop
  SourcePlace where;    ///< what it is about
};

/// Success, or an error with a message for the user: what is wrong, and what was expected.
struct [[nodiscard]] Status {
  StatusCode code = StatusCode::ok;  ///< for programs; the rest is for people
  std::string message;               ///< empty for success
  SourcePlace where;                 ///< the place in the input, as far as it is known
  /// For StatusCode::limit, what the caller can raise: a LimitName ("curves"), "memory" for the
  /// Budget, or "time" for the Deadline. Empty where the bound is none of these. The text is a
  /// constant of the library.
  std::string_view limit;

  /// Whether this is success.
  bool ok() const { return code == StatusCode::ok; }
  /// The same as ok().
  explicit operator bool() const { return ok(); }
};

/// Success.
inline Status ok_status() {
  return {};
}

/// An error with an empty Status::limit.
inline Status make_error(StatusCode code, std::string message, SourcePlace where = {}) {
  return {code, std::move(message), std::move(where), {}};
}

/// "file:line:column: message", without the parts that are unknown.
std::string to_string(const Status& status);
/// As for a Status.
std::string to_string(const Diagnostic& diagnostic);

/// A value, or the Status that says why there is none.
template <class T>
class [[nodiscard]] Result {
 public:
  /// Success with a value.
  Result(T value) : value_(std::move(value)) {}
  /// An error. Precondition: `error` is not ok; otherwise the result is StatusCode::internal.
  Result(Status error) : status_(std::move(error)) {
    assert(!status_.ok());
    if (status_.ok()) status_ = make_error(StatusCode::internal, "no value");
  }

  /// Whether there is a value.
  bool ok() const { return value_.has_value(); }
  /// The same as ok().
  explicit operator bool() const { return ok(); }
  /// The error, or ok where there is a value.
  const Status& status() const { return status_; }

  /// @name Access to the value
  /// @{

  /// The value. Precondition: ok().
  T& operator*() { return *value_; }
  const T& operator*() const { return *value_; }
  T* operator->() { return &*value_; }
  const T* operator->() const { return &*value_; }
  /// @}

 private:
  std::optional<T> value_;
  Status status_;
};

}  // namespace sfumato
