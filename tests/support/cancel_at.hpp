#pragma once

#include <cstdint>

#include "base/poll.hpp"
#include "sfumato/base/context.hpp"

namespace sfumato::test {

/// Cancels at a poll. Until then loops of short iterations poll in every iteration; afterwards they
/// poll as rarely as usual, which exposes code that continues with incomplete tables.
class CancelAt : public PollWatch {
 public:
  CancelAt(std::uint64_t poll, CancelFlag& cancel) : left_(poll), cancel_(cancel) {}
  bool wants_every_turn() const override { return left_ > 0; }
  void polled() override {
    if (left_ > 0 && --left_ == 0) cancel_.store(true);
  }

 private:
  std::uint64_t left_;
  CancelFlag& cancel_;
};

}  // namespace sfumato::test
