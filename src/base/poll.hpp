#pragma once

#include <bit>
#include <cstdint>

#include "sfumato/base/context.hpp"

namespace sfumato {

/// Observes each poll of the cancel flag, so that tests can measure how often work polls it. Called
/// from any thread.
class PollWatch {
 public:
  virtual ~PollWatch() = default;
  virtual void polled() = 0;
  /// Returns whether RarePoll polls the flag at every call, so that any of them may see it first.
  virtual bool wants_every_turn() const { return false; }
};

/// Polls the cancel flag once in `kTurns` calls, for loops with short iterations. Once it has seen
/// the flag it reports it on every later call, so that a second loop does not start.
template <std::uint32_t kTurns>
class RarePoll {
  static_assert(std::has_single_bit(kTurns));

 public:
  explicit RarePoll(const Context& context) : context_(context) {
    if (context.poll_watch && context.poll_watch->wants_every_turn()) mask_ = 0;
  }
  bool cancelled() {
    if ((++turn_ & mask_) == 0) has_seen_ = has_seen_ || context_.cancelled();
    return has_seen_;
  }

 private:
  const Context& context_;
  std::uint32_t turn_ = 0;
  std::uint32_t mask_ = kTurns - 1;
  bool has_seen_ = false;
};

}  // namespace sfumato
