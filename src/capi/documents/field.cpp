#include <algorithm>
#include <utility>
#include <vector>

#include "base/charge.hpp"
#include "base/parallel.hpp"
#include "base/try.hpp"
#include "capi/documents/document.hpp"
#include "capi/documents/field_paints.hpp"
#include "capi/pictures/picture.hpp"
#include "sfumato/base/color_space.hpp"
#include "sfumato/solve/point_evaluator.hpp"
#include "solve/layers/prepare_layer.hpp"

struct sfumato_field {
  sfumato_field(std::shared_ptr<sfumato::capi::Workshop> w, sfumato::PointEvaluator e)
      : workshop(std::move(w)), evaluator(std::move(e)) {}

  std::shared_ptr<sfumato::capi::Workshop> workshop;  ///< first: it outlives the evaluator
  sfumato::PointEvaluator evaluator;
  std::uint32_t layer = 0;
  sfumato::InterpolationSpace interpolation{};
  sfumato::capi::FieldPaints color_paints{}, opacity_paints{};
};

namespace sfumato::capi {
namespace {

/// Points at a time, and numbers of their colours; their memory is small compared with a field.
constexpr std::size_t kBlock = 1 << 14;
constexpr std::size_t kBlockNumbers = 1 << 17;
constexpr std::size_t kPointsPerTask = 1024;

/// Returns the document with the curves of one layer alone, so that only this layer is prepared.
Document with_one_layer(const Document& document, std::uint32_t layer) {
  Document one;
  one.artboard = document.artboard;
  one.interpolation = document.interpolation;
  // If the evaluator sees paints, their weights do not depend on their colours.
  const Shader any{{}, GradientFill{LinearGradient{}, SpreadMethod::pad, {}, {GradientStop{}}}};
  one.shaders.assign(document.shaders.size(), any);
  one.layers.resize(document.layers.size());
  one.layers[layer] = document.layers[layer];
  one.stack = document.stack;
  return one;
}

/// Prepares the paints of the layer's sides. Textures are averaged over a pixel of the instance
/// that enlarges the layer most, as in pictures.
Status prepare_paints(Context& context, const Document& document, const DiffuseOptions& options,
                      sfumato_field& field) {
  const solve::LayerSight sight =
      solve::sight_of_layer(document, field.layer, options.viewport.value_or(document.artboard));
  const double pixel = 1 / (options.pixels_per_unit * sight.scale);
  SFUMATO_TRY_ASSIGN(
      field.color_paints,
      FieldPaints::create(context, document.shaders, field.evaluator.color_shaders(field.layer),
                          document.interpolation, pixel));
  Result<FieldPaints> opacities =
      FieldPaints::create(context, document.shaders, field.evaluator.opacity_shaders(field.layer),
                          InterpolationSpace::srgb, pixel);
  if (opacities) field.opacity_paints = std::move(*opacities);
  return opacities.status();
}

Outcome make_field(sfumato_context* context, const sfumato_document* handle, std::uint32_t layer,
                   const char* text, sfumato_field** out) {
  SFUMATO_TRY(expect_layer(handle, layer));
  const Document& document = handle->document;
  options::Settings settings;
  SFUMATO_TRY(read_solve_options(text, options::kField, settings));
  Context& work = context->workshop->context;
  ScopedCharge charge;
  SFUMATO_TRY(charge.add(work, bytes_of(document), "a document"));
  const Document one = with_one_layer(document, layer);
  const DiffuseOptions options = solve_options(settings, document);
  SFUMATO_TRY_ASSIGN(auto&& evaluator, PointEvaluator::create(work, one, options));
  auto field = std::make_unique<sfumato_field>(context->workshop, std::move(evaluator));
  field->layer = layer;
  field->interpolation = document.interpolation;
  SFUMATO_TRY(prepare_paints(work, document, options, *field));
  *out = field.release();
  return {};
}

/// A block of points and their values.
struct Block {
  std::vector<Vec2> points{};
  std::vector<float> color{}, opacity{};
  std::vector<std::uint8_t> hit{};
};

float clamped(float value) {
  return std::clamp(value, 0.0f, 1.0f);
}

/// Writes the 4 floats of a point that sees colours.
void write_color(const sfumato_field& field, Vec2 point, const float* color, const float* opacity,
                 float* rgba) {
  const Rgb more = field.color_paints.color_at(point, color + 3);
  const Rgb code =
      to_srgb(field.interpolation, {color[0] + more.r, color[1] + more.g, color[2] + more.b});
  rgba[0] = clamped(code.r);
  rgba[1] = clamped(code.g);
  rgba[2] = clamped(code.b);
  rgba[3] = opacity ? clamped(opacity[0] + field.opacity_paints.opacity_at(point, opacity + 1)) : 1;
}

/// Writes 4 floats a point.
Status write_colors(Context& context, const sfumato_field& field, const Block& block, float* rgba) {
  const std::size_t color_width = 3 + field.color_paints.count();
  const std::size_t opacity_width = block.opacity.empty() ? 0 : 1 + field.opacity_paints.count();
  return parallel_for(
      context, block.points.size(), kPointsPerTask, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
          std::fill_n(rgba + 4 * i, 4, 0.0f);
          if (block.hit[i] == 0) continue;
          const float* const opacity =
              opacity_width > 0 ? block.opacity.data() + opacity_width * i : nullptr;
          write_color(field, block.points[i], block.color.data() + color_width * i, opacity,
                      rgba + 4 * i);
        }
      });
}

Status color_block(Context& context, const sfumato_field& field, const double* xy, Block& block) {
  for (std::size_t i = 0; i < block.points.size(); ++i) {
    block.points[i] = {xy[2 * i], xy[2 * i + 1]};
  }
  const std::size_t count = block.points.size();
  block.color.resize((3 + field.color_paints.count()) * count);
  block.hit.resize(count);
  const auto opacity_width =
      static_cast<std::size_t>(field.evaluator.opacity_channels(field.layer));
  block.opacity.resize(opacity_width * count);
  return field.evaluator.evaluate(context, field.layer, block.points, block.color, block.hit,
                                  block.opacity);
}

Outcome colors(Context& context, const sfumato_field* field, const double* xy, std::size_t count,
               float* rgba) {
  if (!field) return bad_usage("NULL given; pass a field");
  if (count > 0 && (!xy || !rgba)) return bad_usage("NULL given; pass points and room");
  if (count > PTRDIFF_MAX / (4 * sizeof(float))) return bad_usage("more points than memory holds");
  if (field->evaluator.color_channels(field->layer) == 0) {  // nothing of the layer shows
    std::fill_n(rgba, 4 * count, 0.0f);
    return {};
  }
  const std::size_t numbers = 4 + field->color_paints.count() + field->opacity_paints.count();
  const std::size_t most = std::clamp<std::size_t>(kBlockNumbers / numbers, 1, kBlock);
  Block block;
  for (std::size_t done = 0; done < count; done += block.points.size()) {
    block.points.resize(std::min(most, count - done));
    SFUMATO_TRY(color_block(context, *field, xy + 2 * done, block));
    SFUMATO_TRY(write_colors(context, *field, block, rgba + 4 * done));
  }
  return {};
}

}  // namespace
}  // namespace sfumato::capi

int32_t sfumato_field_new(sfumato_context* context, const sfumato_document* document,
                          uint32_t layer, const char* options, sfumato_field** field) {
  return sfumato::capi::make(context, field, [&](sfumato::capi::Workshop&) {
    return sfumato::capi::make_field(context, document, layer, options, field);
  });
}

void sfumato_field_free(sfumato_field* field) {
  delete field;
}

int32_t sfumato_field_colors(sfumato_context* context, const sfumato_field* field, const double* xy,
                             size_t point_count, float* rgba) {
  return sfumato::capi::call(context, [&](sfumato::capi::Workshop& workshop) {
    return sfumato::capi::colors(workshop.context, field, xy, point_count, rgba);
  });
}
