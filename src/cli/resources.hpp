#pragma once

#include "options/settings.hpp"

namespace CLI {
class App;  // its header takes seconds to compile, so only files that add options include it
}

namespace sfumato::cli {

/// The resources of every command unless options change them.
inline options::Resources default_resources() {
  return {.seconds = limits::kSeconds};
}

/// Adds --max-memory, --max-time and --limit.
void add_resources(CLI::App& app, options::Resources& resources);

}  // namespace sfumato::cli
