#include "import/mask_opacity.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <variant>

#include "base/poll.hpp"
#include "base/try.hpp"
#include "formats/svg/paint/texel_grid.hpp"
#include "sfumato/base/color_space.hpp"

namespace sfumato::svg_import {
namespace {

/// How far a rectangle reaches beyond the tile that it fills, in texels.
constexpr double kBeyondTile = 4;

/// Returns the luminance of linear light of a byte in each channel.
std::uint8_t linear_luminance(const std::array<double, 256>& linear, const std::uint8_t* rgb) {
  const double light = 0.2126 * linear[rgb[0]] + 0.7152 * linear[rgb[1]] + 0.0722 * linear[rgb[2]];
  return static_cast<std::uint8_t>(std::lround(255 * std::clamp(light, 0.0, 1.0)));
}

/// Returns a rectangle over a tile, whose opacity is the shader 0.
Layer filled_tile(double width, double height) {
  const Vec2 low{-kBeyondTile, -kBeyondTile}, high{width + kBeyondTile, height + kBeyondTile};
  const std::array<Vec2, 5> corners{low, {high.x, low.y}, high, {low.x, high.y}, low};
  Curve curve;
  curve.control_points.push_back(low);
  for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
    for (const double t : {1.0 / 3, 2.0 / 3}) {
      curve.control_points.push_back(lerp(corners[i], corners[i + 1], t));
    }
    curve.control_points.push_back(corners[i + 1]);
  }
  curve.left.color = curve.right.color = {
      ShaderKind::curve_domain, {StopSpace::parameter, {{0, Rgb{1, 1, 1}}}}, 0};
  curve.right.opacity = {ShaderKind::image_domain, {}, 0};
  curve.left.opacity = {ShaderKind::curve_domain, {StopSpace::parameter, {{0, 0.0F}}}, 0};
  Layer layer;
  layer.curves.push_back(std::move(curve));
  return layer;
}

Affine& frame_of(Shader& shader) {
  if (auto* fill = std::get_if<GradientFill>(&shader.paint)) return fill->layer_from_gradient;
  return std::get<Texture>(shader.paint).layer_from_texture;
}

/// Draws an opacity over the grid. The shader is unchanged at the end.
Result<Image> draw_opacity(Context& context, Shader& shader, const svg::TexelGrid& grid,
                           TilePainter painter) {
  Document tile;
  tile.artboard = {{0, 0}, {double(grid.width), double(grid.height)}};
  tile.layers.push_back(filled_tile(grid.width, grid.height));
  tile.stack.push_back(LayerInstance{0, {}, 1, BlendMode::normal});
  const Affine frame = frame_of(shader);
  tile.shaders.push_back(std::move(shader));
  frame_of(tile.shaders[0]) = inverse(grid.frame_from_texture) * frame;
  Result<Image> image = painter(context, tile, grid.width, grid.height);
  shader = std::move(tile.shaders[0]);
  frame_of(shader) = frame;
  return image;
}

/// Returns the texels of the first texture among the factors; else the picture's texels over the
/// box.
svg::TexelGrid grid_for(const Document& document, const std::vector<std::uint32_t>& factors,
                        const Box& box, double units_per_texel, std::size_t most_side) {
  for (const std::uint32_t factor : factors) {
    const auto* texture = std::get_if<Texture>(&document.shaders[factor].paint);
    if (texture && !texture->repeats) {
      return {texture->width, texture->height, texture->layer_from_texture};
    }
  }
  return svg::texel_grid(box, document.artboard.min, units_per_texel,
                         static_cast<int>(std::max<std::size_t>(most_side, 1)));
}

}  // namespace

Status make_opacity(const Context& context, svg::TileUse use, Texture& texture) {
  if (use == svg::TileUse::paint || use == svg::TileUse::luminance_mask) return ok_status();
  std::array<double, 256> linear{};
  for (std::size_t i = 0; i < linear.size(); ++i) {
    linear[i] = linear_from_code(static_cast<double>(i) / 255);
  }
  RarePoll<65536> poll(context);
  for (std::size_t i = 0; i + 3 < texture.rgba.size(); i += 4) {
    if (poll.cancelled()) return context.cancel_status();
    std::uint8_t* texel = &texture.rgba[i];
    if (use == svg::TileUse::inverted_mask) {
      for (int channel = 0; channel < 3; ++channel) {
        texel[channel] = static_cast<std::uint8_t>(255 - texel[channel]);
      }
      continue;
    }
    const bool is_alpha = use == svg::TileUse::alpha_mask;
    std::fill_n(texel, 3, is_alpha ? std::uint8_t{255} : linear_luminance(linear, texel));
  }
  return ok_status();
}

Result<std::optional<Shader>> MaskProducts::draw(Context& context, Document& document,
                                                 const std::vector<std::uint32_t>& factors,
                                                 const Box& box, double units_per_texel,
                                                 const std::optional<TilePainter>& painter,
                                                 TableMemory& memory) {
  const Limits& limits = context.limits;
  const svg::TexelGrid grid =
      grid_for(document, factors, box, units_per_texel, limits.pattern_side);
  const std::size_t texels = grid.count() * factors.size();
  const bool has_room = drawn_ < limits.pattern_tiles &&
                        texels <= limits.pattern_texels - std::min(limits.pattern_texels, texels_);
  if (!painter || !has_room) {
    return std::optional<Shader>{};
  }
  ++drawn_;
  texels_ += texels;
  Texture product{grid.width, grid.height, {}, grid.frame_from_texture, false, {}, {}};
  SFUMATO_TRY(memory.resize(context, product.rgba, 4 * grid.count(), std::uint8_t{255}));
  for (const std::uint32_t factor : factors) {
    SFUMATO_TRY_ASSIGN(const Image& image,
                       draw_opacity(context, document.shaders[factor], grid, *painter));
    if (image.bytes.size() != product.rgba.size()) {
      return make_error(StatusCode::bad_input, "the painter of tiles gave no image of that size");
    }
    for (std::size_t i = 3; i < product.rgba.size(); i += 4) {
      const unsigned scaled = unsigned{product.rgba[i]} * image.bytes[i];
      product.rgba[i] = static_cast<std::uint8_t>((scaled + 127) / 255);
    }
    SFUMATO_TRY(context.check());
  }
  const std::string& id = document.shaders[factors.front()].id;
  return std::optional<Shader>(Shader{id.empty() ? "" : id + "-masked", std::move(product)});
}

}  // namespace sfumato::svg_import
