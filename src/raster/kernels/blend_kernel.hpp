#pragma once

#include "raster/kernels/color_space_kernel.hpp"
#include "raster/kernels/tile.hpp"

/// Blending of W3C Compositing and Blending Level 1, sections 5, 10.1 and 10.2, on code values in
/// [0, 1]. Cb is the backdrop, Cs the source, as in that document. Compiled for every instruction
/// set.
namespace sfumato::raster::inline SFUMATO_ISA {

template <int W>
SFUMATO_INLINE Lanes<W> screen(const Lanes<W>& b, const Lanes<W>& s) {
  return b + s - b * s;
}

template <int W>
SFUMATO_INLINE Lanes<W> hard_light(const Lanes<W>& b, const Lanes<W>& s) {
  using F = Lanes<W>;
  const F twice = s + s;
  return select(s <= F(0.5f), b * twice, screen(b, twice - F(1)));
}

template <int W>
SFUMATO_INLINE Lanes<W> color_dodge(const Lanes<W>& b, const Lanes<W>& s) {
  using F = Lanes<W>;
  const F quotient = select(s < F(1), min(b / (F(1) - s), F(1)), F(1));
  return zero_unless(b > F(0), quotient);
}

template <int W>
SFUMATO_INLINE Lanes<W> color_burn(const Lanes<W>& b, const Lanes<W>& s) {
  using F = Lanes<W>;
  const F rest = zero_unless(s > F(0), F(1) - min((F(1) - b) / s, F(1)));
  return select(b < F(1), rest, F(1));
}

template <int W>
SFUMATO_INLINE Lanes<W> soft_light(const Lanes<W>& b, const Lanes<W>& s) {
  using F = Lanes<W>;
  const F twice = s + s - F(1);
  const F d = select(b <= F(0.25f), ((F(16) * b - F(12)) * b + F(4)) * b, sqrt(b));
  return b + twice * select(s <= F(0.5f), b * (F(1) - b), d - b);
}

/// Returns B(Cb, Cs) of the separable modes.
template <int W, BlendMode kMode>
SFUMATO_INLINE Lanes<W> separable(const Lanes<W>& b, const Lanes<W>& s) {
  if constexpr (kMode == BlendMode::multiply) return b * s;
  if constexpr (kMode == BlendMode::screen) return screen(b, s);
  if constexpr (kMode == BlendMode::overlay) return hard_light(s, b);
  if constexpr (kMode == BlendMode::darken) return min(b, s);
  if constexpr (kMode == BlendMode::lighten) return max(b, s);
  if constexpr (kMode == BlendMode::color_dodge) return color_dodge(b, s);
  if constexpr (kMode == BlendMode::color_burn) return color_burn(b, s);
  if constexpr (kMode == BlendMode::hard_light) return hard_light(b, s);
  if constexpr (kMode == BlendMode::soft_light) return soft_light(b, s);
  if constexpr (kMode == BlendMode::difference) return abs(b - s);
  if constexpr (kMode == BlendMode::exclusion) return b + s - Lanes<W>(2) * b * s;
  return s;
}

template <int W>
SFUMATO_INLINE Lanes<W> luminosity_of(const Rgb3<W>& c) {
  using F = Lanes<W>;
  return F(0.3f) * c.r + F(0.59f) * c.g + F(0.11f) * c.b;
}

template <int W>
SFUMATO_INLINE Lanes<W> least(const Rgb3<W>& c) {
  return min(c.r, min(c.g, c.b));
}

template <int W>
SFUMATO_INLINE Lanes<W> greatest(const Rgb3<W>& c) {
  return max(c.r, max(c.g, c.b));
}

/// Returns center + (c - center) scale.
template <int W>
SFUMATO_INLINE Rgb3<W> scaled_about(const Rgb3<W>& c, const Lanes<W>& center,
                                    const Lanes<W>& scale) {
  return {center + (c.r - center) * scale, center + (c.g - center) * scale,
          center + (c.b - center) * scale};
}

/// Computes SetLum with its ClipColor.
template <int W>
SFUMATO_INLINE Rgb3<W> with_luminosity(const Rgb3<W>& c, const Lanes<W>& luminosity) {
  using F = Lanes<W>;
  const F shift = luminosity - luminosity_of(c);
  const Rgb3<W> moved{c.r + shift, c.g + shift, c.b + shift};
  const F center = luminosity_of(moved);
  const F low = least(moved);
  const F high = greatest(moved);
  const F from_below = select(low < F(0), center / (center - low), F(1));
  const F from_above = select(high > F(1), (F(1) - center) / (high - center), F(1));
  return scaled_about(scaled_about(moved, center, from_below), center, from_above);
}

/// Computes SetSat: the least channel becomes 0, the greatest `saturation`, the other stays in
/// proportion.
template <int W>
SFUMATO_INLINE Rgb3<W> with_saturation(const Rgb3<W>& c, const Lanes<W>& saturation) {
  using F = Lanes<W>;
  const F low = least(c);
  const F range = greatest(c) - low;
  const F scale = zero_unless(range > F(0), saturation / range);
  return {(c.r - low) * scale, (c.g - low) * scale, (c.b - low) * scale};
}

template <int W>
SFUMATO_INLINE Lanes<W> saturation_of(const Rgb3<W>& c) {
  return greatest(c) - least(c);
}

template <int W, BlendMode kMode>
SFUMATO_INLINE Rgb3<W> blended(const Rgb3<W>& b, const Rgb3<W>& s) {
  if constexpr (kMode == BlendMode::hue)
    return with_luminosity(with_saturation(s, saturation_of(b)), luminosity_of(b));
  else if constexpr (kMode == BlendMode::saturation)
    return with_luminosity(with_saturation(b, saturation_of(s)), luminosity_of(b));
  else if constexpr (kMode == BlendMode::color)
    return with_luminosity(s, luminosity_of(b));
  else if constexpr (kMode == BlendMode::luminosity)
    return with_luminosity(b, luminosity_of(s));
  else
    return {separable<W, kMode>(b.r, s.r), separable<W, kMode>(b.g, s.g),
            separable<W, kMode>(b.b, s.b)};
}

/// Premultiplied colour and alpha of W pixels.
template <int W>
struct Rgba {
  Rgb3<W> color;
  Lanes<W> alpha;
};

template <int W>
SFUMATO_INLINE Rgba<W> load_pixels(const Tile& tile, std::size_t offset) {
  using F = Lanes<W>;
  return {{F::load(tile.color[0] + offset), F::load(tile.color[1] + offset),
           F::load(tile.color[2] + offset)},
          tile.alpha ? F::load(tile.alpha + offset) : F(1)};
}

template <int W>
SFUMATO_INLINE Rgb3<W> unpremultiplied(const Rgba<W>& pixel) {
  const auto divided = [&](const Lanes<W>& c) {
    return zero_unless(pixel.alpha > Lanes<W>(0), min(c / pixel.alpha, Lanes<W>(1)));
  };
  return {divided(pixel.color.r), divided(pixel.color.g), divided(pixel.color.b)};
}

/// Clamps a pixel. Values painted directly into a tile may be out of range.
template <int W>
SFUMATO_INLINE Rgba<W> in_range(const Rgba<W>& pixel) {
  const auto clamped = [&](const Lanes<W>& c) { return min(max(c, Lanes<W>(0)), pixel.alpha); };
  return {{clamped(pixel.color.r), clamped(pixel.color.g), clamped(pixel.color.b)}, pixel.alpha};
}

/// Computes source-over of the section "advanced compositing": αo co = αs (1 − αb) Cs + αs αb B(Cb,
/// Cs) + (1 − αs) αb Cb, αo = αs + αb (1 − αs).
template <int W, BlendMode kMode>
SFUMATO_INLINE Rgba<W> composited(const Rgba<W>& source, const Rgba<W>& backdrop) {
  using F = Lanes<W>;
  const F clear = F(1) - source.alpha;
  const auto over = [&](const F& s, const F& b) { return s + b * clear; };
  Rgb3<W> top = source.color;
  if constexpr (kMode != BlendMode::normal) {
    const Rgb3<W> mixed = blended<W, kMode>(unpremultiplied(backdrop), unpremultiplied(source));
    const F both = source.alpha * backdrop.alpha;
    const F alone = F(1) - backdrop.alpha;
    top = {top.r * alone + both * mixed.r, top.g * alone + both * mixed.g,
           top.b * alone + both * mixed.b};
  }
  return {
      {over(top.r, backdrop.color.r), over(top.g, backdrop.color.g), over(top.b, backdrop.color.b)},
      over(source.alpha, backdrop.alpha)};
}

template <int W>
SFUMATO_INLINE void store_part(const Lanes<W>& value, int count, float* target) {
  if (count >= W) return value.store(target);
  float all[W];
  value.store(all);
  for (int i = 0; i < count; ++i) target[i] = all[i];
}

template <int W, BlendMode kMode>
SFUMATO_INLINE void blend_rows(const Tile& source, float opacity, const Tile& target) {
  using F = Lanes<W>;
  const F scale(opacity);
  for (int row = 0; row < source.height; ++row) {
    const std::size_t begin = static_cast<std::size_t>(row) * kTileStride;
    for (int x = 0; x < source.width; x += W) {
      const std::size_t at = begin + static_cast<std::size_t>(x);
      Rgba<W> top = in_range(load_pixels<W>(source, at));
      top = {{top.color.r * scale, top.color.g * scale, top.color.b * scale}, top.alpha * scale};
      const Rgba<W> result = composited<W, kMode>(top, in_range(load_pixels<W>(target, at)));
      const int count = source.width - x;
      store_part(result.color.r, count, target.color[0] + at);
      store_part(result.color.g, count, target.color[1] + at);
      store_part(result.color.b, count, target.color[2] + at);
      if (target.alpha) store_part(result.alpha, count, target.alpha + at);
    }
  }
}

template <int W>
void blend(const Tile& source, float opacity, BlendMode mode, const Tile& target) {
  switch (mode) {
#define SFUMATO_BLEND(name) \
  case BlendMode::name:     \
    return blend_rows<W, BlendMode::name>(source, opacity, target);
    SFUMATO_BLEND(normal)
    SFUMATO_BLEND(multiply)
    SFUMATO_BLEND(screen)
    SFUMATO_BLEND(overlay)
    SFUMATO_BLEND(darken)
    SFUMATO_BLEND(lighten)
    SFUMATO_BLEND(color_dodge)
    SFUMATO_BLEND(color_burn)
    SFUMATO_BLEND(hard_light)
    SFUMATO_BLEND(soft_light)
    SFUMATO_BLEND(difference)
    SFUMATO_BLEND(exclusion)
    SFUMATO_BLEND(hue)
    SFUMATO_BLEND(saturation)
    SFUMATO_BLEND(color)
    SFUMATO_BLEND(luminosity)
#undef SFUMATO_BLEND
  }
}

/// Converts colours of a layer's patches from the coordinates of `space` to the input of `blend`:
/// code values in [0, 1], premultiplied by the alpha, which is clamped too.
template <int W>
void finish_shading(InterpolationSpace space, const Tile& tile) {
  using F = Lanes<W>;
  for (int row = 0; row < tile.height; ++row) {
    const std::size_t begin = static_cast<std::size_t>(row) * kTileStride;
    for (int x = 0; x < tile.width; x += W) {
      const std::size_t at = begin + static_cast<std::size_t>(x);
      const Rgba<W> pixel = load_pixels<W>(tile, at);
      const F alpha = clamped_unit(pixel.alpha);
      const Rgb3<W> code = clamped_srgb(space, pixel.color);
      const int count = tile.width - x;
      store_part(code.r * alpha, count, tile.color[0] + at);
      store_part(code.g * alpha, count, tile.color[1] + at);
      store_part(code.b * alpha, count, tile.color[2] + at);
      store_part(alpha, count, tile.alpha + at);
    }
  }
}

/// Divides colours by alpha, for images, whose colours are not premultiplied. Opaque pixels are
/// unchanged.
template <int W>
void unpremultiply(const Tile& tile) {
  using F = Lanes<W>;
  for (int row = 0; row < tile.height; ++row) {
    const std::size_t begin = static_cast<std::size_t>(row) * kTileStride;
    for (int x = 0; x < tile.width; x += W) {
      const std::size_t at = begin + static_cast<std::size_t>(x);
      const Rgba<W> pixel = load_pixels<W>(tile, at);
      const Rgb3<W> color = unpremultiplied(pixel);
      const auto opaque = pixel.alpha >= F(1);
      select(opaque, pixel.color.r, color.r).store(tile.color[0] + at);
      select(opaque, pixel.color.g, color.g).store(tile.color[1] + at);
      select(opaque, pixel.color.b, color.b).store(tile.color[2] + at);
    }
  }
}

}  // namespace sfumato::raster::inline SFUMATO_ISA
