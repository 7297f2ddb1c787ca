#pragma once

#include <cstddef>
#include <optional>

#include "sfumato/base/context.hpp"

namespace CLI {
class App;  // its header takes seconds to compile, so only files that add options include it
}

namespace sfumato::cli {

/// Bounds on a command's memory and time, and the limits on its input.
struct Resources {
  Limits limits{};
  std::size_t memory_bytes = limits::kMemoryBytes;
  std::optional<double> seconds = limits::kSeconds;  ///< none: no limit
};

/// --max-memory, --max-time and --limit.
void add_resources(CLI::App& app, Resources& resources);

/// The deadline, counted from now.
std::optional<Deadline> deadline_of(const Resources& resources);

}  // namespace sfumato::cli
