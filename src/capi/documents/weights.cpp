#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "base/parallel.hpp"
#include "base/try.hpp"
#include "capi/documents/document.hpp"
#include "capi/documents/field_paints.hpp"
#include "capi/pictures/picture.hpp"
#include "capi/pictures/view.hpp"
#include "sfumato/base/color_space.hpp"
#include "solve/layers/prepare_layer.hpp"
#include "solve/points/stop_weights.hpp"

struct sfumato_weights {
  sfumato_weights(std::shared_ptr<sfumato::capi::Workshop> w, sfumato::solve::StopWeights s)
      : workshop(std::move(w)), stops(std::move(s)) {}

  std::shared_ptr<sfumato::capi::Workshop> workshop;  ///< first: it outlives the others
  sfumato::solve::StopWeights stops;
  sfumato::StopAttribute attribute{};
  sfumato::capi::FieldPaints paints{};
  std::vector<std::array<std::uint32_t, 3>> column_stop{};  ///< curve, side, stop
  std::vector<float> column_value{};                        ///< channels() to a column
  sfumato::TableMemory memory{"weights of stops"};          ///< of these
  std::shared_ptr<sfumato::capi::Workshop> row_workshop{};  ///< of the last call
  sfumato::solve::WeightRows rows{};
  std::vector<float> paint{};  ///< channels() to a point

  std::uint32_t channels() const { return attribute == sfumato::StopAttribute::color ? 3 : 1; }
};

namespace sfumato::capi {
namespace {

constexpr std::size_t kWeightPointsPerTask = 1024;

/// Calls sink(curve, side, stop_index, value) for each column, where a value is a colour in the
/// space in which the document mixes or an opacity, with as many numbers.
template <class Sink>
void for_each_column(const Document& document, std::uint32_t layer, StopAttribute attribute,
                     Sink&& sink) {
  const std::vector<Curve>& curves = document.layers[layer].curves;
  for (std::uint32_t c = 0; c < curves.size(); ++c) {
    for (const std::uint32_t s : {SFUMATO_LEFT, SFUMATO_RIGHT}) {
      const Side& side = s == SFUMATO_LEFT ? curves[c].left : curves[c].right;
      std::uint32_t stop_index = 0;
      if (attribute == StopAttribute::opacity) {
        if (side.opacity.kind != ShaderKind::curve_domain) continue;
        for (const Stop<float>& at : side.opacity.stops.stops)
          sink(c, s, stop_index++, std::array{at.value});
      } else if (side.color.kind == ShaderKind::curve_domain) {
        for (const Stop<Rgb>& at : side.color.stops.stops) {
          const Rgb color = from_srgb(document.interpolation, at.value);
          sink(c, s, stop_index++, std::array{color.r, color.g, color.b});
        }
      }
    }
  }
}

Status list_columns(const Context& context, const Document& document, std::uint32_t layer,
                    sfumato_weights& weights) {
  const std::size_t count = weights.stops.column_count();
  SFUMATO_TRY(weights.memory.reserve(context, weights.column_stop, count));
  SFUMATO_TRY(weights.memory.reserve(context, weights.column_value, weights.channels() * count));
  for_each_column(
      document, layer, weights.attribute,
      [&](std::uint32_t curve, std::uint32_t side, std::uint32_t stop_index, const auto& value) {
        weights.column_stop.push_back({curve, side, stop_index});
        weights.column_value.insert(weights.column_value.end(), value.begin(), value.end());
      });
  return context.check();
}

Status prepare_paints(Context& context, const Document& document, std::uint32_t layer,
                      const DiffuseOptions& options, sfumato_weights& weights) {
  const solve::LayerSight sight =
      solve::sight_of_layer(document, layer, options.viewport.value_or(document.artboard));
  const double pixel = 1 / (options.pixels_per_unit * sight.scale);
  const InterpolationSpace space =
      weights.attribute == StopAttribute::color ? document.interpolation : InterpolationSpace::srgb;
  SFUMATO_TRY_ASSIGN(weights.paints, FieldPaints::create(context, document.shaders,
                                                         weights.stops.shaders(), space, pixel));
  return ok_status();
}

Outcome make_weights(sfumato_context* context, const sfumato_document* handle, std::uint32_t layer,
                     std::uint32_t attribute, const char* text, sfumato_weights** out) {
  SFUMATO_TRY(expect_layer(handle, layer));
  const Document& document = handle->document;
  if (attribute != SFUMATO_COLOR && attribute != SFUMATO_OPACITY) {
    return bad_usage("weights are those of SFUMATO_COLOR or SFUMATO_OPACITY");
  }
  const auto of = attribute == SFUMATO_COLOR ? StopAttribute::color : StopAttribute::opacity;
  options::Settings settings;
  SFUMATO_TRY(read_solve_options(text, options::kWeights, settings));
  Context& work = context->workshop->context;
  const DiffuseOptions options = solve_options(settings, document);
  SFUMATO_TRY_ASSIGN(auto&& stops, solve::StopWeights::create(work, document, layer, of, options));
  auto weights = std::make_unique<sfumato_weights>(context->workshop, std::move(stops));
  weights->attribute = of;
  SFUMATO_TRY(list_columns(work, document, layer, *weights));
  SFUMATO_TRY(prepare_paints(work, document, layer, options, *weights));
  *out = weights.release();
  return {};
}

/// The sums that paints add at each point.
Status find_paint(Context& context, const sfumato_weights& weights, std::span<const Vec2> points,
                  const solve::WeightRows& rows, std::span<float> paint) {
  const std::size_t shaders = weights.paints.count();
  if (shaders == 0 || rows.paint.empty()) return ok_status();
  return parallel_for(
      context, points.size(), kWeightPointsPerTask, [&](std::size_t i, std::size_t end) {
        for (; i < end; ++i) {
          const float* const weight = rows.paint.data() + shaders * i;
          if (weights.attribute == StopAttribute::opacity) {
            paint[i] = weights.paints.opacity_at(points[i], weight);
            continue;
          }
          const Rgb color = weights.paints.color_at(points[i], weight);
          std::ranges::copy(std::array{color.r, color.g, color.b}, paint.begin() + 3 * i);
        }
      });
}

Outcome find_rows(sfumato_context* context, sfumato_weights* weights, const double* xy,
                  std::size_t count, double negligible) {
  if (!weights) return bad_usage("NULL given; pass weights");
  if (count > 0 && !xy) return bad_usage("NULL given; pass points");
  if (!(negligible >= 0 && negligible <= 1)) {
    return bad_usage("what is negligible is a number from 0 to 1");
  }
  if (count > PTRDIFF_MAX / sizeof(Vec2)) return bad_usage("more points than memory holds");
  Context& work = context->workshop->context;
  TableMemory memory("points");
  std::vector<Vec2> points;
  SFUMATO_TRY(memory.reserve(work, points, count));
  for (std::size_t i = 0; i < count; ++i) points.push_back({xy[2 * i], xy[2 * i + 1]});
  SFUMATO_TRY_ASSIGN(auto&& rows, weights->stops.at(work, points, static_cast<float>(negligible)));
  std::vector<float> paint;
  SFUMATO_TRY(rows.memory.resize(work, paint, weights->channels() * count));
  SFUMATO_TRY(find_paint(work, *weights, points, rows, paint));
  weights->rows = std::move(rows);  // freed before the workshop that holds its charge
  weights->paint = std::move(paint);
  weights->row_workshop = context->workshop;
  return {};
}

sfumato_view weights_table(const sfumato_weights& weights, std::uint32_t table) {
  switch (table) {
    case SFUMATO_ROW_BEGINS:
      return view_of(weights.rows.begin, 1, SFUMATO_U32, sizeof(std::uint32_t));
    case SFUMATO_COLUMNS:
      return view_of(weights.rows.column, 1, SFUMATO_U32, sizeof(std::uint32_t));
    case SFUMATO_WEIGHTS:
      return view_of(weights.rows.weight, 1, SFUMATO_F32, sizeof(float));
    case SFUMATO_COLUMN_STOPS:
      return view_of(weights.column_stop, 3, SFUMATO_U32, sizeof(std::uint32_t));
    case SFUMATO_COLUMN_VALUES:
      return view_of(weights.column_value, weights.channels(), SFUMATO_F32, sizeof(float));
    case SFUMATO_PAINT_VALUES:
      return view_of(weights.paint, weights.channels(), SFUMATO_F32, sizeof(float));
    default:
      return {};
  }
}

}  // namespace
}  // namespace sfumato::capi

int32_t sfumato_weights_new(sfumato_context* context, const sfumato_document* document,
                            uint32_t layer, uint32_t attribute, const char* options,
                            sfumato_weights** weights) {
  return sfumato::capi::make(context, weights, [&](sfumato::capi::Workshop&) {
    return sfumato::capi::make_weights(context, document, layer, attribute, options, weights);
  });
}

void sfumato_weights_free(sfumato_weights* weights) {
  delete weights;
}

int32_t sfumato_weights_at(sfumato_context* context, sfumato_weights* weights, const double* xy,
                           size_t point_count, double negligible) {
  return sfumato::capi::call(context, [&](sfumato::capi::Workshop&) {
    return sfumato::capi::find_rows(context, weights, xy, point_count, negligible);
  });
}

int32_t sfumato_weights_table(const sfumato_weights* weights, uint32_t table, sfumato_view* view) {
  if (view) *view = {};
  if (!weights || !view || table > SFUMATO_PAINT_VALUES) return SFUMATO_BAD_USAGE;
  *view = sfumato::capi::weights_table(*weights, table);
  return SFUMATO_OK;
}
