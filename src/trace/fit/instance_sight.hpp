#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "base/table_memory.hpp"
#include "gather/rows/rows.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/document/document.hpp"
#include "trace/curves/drawing_layers.hpp"
#include "trace/fit/row_color.hpp"
#include "trace/image/sample_pixels.hpp"

namespace sfumato::tracing {

/// A layer that shows less than this is not seen.
inline constexpr float kUnseen = 1.0f / 1024;

/// The points of a picture at which a layer shows at one place.
struct InstanceSight {
  Affine layer_from_pixel;
  std::vector<std::uint32_t> point;  ///< indices of SamplePixels::point, ascending
  std::vector<float> opacity;        ///< per point: of the layer there, 0 where it has no colour
  gather::Rows rows;                 ///< weights of its colours, per point
  TableMemory memory{"what a drawing shows"};
};

/// Evaluates layers at points of a picture.
class LayerLooker {
 public:
  /// All outlive this.
  LayerLooker(Context& context, const Document& drawing,
              std::span<const std::optional<DrawnLayer>> layers, const SamplePixels& pixels)
      : context_(context), drawing_(drawing), layers_(layers), pixels_(pixels) {
    color_shaders_.resize(drawing.shaders.size());
    opacity_shaders_.resize(drawing.shaders.size());
    reach_.resize(layers.size());
  }

  /// layer    one that was prepared
  /// is_open  whether the items above let the point show
  /// Errors   limit (memory, counts), cancelled
  Result<InstanceSight> look(std::uint32_t layer, const Affine& layer_from_pixel,
                             FunctionRef<bool(std::uint32_t point)> is_open);

  /// Finds the code values of a layer's present colours at the evaluated points. Errors: limit
  /// (memory), cancelled.
  Status find_colors(std::uint32_t layer, const InstanceSight& sight, std::span<Rgb> code) const;

  /// The evaluated layers, in the drawing's interpolation space.
  ImageShaders take_color_shaders() { return std::move(color_shaders_); }

 private:
  Status find_opacities(const DrawnLayer& layer, std::span<const Vec2> points,
                        const Affine& layer_from_pixel, std::span<float> opacity);
  Result<Box> reach_of(std::uint32_t layer, const Affine& layer_from_pixel);
  Status prepare_shaders(std::span<const std::uint32_t> named, InterpolationSpace space,
                         ImageShaders& shaders);

  Context& context_;
  const Document& drawing_;
  std::span<const std::optional<DrawnLayer>> layers_;
  const SamplePixels& pixels_;
  ImageShaders color_shaders_, opacity_shaders_;
  std::vector<std::optional<Box>> reach_;  ///< per layer, once it was found
};

}  // namespace sfumato::tracing
