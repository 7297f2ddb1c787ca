#include "trace/image/texture.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "base/limit_error.hpp"
#include "base/parallel.hpp"
#include "base/table_memory.hpp"
#include "base/try.hpp"
#include "sfumato/document/build.hpp"
#include "sfumato/solve/diffuse.hpp"
#include "trace/image/drawn_image.hpp"

namespace sfumato::tracing {
namespace {

/// Texels around the picture that repeat the border. A pattern of SVG repeats: without this margin
/// a magnified picture would mix with the opposite border, up to two texels because of the filter.
constexpr int kMargin = 2;

constexpr std::size_t kTextureRows = 16;

/// Below this the picture is seen through.
constexpr float kOpaque = 1 - 1.0f / 512;

/// The colour below, and its opacity.
struct Below {
  double color = 0, opacity = 1;
};

/// How much an opaque colour shows, blended by hard light, on each side of half grey: it shows
/// slope * color + offset there.
struct Line {
  double slope, offset;
  double at(double color) const { return slope * color + offset; }
};

Line darker(const Below& below) {
  return {1 - below.opacity + 2 * below.opacity * below.color, 0};
}
Line lighter(const Below& below) {
  return {1 - below.opacity + 2 * below.opacity * (1 - below.color),
          below.opacity * (2 * below.color - 1)};
}

/// Returns the colour that shows `wanted`.
double blended_to(double wanted, const Below& below) {
  constexpr double kGray = 0.5;
  const Line line = wanted <= darker(below).at(kGray) ? darker(below) : lighter(below);
  if (line.slope <= 0) return kGray;
  return std::clamp((wanted - line.offset) / line.slope, 0.0, 1.0);
}

double shown(double color, const Below& below) {
  return (color <= 0.5 ? darker(below) : lighter(below)).at(color);
}

std::uint8_t to_byte(double value) {
  return static_cast<std::uint8_t>(std::lround(255 * value));
}

/// Square differences, and how many there are.
struct Misses {
  double sum = 0, count = 0;
};

/// Makes the texels of the missing part, and measures the error that remains.
class TextureMaker {
 public:
  TextureMaker(const Picture& picture, const Image& drawn)
      : picture_(picture),
        drawn_(drawn),
        width_(static_cast<std::size_t>(picture.width())),
        height_(static_cast<std::size_t>(picture.height())) {}

  /// mask   the texture of opacity, white where the picture is opaque; null: it is everywhere
  Status make(Context& context, Texture& color, Texture* mask, double& psnr_db);

 private:
  bool is_opaque(std::size_t pixel) const {
    return !picture_.opacity || picture_.opacity->value[pixel] >= kOpaque;
  }
  void fill(std::size_t pixel, std::uint8_t* texel, Misses& misses) const;
  void fill_row(std::size_t row, Texture& color, Texture* mask, Misses& misses) const;

  const Picture& picture_;
  const Image& drawn_;
  std::size_t width_, height_;
};

void TextureMaker::fill(std::size_t pixel, std::uint8_t* texel, Misses& misses) const {
  if (!is_opaque(pixel)) {
    std::fill_n(texel, 3, to_byte(0.5));
    return;
  }
  const double opacity = wide_value(drawn_, pixel, 3);
  for (std::size_t c = 0; c < 3; ++c) {
    const Below below{wide_value(drawn_, pixel, c), opacity};
    const double wanted = picture_.code[c].value[pixel];
    texel[c] = to_byte(blended_to(wanted, below));
    const double miss = shown(texel[c] / 255.0, below) - wanted;
    misses.sum += miss * miss;
    misses.count += 1;
  }
}

/// A row of texels, including the margin.
void TextureMaker::fill_row(std::size_t row, Texture& color, Texture* mask, Misses& misses) const {
  const auto inner = [](std::size_t at, std::size_t count) {
    return std::clamp<std::size_t>(at, kMargin, kMargin + count - 1) - kMargin;
  };
  const auto texels = static_cast<std::size_t>(color.width);
  const bool is_inside = inner(row, height_) + kMargin == row;
  for (std::size_t x = 0; x < texels; ++x) {
    const std::size_t pixel = inner(row, height_) * width_ + inner(x, width_);
    const std::size_t at = 4 * (row * texels + x);
    Misses misses_here;
    fill(pixel, &color.rgba[at], misses_here);
    if (mask && !is_opaque(pixel)) std::fill_n(&mask->rgba[at], 3, std::uint8_t{0});
    if (!is_inside || inner(x, width_) + kMargin != x) continue;
    misses.sum += misses_here.sum;
    misses.count += misses_here.count;
  }
}

Status TextureMaker::make(Context& context, Texture& color, Texture* mask, double& psnr_db) {
  const auto rows = static_cast<std::size_t>(color.height);
  std::vector<Misses> misses;
  TableMemory memory("what a texture misses");
  SFUMATO_TRY(memory.resize(context, misses, rows));
  SFUMATO_TRY(
      try_parallel_for(context, rows, kTextureRows, [&](std::size_t begin, std::size_t end) {
        for (std::size_t row = begin; row < end; ++row) {
          if (context.cancelled()) return context.cancel_status();
          fill_row(row, color, mask, misses[row]);
        }
        return ok_status();
      }));
  Misses all;
  for (const Misses& row : misses) {
    all.sum += row.sum;
    all.count += row.count;
  }
  psnr_db =
      all.sum > 0 ? 10 * std::log10(all.count / all.sum) : std::numeric_limits<double>::infinity();
  return ok_status();
}

/// All white, so that the margin lies around the artboard. Errors: limit (memory), cancelled.
Status white_texture(const Context& context, const Picture& picture, const Box& artboard,
                     TableMemory& memory, Texture& texture) {
  const Vec2 unit{artboard.width() / picture.width(), artboard.height() / picture.height()};
  texture.width = picture.width() + 2 * kMargin;
  texture.height = picture.height() + 2 * kMargin;
  texture.layer_from_texture = {unit.x, 0, 0, unit.y, -kMargin * unit.x, -kMargin * unit.y};
  const std::size_t texels =
      static_cast<std::size_t>(texture.width) * static_cast<std::size_t>(texture.height);
  return memory.resize(context, texture.rgba, 4 * texels, 255);
}

Status check_limits(const Limits& limits, const Picture& picture, std::size_t textures) {
  const std::size_t texels = textures * (static_cast<std::size_t>(picture.width()) + 2 * kMargin) *
                             (static_cast<std::size_t>(picture.height()) + 2 * kMargin);
  if (texels > limits.texels) {
    return make_limit_error(&Limits::texels, "the texture would have " + std::to_string(texels) +
                                                 " texels; the limit is " +
                                                 limit_text(limits, &Limits::texels, "texels"));
  }
  return ok_status();
}

SideShader<Rgb> image_domain_color(std::uint32_t shader) {
  return {.kind = ShaderKind::image_domain, .stops = {}, .shader = shader};
}

/// Returns the layer's rectangle, which has the textures from `shader` on inside.
Curve frame_with(const Box& artboard, std::uint32_t shader, bool has_mask) {
  const auto w = artboard.width(), h = artboard.height();
  Curve frame = polyline({{0, 0}, {w, 0}, {w, h}, {0, h}, {0, 0}});
  frame.right.color = image_domain_color(shader);
  if (has_mask) {
    frame.right.opacity.kind = ShaderKind::image_domain;
    frame.right.opacity.shader = shader + 1;
  }
  return frame;
}

}  // namespace

Status add_texture(Context& context, const Picture& picture, Document& drawing, double& psnr_db) {
  const bool has_mask = picture.opacity.has_value();
  SFUMATO_TRY(check_limits(context.limits, picture, has_mask ? 2 : 1));
  ScopedCharge drawn_charge;
  SFUMATO_TRY_ASSIGN(const Image& drawn,
                     drawn_image(context, drawing, picture.width(), picture.height(),
                                 DiffuseOptions{}.max_error, drawn_charge));
  TableMemory memory("the texture of a trace");
  Texture color, mask;
  SFUMATO_TRY(white_texture(context, picture, drawing.artboard, memory, color));
  if (has_mask) {
    SFUMATO_TRY(white_texture(context, picture, drawing.artboard, memory, mask));
  }
  SFUMATO_TRY(
      TextureMaker(picture, drawn).make(context, color, has_mask ? &mask : nullptr, psnr_db));
  const auto shader = static_cast<std::uint32_t>(drawing.shaders.size());
  drawing.shaders.push_back({"texture", std::move(color)});
  if (has_mask) drawing.shaders.push_back({"texture-opacity", std::move(mask)});
  const std::uint32_t layer = add_layer(drawing, {frame_with(drawing.artboard, shader, has_mask)},
                                        1, BlendMode::hard_light);
  drawing.layers[layer].id = "texture-layer";
  return validate(context, drawing);
}

}  // namespace sfumato::tracing
