#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "sfumato/solve/solution.hpp"
#include "solve/layers/layer_solver.hpp"

namespace sfumato::solve {

/// Returns the bytes of memory that the lists occupy.
std::size_t bytes_of(const FrameRows& rows);

/// Returns the rows that may differ between two frames of a drag, from the rows of each frame that
/// may differ from their base.
LayerRows rows_between(std::uint32_t layer, const FrameRows& a, const FrameRows& b);

/// Adds a layer to the changed layers of `delta`.
/// rows   the rows that changed; empty: all rows
void note_new(std::uint32_t layer, std::optional<LayerRows> rows, PictureDelta& delta);

}  // namespace sfumato::solve

namespace sfumato {

/// Returns the bytes of memory that the lists occupy.
std::size_t bytes_of(const LayerRows& rows);

}  // namespace sfumato
