#pragma once

#include <bit>
#include <cstdint>

#include "sfumato/base/context.hpp"

namespace sfumato {

/// Told of every look at the cancel flag: how tests learn how often work looks. Called from any
/// thread.
class PollWatch {
 public:
  virtual ~PollWatch() = default;
  virtual void polled() = 0;
  /// Whether loops of short turns look at every turn: each may then be the first to see the flag.
  virtual bool wants_every_turn() const { return false; }
};

/// Looks at the cancel flag once in `kTurns` calls, for loops of short turns. What it has seen once
/// it says at every later call: a loop that was ended early does not go on as the next one.
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
