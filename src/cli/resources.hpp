#pragma once

#include "options/settings.hpp"

namespace sfumato::cli {

class CommandSyntax;  // its header takes seconds to compile, so only files that add options include
                      // it

/// The resources of every command unless options change them.
inline options::Resources default_resources() {
  return {.seconds = limits::kSeconds};
}

/// Adds --max-memory, --max-time and --limit.
void add_resources(CommandSyntax& command, options::Resources& resources);

}  // namespace sfumato::cli
