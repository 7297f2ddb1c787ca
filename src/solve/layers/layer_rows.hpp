#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "sfumato/solve/solution.hpp"
#include "solve/layers/layer_solver.hpp"

namespace sfumato::solve {

/// Bytes of memory that the lists occupy.
std::size_t bytes_of(const FrameRows& rows);

/// The rows in which two frames of one drag may differ.
LayerRows rows_between(std::uint32_t layer, const FrameRows& a, const FrameRows& b);

/// Adds a layer to those that are new.
/// rows   those of its rows that are new; none: all
void note_new(std::uint32_t layer, std::optional<LayerRows> rows, PictureDelta& delta);

}  // namespace sfumato::solve

namespace sfumato {

/// Bytes of memory that the lists occupy.
std::size_t bytes_of(const LayerRows& rows);

}  // namespace sfumato
