#pragma once

#include "cli/options/arguments.hpp"
#include "cli/options/option_helpers.hpp"
#include "options/settings.hpp"

namespace sfumato::cli {

/// Options that affect several members of TraceArguments and are applied once all are known.
struct TraceChoices : JobChoices {
  options::TraceSettings settings;
};

void add_trace(CommandSyntax& root, TraceArguments& arguments, TraceChoices& choices);

/// Applies the choices; throws CLI::ValidationError if options conflict. app: the result of
/// add_trace().
void settle(const CLI::App& app, TraceArguments& arguments, const TraceChoices& choices);

}  // namespace sfumato::cli
