#pragma once

namespace sfumato::gather {

/// A window that cannot add more than this share of the weight found so far is not followed. Its
/// measured cost at the nodes of the paper's mesh, in code values of 255: on dolphin, lady_bug,
/// roses and portrait.svg at most 0.02 for 99 nodes of 100 and 0.05 for any.
inline constexpr float kNegligible = 6e-5f;

/// The same for a picture for a pixel grid. The gather takes 4 to 8% fewer instructions. The rms
/// error of lady_bug and tomatos changes by at most 0.001 code values.
inline constexpr float kGridNegligible = 3e-4f;

/// The same for point_walk.glsl, where more exactness costs less: among 200 strokes it takes 3 of
/// 100 steps more than with kNegligible, for a seventh of the error.
inline constexpr float kPointNegligible = 1e-5f;

}  // namespace sfumato::gather
