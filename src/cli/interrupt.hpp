#pragma once

#include "sfumato/base/context.hpp"

namespace sfumato::cli {

/// During its lifetime the first SIGINT, SIGTERM, SIGHUP or SIGXCPU sets `cancel` and the second
/// ends the process. A signal that the caller ignores stays ignored. There may be only one at a
/// time.
class CancelOnSignal {
 public:
  explicit CancelOnSignal(CancelFlag& cancel);
  ~CancelOnSignal();
  CancelOnSignal(const CancelOnSignal&) = delete;
  CancelOnSignal& operator=(const CancelOnSignal&) = delete;
};

/// From now on writing to a closed pipe, or past the limit on a file's size, is an error of the
/// write and does not end the process. This holds for standard error too.
void ignore_write_signals();

/// Returns the number of the signal that set a cancel flag; 0 if none has.
int received_signal();

}  // namespace sfumato::cli
