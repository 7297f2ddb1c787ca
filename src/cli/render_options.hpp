#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cli/arguments.hpp"
#include "cli/option_helpers.hpp"

namespace sfumato::cli {

enum class RenderDevice : std::uint8_t { cpu, gpu };

enum class RenderMethod : std::uint8_t { exact, rays, pixels };

/// Options that affect several members of RenderArguments and are applied once all options are
/// known.
struct RenderChoices {
  std::vector<std::string> inputs;
  std::string output;
  std::string output_folder;
  std::optional<OutputKind> format;
  std::string extension = "png";  ///< of the format, as given
  std::optional<int> quality;
  std::optional<double> detail;
  std::optional<SvgMode> svg;
  RenderMethod method = RenderMethod::exact;
  RenderDevice device = RenderDevice::cpu;
  int depth = 8;
  bool no_antialias = false;
  std::optional<bool> dither;
  bool sets_max_error = false;
};

/// --viewport, --width, --height and --scale.
void add_place_options(CLI::App& app, RenderArguments& arguments);

CLI::App* add_render(CLI::App& root, RenderArguments& arguments, RenderChoices& choices);

/// Applies the choices; throws CLI::ValidationError if options conflict.
void settle(RenderArguments& arguments, const RenderChoices& choices);

}  // namespace sfumato::cli
