#pragma once

#include <cstddef>
#include <utility>

#include "base/poll.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::svg_import {

/// Counts the points that outlines are made of, and looks at the cancel flag. What makes them asks
/// failed(), so that a long recursion needs no Result of its own.
class PointMeter {
 public:
  explicit PointMeter(Context& context) : context_(context), poll_(context) {}

  Context& context() const { return context_; }

  /// Counts points that are made now; false: stop, for status().
  bool take(std::size_t points) {
    if (!status_) return false;
    made_ += points;
    if (poll_.cancelled()) {
      status_ = context_.cancel_status();
    } else if (made_ > kMostPoints) {
      status_ = make_error(StatusCode::limit, "a shape of the drawing is too long");
    }
    return !failed();
  }
  /// Looks at the flag now: for steps of a millisecond.
  bool look() {
    if (status_) status_ = context_.check();
    return !failed();
  }
  void fail(Status why) { status_ = std::move(why); }
  /// Whether neither this nor anything before has failed.
  bool keep(Status status) {
    if (status_) status_ = std::move(status);
    return !failed();
  }
  bool failed() const { return !status_; }
  const Status& status() const { return status_; }

 private:
  static constexpr std::size_t kMostPoints = 6'000'000;  ///< three make a chord at least

  Context& context_;
  RarePoll<16> poll_;
  std::size_t made_ = 0;
  Status status_;
};

}  // namespace sfumato::svg_import
