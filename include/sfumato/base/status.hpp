#pragma once

#include <cassert>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace sfumato {

/// The kinds of errors.
enum class StatusCode : std::uint8_t {
  ok,             ///< Success.
  bad_input,      ///< The input or an option is invalid; for a file, Status::where gives the place.
  limit,          ///< A limit of limits.hpp, the memory budget or the deadline was exceeded.
  cancelled,      ///< The caller set the cancel flag.
  io,             ///< The system refused to read or write.
  out_of_memory,  ///< The system could not allocate memory; everything was released.
  unavailable,    ///< The machine lacks the requested device or feature: a GPU, or an instruction
                  ///< set.
  internal,       ///< An internal error of the library, or an unexpected error of a library that it
                  ///< uses.
};

/// A place in an input.
struct SourcePlace {
  std::string file;  ///< the name that the caller gave the input; empty: unknown
  int line = 0;      ///< counted from 1; 0: unknown
  int column = 0;    ///< bytes, counted from 1; 0: unknown
};

/// A remark on work that succeeded: content that was ignored, or that cannot be shown.
struct Diagnostic {
  std::string message;  ///< for people; without a full stop
  SourcePlace where;    ///< its subject
};

/// Success, or an error with a message for the user: the mistake, and the expected input.
struct [[nodiscard]] Status {
  StatusCode code = StatusCode::ok;  ///< for programs; the rest is for people
  std::string message;               ///< empty for success
  SourcePlace where;                 ///< the place in the input, as far as it is known
  /// For StatusCode::limit, the limit that the caller can raise: a LimitName ("curves"), "memory"
  /// for the Budget, or "time" for the Deadline. Empty where the bound is none of these. The text
  /// is a constant of the library.
  std::string_view limit;

  /// Returns whether this is success.
  bool ok() const { return code == StatusCode::ok; }
  /// Does ok().
  explicit operator bool() const { return ok(); }
};

/// Returns success.
inline Status ok_status() {
  return {};
}

/// Makes an error with an empty Status::limit.
inline Status make_error(StatusCode code, std::string message, SourcePlace where = {}) {
  return {code, std::move(message), std::move(where), {}};
}

/// Returns "file:line:column: message", without the unknown parts.
std::string to_string(const Status& status);
/// Does the same for a diagnostic.
std::string to_string(const Diagnostic& diagnostic);

/// A value, or the Status that explains why there is none.
template <class T>
class [[nodiscard]] Result {
 public:
  /// Makes a success with a value.
  Result(T value) : value_(std::move(value)) {}
  /// Makes an error. Precondition: `error` is not ok; otherwise the result is StatusCode::internal.
  Result(Status error) : status_(std::move(error)) {
    assert(!status_.ok());
    if (status_.ok()) status_ = make_error(StatusCode::internal, "no value");
  }

  /// Returns whether there is a value.
  bool ok() const { return value_.has_value(); }
  /// Does ok().
  explicit operator bool() const { return ok(); }
  /// Returns the error, or ok where there is a value.
  const Status& status() const { return status_; }

  /// @name Access to the value
  /// @{

  /// Returns the value. Precondition: ok().
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
