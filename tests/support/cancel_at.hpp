#pragma once

#include <cstdint>

#include "base/poll.hpp"
#include "sfumato/base/context.hpp"

namespace sfumato::test {

/// One that cancels at a poll. Until then loops of short turns look at every turn; after it they
/// look as rarely as they do elsewhere, so that what goes on with half-made tables is found.
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
