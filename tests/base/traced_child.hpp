#pragma once

#include <cstddef>
#include <functional>
#include <optional>

namespace sfumato::test {

/// A fault at one of a process's system calls.
struct Mishap {
  enum class Kind {
    none,
    kill,        ///< SIGKILL before the call
    error,       ///< the call does nothing and fails
    short_write  ///< a write of more than one byte writes half
  };
  Kind kind = Kind::none;
  std::size_t call = 0;  ///< index of the call, from 0
  int error_number = 0;  ///< for `error`
};

struct TracedEnd {
  std::size_t call_count = 0;  ///< how many system calls body made, without a sanitizer's
  long call = -1;              ///< number of the system call that failed
  int status = 0;              ///< value that body returned, or minus the signal that ended it
};

/// Runs body in a separate process under ptrace. Returns nothing if ptrace is not allowed, or if
/// this machine's registers are not known.
std::optional<TracedEnd> run_traced(const std::function<int()>& body, const Mishap& mishap);

}  // namespace sfumato::test
