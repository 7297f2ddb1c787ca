#pragma once

#include <optional>

#include "cli/interrupt.hpp"
#include "cli/options/arguments.hpp"
#include "cli/progress_bar.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/native/thread_pool.hpp"

namespace sfumato::cli {

/// Holds the resources of a command: its threads, memory, limits and, on a terminal, a progress bar
/// unless it is quiet. A signal cancels the work.
class CommandContext {
 public:
  /// threads   0: all cores
  explicit CommandContext(const options::Resources& resources, int threads = 0);
  CommandContext(const DocumentArguments& arguments, int threads);

  Context& context() { return context_; }
  /// Returns null if there is none.
  ProgressBar* bar() { return bar_ ? &*bar_ : nullptr; }

 private:
  ThreadPool executor_;
  std::optional<ProgressBar> bar_;
  Context context_;
  CancelOnSignal cancel_on_signal_;
};

}  // namespace sfumato::cli
