#pragma once

#include <gtest/gtest.h>

#include <optional>
#include <utility>

#include "solve/layers/layer_solver.hpp"
#include "solve/layers/prepare_layer.hpp"

namespace sfumato::solve {

/// Returns the data that a solution of the layer leaves for drags.
/// patches: unless null, receives the solution
inline std::optional<RefinedLayer> refined_layer(Context& context, const Document& document,
                                                 std::uint32_t layer, const LayerSight& sight,
                                                 const DiffuseOptions& options,
                                                 PatchLayer* patches = nullptr) {
  std::optional<RefinedLayer> refined;
  Result<PreparedLayer> prepared =
      prepare_layer(context, document, layer, sight, options, nullptr, LayerUse::drags);
  if (!prepared) return refined;
  Result<PatchLayer> solved =
      LayerSolver(context, std::move(*prepared), options, nullptr).solve(&refined);
  EXPECT_EQ(solved.ok(), refined.has_value());
  if (solved && patches) *patches = std::move(*solved);
  return refined;
}

}  // namespace sfumato::solve
