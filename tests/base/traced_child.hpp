#pragma once

#include <cstddef>
#include <functional>
#include <optional>

namespace sfumato::test {

/// What befalls a process at one of its system calls.
struct Mishap {
  enum class Kind {
    none,
    kill,        ///< SIGKILL before the call
    error,       ///< the call does nothing and fails
    short_write  ///< a write of more than one byte writes half
  };
  Kind kind = Kind::none;
  std::size_t call = 0;  ///< which, from 0
  int error_number = 0;  ///< of an error
};

struct TracedEnd {
  std::size_t call_count = 0;  ///< system calls that body made, but for a sanitizer's
  long call = -1;              ///< the number of the one that the mishap befell
  int status = 0;              ///< what body returned, or minus the signal that ended it
};

/// Runs body in a process of its own, under ptrace. Nothing where that is not allowed, or where
/// this machine's registers are not known.
std::optional<TracedEnd> run_traced(const std::function<int()>& body, const Mishap& mishap);

}  // namespace sfumato::test
