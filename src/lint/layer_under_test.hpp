#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "base/boxes.hpp"
#include "curves/attributes.hpp"
#include "sfumato/document/document.hpp"
#include "sfumato/lint/hint.hpp"
#include "solve/layers/prepare_layer.hpp"

namespace sfumato::lint_detail {

/// Returns the size of a pixel, in artboard units, if the artboard is 512 pixels long. Curves are
/// flattened and meshed for this resolution, and hints compare small lengths with it.
inline double artboard_pixel(const Document& document) {
  constexpr double kArtboardPx = 512;
  return longer_side(document.artboard) / kArtboardPx;
}

/// A painted layer with its prepared data. Hints are added to `hints`.
struct LayerUnderTest {
  Context& context;
  const Document& document;
  std::uint32_t layer;
  const solve::LayerSight& sight;
  const solve::PreparedLayer& prepared;
  const mesh::TriangleMesh& mesh;  ///< prepared.mesher's visibility mesh
  std::vector<Hint>& hints;

  const std::vector<Curve>& curves() const { return document.layers[layer].curves; }

  Hint& add(HintKind kind, std::string message) {
    return hints.emplace_back(Hint{.kind = kind, .layer = layer, .message = std::move(message)});
  }
  Hint& add(HintKind kind, std::uint32_t curve, std::string message) {
    Hint& hint = add(kind, std::move(message));
    hint.curve = curve;
    return hint;
  }
};

/// Returns whether the side affects rays of colour or opacity.
inline bool bears_anything(const Side& side) {
  return side.color.kind != ShaderKind::open || side.opacity.kind != ShaderKind::open;
}

}  // namespace sfumato::lint_detail
