#pragma once

#include <atomic>
#include <cstdint>

#include "base/context.hpp"

namespace sfumato::test {

/// One that cancels at a poll, and looks at every turn of loops of short turns.
class CancelAt : public PollWatch {
 public:
  CancelAt(std::uint64_t poll, std::atomic<bool>& cancel) : left_(poll), cancel_(cancel) {}
  bool wants_every_turn() const override { return true; }
  void polled() override {
    if (--left_ == 0) cancel_.store(true);
  }

 private:
  std::uint64_t left_;
  std::atomic<bool>& cancel_;
};

}  // namespace sfumato::test
