#include "cli/command_context.hpp"

#include <unistd.h>

#include <chrono>
#include <cstdio>

namespace sfumato::cli {
namespace {

constexpr std::chrono::milliseconds kProgressDelay{1000};

}  // namespace

CommandContext::CommandContext(const options::Resources& resources, int threads)
    : executor_(threads),
      context_{.executor = &executor_,
               .budget = Budget(resources.memory_bytes),
               .limits = resources.limits},
      cancel_on_signal_(context_.cancel) {}

CommandContext::CommandContext(const DocumentArguments& arguments, int threads)
    : CommandContext(arguments.resources, threads) {
  if (arguments.quiet || isatty(STDERR_FILENO) == 0) return;
  bar_.emplace(stderr, kProgressDelay);
  context_.progress = &*bar_;
}

}  // namespace sfumato::cli
