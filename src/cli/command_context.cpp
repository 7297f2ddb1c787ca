#include "cli/command_context.hpp"

#include <unistd.h>

#include <chrono>
#include <cstdio>

namespace sfumato::cli {
namespace {

constexpr std::chrono::milliseconds kProgressDelay{1000};

}  // namespace

CommandContext::CommandContext(const DocumentArguments& arguments, int threads)
    : executor_(threads),
      context_{.executor = &executor_,
               .budget = Budget(arguments.resources.memory_bytes),
               .limits = arguments.resources.limits},
      cancel_on_signal_(context_.cancel) {
  if (arguments.quiet || isatty(STDERR_FILENO) == 0) return;
  bar_.emplace(stderr, kProgressDelay);
  context_.progress = &*bar_;
}

}  // namespace sfumato::cli
