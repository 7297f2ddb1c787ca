#pragma once

#include "sfumato/base/context.hpp"

namespace sfumato::cli {

/// While it lives, the first SIGINT, SIGTERM or SIGHUP sets `cancel` and the second ends the
/// process. At most one at a time.
class CancelOnSignal {
 public:
  explicit CancelOnSignal(CancelFlag& cancel);
  ~CancelOnSignal();
  CancelOnSignal(const CancelOnSignal&) = delete;
  CancelOnSignal& operator=(const CancelOnSignal&) = delete;
};

/// From now on writing to a closed pipe, or past the limit on a file's size, is an error of the
/// write and no end of the process: standard error, too, is written.
void ignore_write_signals();

/// The number of the signal that set a cancel flag; 0 where none has.
int received_signal();

}  // namespace sfumato::cli
