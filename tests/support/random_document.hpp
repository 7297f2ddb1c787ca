#pragma once

#include <cstdint>

#include "sfumato/document/document.hpp"

namespace sfumato::test {

/// Returns a valid document chosen by a seed, with all features of the format: layers of curves
/// with every kind of side, blurred and weighted; curves that cross, meet, overlap and degenerate;
/// gradients and textures; instances under affine maps, blended, in groups; local curves. The
/// artboard is 96 to 160 units wide and high.
Document random_document(std::uint64_t seed);

}  // namespace sfumato::test
