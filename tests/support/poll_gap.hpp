#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

#include "support/poll_recorder.hpp"
#include "support/sanitizers.hpp"

/// Limits for the time between polls, as multiples of a piece of work that is measured beside it: a
/// slow or busy machine lengthens both.
namespace sfumato::test {

/// Returns the thread's CPU time, seconds, for a fixed piece of work, measured now: 10 ms on the
/// machine of docs/limits.md. In each step, the value read from a table gives the next place to
/// read.
inline double reference_seconds() {
  constexpr std::uint32_t kSteps = 1 << 21, kPlaceBits = 16, kPlaces = 1 << kPlaceBits;
  std::vector<std::uint32_t> table(kPlaces);
  for (std::uint32_t i = 0; i < kPlaces; ++i) table[i] = i * 2'654'435'761u;
  const double begin = thread_seconds();
  std::uint32_t state = 1;
  for (std::uint32_t i = 0; i < kSteps; ++i) {
    state = (state * 1'664'525 + 1'013'904'223) ^ table[state >> (32 - kPlaceBits)];
  }
  const volatile std::uint32_t kept = state;
  static_cast<void>(kept);
  return thread_seconds() - begin;
}

/// Limit for work without a poll, in references: 50 ms on that machine.
#if SFUMATO_HAS_SANITIZER || !defined(NDEBUG)
constexpr double kMostReferences = 100;  // library and references are slowed down differently
#else
constexpr double kMostReferences = 5;
#endif

/// Calls longest_gap(), which does the work and returns its longest gap in CPU seconds, until one
/// run of five is within the limit. A missing poll shows in every run, other work of the machine
/// only in some.
template <class LongestGap>
void expect_short_gaps(const std::string& name, const LongestGap& longest_gap) {
  constexpr int kMostRuns = 5;
  double gap = 0, most = 0;
  for (int i = 0; i < kMostRuns; ++i) {
    gap = longest_gap();
    most = kMostReferences * reference_seconds();
    if (gap < most) return;
  }
  ADD_FAILURE() << name << ": " << 1e3 * gap << " ms without a poll, where " << 1e3 * most
                << " ms are granted";
}

}  // namespace sfumato::test
