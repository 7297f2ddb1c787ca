#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>

#include "base/charge.hpp"
#include "base/parallel.hpp"
#include "base/public_verb.hpp"
#include "base/stopwatch.hpp"
#include "base/try.hpp"
#include "curves/attributes.hpp"
#include "sfumato/trace/trace.hpp"
#include "trace/curves/curve_choice.hpp"
#include "trace/fit/stop_fit.hpp"
#include "trace/image/picture.hpp"

namespace sfumato {
namespace tracing {
namespace {

/// Solutions for colours: as many as radii need, which are improved between the first, and where
/// code values are not linear in the colours.
constexpr int kTurns = 3;
constexpr int kCurvedTurns = 6;
/// Steps of radii where colours stay.
constexpr int kRadiusTurns = 8;
constexpr std::size_t kConvertedValues = 4096;

Status validate(const Context& context, const ColorFit& options) {
  if (options.blur > TraceBlur::sharp) {
    return make_error(StatusCode::bad_input, "an unknown way to find blur radii");
  }
  if (options.max_side < 1 || options.max_side > limits::kImageSide) {
    return make_error(StatusCode::bad_input, "the longer side at which a picture is looked at is " +
                                                 std::to_string(options.max_side) +
                                                 "; it has to be 1 to " +
                                                 std::to_string(limits::kImageSide));
  }
  if (options.keeps_colors && options.blur != TraceBlur::fitted) {
    return make_error(StatusCode::bad_input, "neither colours nor radii are to be fitted");
  }
  return context.check();
}

/// Counts over the layers that are painted.
TraceState count_parts(const Document& drawing) {
  std::vector<std::uint8_t> is_painted(drawing.layers.size());
  for (const StackItem& item : drawing.stack) {
    if (const auto* instance = std::get_if<LayerInstance>(&item)) is_painted[instance->layer] = 1;
  }
  TraceState state;
  state.round_count = 2;
  for (std::size_t i = 0; i < drawing.layers.size(); ++i) {
    if (!is_painted[i]) continue;
    const std::vector<Curve>& curves = drawing.layers[i].curves;
    state.curves += curves.size();
    for (const Curve& curve : curves) state.control_points += curve.control_points.size();
    state.stops += curves::stop_count(curves, StopAttribute::color);
  }
  return state;
}

/// The picture as it looks on the backdrop.
Status lay_on(const Context& context, const Rgb& backdrop, Picture& picture) {
  if (!picture.opacity) return ok_status();
  const float behind[3] = {backdrop.r, backdrop.g, backdrop.b};
  const std::vector<float>& opacity = picture.opacity->value;
  Status status =
      parallel_for(context, opacity.size(), kConvertedValues, [&](std::size_t i, std::size_t end) {
        for (; i < end; ++i) {
          for (std::size_t c = 0; c < 3; ++c) {
            float& code = picture.code[c].value[i];
            code = behind[c] + opacity[i] * (code - behind[c]);
          }
        }
      });
  picture.opacity.reset();
  return status;
}

Status take_turns(const Document& drawing, const ColorFit& options, StopFit& fit) {
  if (options.keeps_colors) {
    for (int turn = 0; turn < kRadiusTurns; ++turn) SFUMATO_TRY(fit.fit_radii());
    return ok_status();
  }
  const bool is_in_srgb = drawing.interpolation == InterpolationSpace::srgb;
  const int turns = is_in_srgb ? kTurns : kCurvedTurns;
  for (int turn = 0; turn < turns; ++turn) {
    if (turn > 0 && turn < kTurns && options.blur == TraceBlur::fitted) {
      SFUMATO_TRY(fit.fit_radii());
    }
    SFUMATO_TRY(turn > 0 && !is_in_srgb ? fit.improve_colors() : fit.fit_colors());
  }
  return ok_status();
}

Result<Document> fit(Context& context, const Document& drawing, const Image& image,
                     const ColorFit& options, TraceStats* stats) {
  const Stopwatch watch;
  TraceState state = count_parts(drawing);
  if (state.stops == 0) {
    return make_error(StatusCode::bad_input, "no curve that is painted has colours to be fitted");
  }
  ScopedCharge charge;
  SFUMATO_TRY(charge.add(context, bytes_of(drawing), "the fitted drawing"));
  SFUMATO_TRY_ASSIGN(auto&& picture, look_at(context, image, options.max_side, true));
  const Rgb backdrop = drawing.background.value_or(Rgb{1, 1, 1});
  SFUMATO_TRY(lay_on(context, backdrop, picture));
  StopFit fit(context, picture, drawing, options.only);
  SFUMATO_TRY(fit.prepare(backdrop, options.seed));
  const double psnr_before = fit.psnr_db(), seconds_before = watch.seconds();
  SFUMATO_TRY(take_turns(drawing, options, fit));
  Document fitted = drawing;
  SFUMATO_TRY(fit.write(fitted));
  SFUMATO_TRY(fit.look_at(fitted));
  const bool is_better = fit.psnr_db() > psnr_before;
  if (stats) {
    *stats = {};
    stats->scale = picture.scale;
    state.psnr_db = psnr_before;
    state.seconds = seconds_before;
    stats->rounds.push_back(state);
    state.round = 1;
    state.psnr_db = std::max(fit.psnr_db(), psnr_before);
    state.seconds = watch.seconds();
    stats->rounds.push_back(state);
  }
  return is_better ? std::move(fitted) : drawing;
}

}  // namespace
}  // namespace tracing

Result<Document> fit_colors(Context& context, const Document& drawing, const Image& picture,
                            const ColorFit& options, TraceStats* stats) {
  return public_verb(context, [&]() -> Result<Document> {
    SFUMATO_TRY(tracing::validate(context, options));
    SFUMATO_TRY(validate(context.limits, picture));
    SFUMATO_TRY(validate(context, drawing));
    SFUMATO_TRY(tracing::check_curves(context, drawing, options.only));
    return tracing::fit(context, drawing, picture, options, stats);
  });
}

}  // namespace sfumato
