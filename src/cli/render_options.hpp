#pragma once

#include <optional>
#include <string>

#include "cli/arguments.hpp"
#include "cli/option_helpers.hpp"

namespace sfumato::cli {

/// Options that affect several members of RenderArguments and are applied once all options are
/// known.
struct RenderChoices : JobChoices {
  std::optional<OutputKind> format;
  std::string extension = "png";  ///< of the format, as given
};

/// --viewport, --width, --height and --scale.
void add_place_options(CLI::App& app, options::Settings& settings);

CLI::App* add_render(CLI::App& root, RenderArguments& arguments, RenderChoices& choices);

/// Applies the choices; throws CLI::ValidationError if options conflict.
void settle(RenderArguments& arguments, const RenderChoices& choices);

}  // namespace sfumato::cli
