#pragma once

#include <optional>
#include <string>

#include "cli/options/arguments.hpp"
#include "cli/options/option_helpers.hpp"

namespace sfumato::cli {

/// Options of `tiles` that are applied once all are known.
struct TilesChoices {
  std::optional<std::string> format;  ///< --format, as given
  std::optional<int> tile_side;
  std::optional<int> overlap;
  std::optional<Shard> shard;
};

void add_tiles(CommandSyntax& root, TilesArguments& arguments, TilesChoices& choices);

/// Applies the choices; throws CLI::ValidationError if options conflict.
void settle(TilesArguments& arguments, const TilesChoices& choices);

}  // namespace sfumato::cli
