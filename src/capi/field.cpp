#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "base/charge.hpp"
#include "capi/document.hpp"
#include "capi/picture.hpp"
#include "sfumato/base/color_space.hpp"
#include "sfumato/solve/point_evaluator.hpp"

struct sfumato_field {
  sfumato_field(std::shared_ptr<sfumato::capi::Workshop> w, sfumato::PointEvaluator e)
      : workshop(std::move(w)), evaluator(std::move(e)) {}

  std::shared_ptr<sfumato::capi::Workshop> workshop;  ///< first: it outlives the evaluator
  sfumato::PointEvaluator evaluator;
  std::uint32_t layer = 0;
  sfumato::InterpolationSpace interpolation{};
};

namespace sfumato::capi {
namespace {

/// Points at a time: what they take is little beside a field.
constexpr std::size_t kBlock = 1 << 14;

/// The document with the curves of one layer alone, which is all that is prepared then.
Document with_one_layer(const Document& document, std::uint32_t layer) {
  Document one;
  one.artboard = document.artboard;
  one.interpolation = document.interpolation;
  one.layers.resize(document.layers.size());
  one.layers[layer] = document.layers[layer];
  one.stack = document.stack;
  return one;
}

bool bears_paint(const Side& side) {
  return side.color.kind == ShaderKind::image_domain ||
         side.opacity.kind == ShaderKind::image_domain;
}

bool bears_paint(const Curve& curve) {
  return bears_paint(curve.left) || bears_paint(curve.right);
}

Outcome make_field(sfumato_context* context, const sfumato_document* handle, std::uint32_t layer,
                   const char* text, sfumato_field** out) {
  if (!handle) return bad_usage("NULL given, expected a document");
  const Document& document = handle->document;
  if (layer >= document.layers.size()) {
    return bad_usage("there is no layer " + std::to_string(layer));
  }
  options::Settings settings;
  Outcome read = read_solve_options(text, options::kField, settings);
  if (read.code != SFUMATO_OK) return read;
  const auto paints = [](const Curve& curve) { return bears_paint(curve); };
  if (std::ranges::any_of(document.layers[layer].curves, paints)) {
    return make_error(StatusCode::unavailable, "a field of a layer with gradients or textures");
  }
  Context& work = context->workshop->context;
  ScopedCharge charge;
  Status status = charge.add(work, bytes_of(document), "a document");
  if (!status) return status;
  const Document one = with_one_layer(document, layer);
  Result<PointEvaluator> evaluator =
      PointEvaluator::create(work, one, solve_options(settings, document));
  if (!evaluator) return evaluator.status();
  auto field = std::make_unique<sfumato_field>(context->workshop, std::move(*evaluator));
  field->layer = layer;
  field->interpolation = document.interpolation;
  *out = field.release();
  return {};
}

/// A block of points, and what is found there.
struct Block {
  std::vector<Vec2> points{};
  std::vector<float> color{}, opacity{};
  std::vector<std::uint8_t> hit{};
};

float clamped(float value) {
  return std::clamp(value, 0.0f, 1.0f);
}

/// Writes 4 floats a point.
void write_colors(const Block& block, InterpolationSpace space, float* rgba) {
  for (std::size_t i = 0; i < block.points.size(); ++i, rgba += 4) {
    std::fill_n(rgba, 4, 0.0f);
    if (block.hit[i] == 0) continue;
    const float* channel = block.color.data() + 3 * i;
    const Rgb code = to_srgb(space, {channel[0], channel[1], channel[2]});
    rgba[0] = clamped(code.r);
    rgba[1] = clamped(code.g);
    rgba[2] = clamped(code.b);
    rgba[3] = block.opacity.empty() ? 1 : clamped(block.opacity[i]);
  }
}

Status color_block(Context& context, const sfumato_field& field, const double* xy, Block& block) {
  for (std::size_t i = 0; i < block.points.size(); ++i) {
    block.points[i] = {xy[2 * i], xy[2 * i + 1]};
  }
  const std::size_t count = block.points.size();
  block.color.resize(3 * count);
  block.hit.resize(count);
  block.opacity.resize(field.evaluator.opacity_channels(field.layer) > 0 ? count : 0);
  return field.evaluator.evaluate(context, field.layer, block.points, block.color, block.hit,
                                  block.opacity);
}

Outcome colors(Context& context, const sfumato_field* field, const double* xy, std::size_t count,
               float* rgba) {
  if (!field) return bad_usage("NULL given, expected a field");
  if (count > 0 && (!xy || !rgba)) return bad_usage("NULL given, expected points and room");
  if (count > PTRDIFF_MAX / (4 * sizeof(float))) return bad_usage("more points than memory holds");
  if (field->evaluator.color_channels(field->layer) == 0) {  // nothing of the layer shows
    std::fill_n(rgba, 4 * count, 0.0f);
    return {};
  }
  Block block;
  for (std::size_t done = 0; done < count; done += block.points.size()) {
    block.points.resize(std::min(kBlock, count - done));
    Status status = color_block(context, *field, xy + 2 * done, block);
    if (!status) return status;
    write_colors(block, field->interpolation, rgba + 4 * done);
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
