#pragma once

#include <optional>

#include "cli/arguments.hpp"
#include "cli/interrupt.hpp"
#include "cli/progress_bar.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/native/thread_pool.hpp"

namespace sfumato::cli {

/// What a command works with: its threads, its memory and limits, and on a terminal a progress bar,
/// unless it is to be quiet. A signal cancels the work.
class CommandContext {
 public:
  /// threads   0: all cores
  CommandContext(const DocumentArguments& arguments, int threads);

  Context& context() { return context_; }
  /// Null: there is none.
  ProgressBar* bar() { return bar_ ? &*bar_ : nullptr; }

 private:
  ThreadPool executor_;
  std::optional<ProgressBar> bar_;
  Context context_;
  CancelOnSignal cancel_on_signal_;
};

}  // namespace sfumato::cli
