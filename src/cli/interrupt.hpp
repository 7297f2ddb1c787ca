#pragma once

#include <atomic>

namespace sfumato::cli {

/// While it lives, the first SIGINT, SIGTERM or SIGHUP sets `cancel` and the second ends the
/// process. At most one at a time.
class CancelOnSignal {
 public:
  explicit CancelOnSignal(std::atomic<bool>& cancel);
  ~CancelOnSignal();
  CancelOnSignal(const CancelOnSignal&) = delete;
  CancelOnSignal& operator=(const CancelOnSignal&) = delete;
};

/// The number of the signal that set a cancel flag; 0 where none has.
int received_signal();

/// Lets writes past a file size limit or to a closed pipe fail with an error, which is reported and
/// leaves nothing behind, instead of ending the process.
void make_failed_writes_errors();

}  // namespace sfumato::cli
