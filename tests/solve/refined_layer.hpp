#pragma once

#include <gtest/gtest.h>

#include <optional>
#include <utility>

#include "solve/layer_solver.hpp"
#include "solve/prepare_layer.hpp"

namespace sfumato::solve {

/// What a solution of the layer leaves for drags.
inline std::optional<RefinedLayer> refined_layer(Context& context, const Document& document,
                                                 std::uint32_t layer, const LayerSight& sight,
                                                 const DiffuseOptions& options) {
  std::optional<RefinedLayer> refined;
  Result<PreparedLayer> prepared =
      prepare_layer(context, document, layer, sight, options, nullptr, LayerUse::drags);
  if (!prepared) return refined;
  const bool is_solved =
      LayerSolver(context, std::move(*prepared), options, nullptr).solve(&refined).ok();
  EXPECT_EQ(is_solved, refined.has_value());
  return refined;
}

}  // namespace sfumato::solve
