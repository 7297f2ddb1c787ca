#pragma once

#include <cstddef>
#include <utility>

#include "base/poll.hpp"
#include "import/shape_limits.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::svg_import {

/// Counts the points of outlines and checks the cancel flag. Functions that make points call
/// failed(), so that a deep recursion needs no Result.
class PointMeter {
 public:
  explicit PointMeter(Context& context) : context_(context), poll_(context) {}

  Context& context() const { return context_; }

  /// Counts new points. Returns false if the caller must stop because of status().
  bool take(std::size_t points) {
    if (!status_) return false;
    made_ += points;
    if (poll_.cancelled()) {
      status_ = context_.cancel_status();
    } else if (made_ > kPointsOfChord * context_.limits.chords) {
      status_ = too_long(context_);
    }
    return !failed();
  }
  /// Polls the flag now, for steps of about a millisecond.
  bool look() {
    if (status_) status_ = context_.check();
    return !failed();
  }
  void fail(Status why) { status_ = std::move(why); }
  /// Keeps the first failure; returns whether there is none.
  bool keep(Status status) {
    if (status_) status_ = std::move(status);
    return !failed();
  }
  bool failed() const { return !status_; }
  const Status& status() const { return status_; }

 private:
  static constexpr std::size_t kPointsOfChord = 3;  ///< at least

  Context& context_;
  RarePoll<16> poll_;
  std::size_t made_ = 0;
  Status status_;
};

}  // namespace sfumato::svg_import
