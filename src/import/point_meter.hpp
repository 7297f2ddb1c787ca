#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>

#include "base/charge.hpp"
#include "base/poll.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/base/vec2.hpp"

namespace sfumato::svg_import {

/// Counts the points that outlines are made of: charges their memory, in steps, and looks at the
/// cancel flag. What makes them asks failed(), so that a long recursion needs no Result of its
/// own.
class PointMeter {
 public:
  /// charge   takes what the points cost; must outlive the meter.
  PointMeter(Context& context, ScopedCharge& charge)
      : context_(context), charge_(charge), poll_(context) {}

  /// Counts points that are made now; false: stop, for status().
  bool take(std::size_t points) {
    if (!status_) return false;
    made_ += points;
    if (poll_.cancelled()) {
      status_ = context_.cancel_status();
    } else if (made_ > kMostPoints) {
      status_ = make_error(StatusCode::limit, "a shape of the drawing is too long");
    } else if (made_ > charged_) {
      const std::size_t step = std::max(made_ - charged_, kStep);
      // Twice: a vector that grows is larger than what it holds.
      status_ = charge_.add(context_, 2 * step * sizeof(Vec2), "the outline of a stroke");
      charged_ += step;
    }
    return !failed();
  }
  /// Looks at the flag now: for steps of a millisecond.
  bool look() {
    if (status_) status_ = context_.check();
    return !failed();
  }
  void fail(Status why) { status_ = std::move(why); }
  bool failed() const { return !status_; }
  const Status& status() const { return status_; }

 private:
  static constexpr std::size_t kMostPoints = 6'000'000;  ///< three make a chord at least
  static constexpr std::size_t kStep = 4096;

  Context& context_;
  ScopedCharge& charge_;
  RarePoll<16> poll_;
  std::size_t made_ = 0;
  std::size_t charged_ = 0;
  Status status_;
};

}  // namespace sfumato::svg_import
