#include "trace/image/missing.hpp"

#include <cstddef>

#include "base/parallel.hpp"
#include "base/try.hpp"
#include "trace/curves/drawing.hpp"
#include "trace/image/drawn_image.hpp"

namespace sfumato::tracing {
namespace {

/// The error of patches in code values of 255, far below an error that is worth a curve.
constexpr double kMaxError = 4;
/// Pixels of one task.
constexpr std::size_t kMissingPixelsPerTask = 4096;

Result<Image> draw(Context& context, const Picture& picture, std::span<const TracedCurve> curves,
                   bool has_opacity, ScopedCharge& charge) {
  const Vec2 size{static_cast<double>(picture.width()), static_cast<double>(picture.height())};
  return drawn_image(context, drawing_of(curves, size, {1, 1}, has_opacity), picture.width(),
                     picture.height(), kMaxError, charge);
}

Status subtract(Context& context, const Picture& picture, const Image& drawn, std::size_t channel,
                Plane& missing) {
  const auto* opacity = picture.opacity ? &picture.opacity->value : nullptr;
  return parallel_for(
      context, missing.value.size(), kMissingPixelsPerTask, [&](std::size_t i, std::size_t end) {
        for (; i < end; ++i) {
          const float own = opacity ? (*opacity)[i] : 1.0f;
          missing.value[i] =
              channel < 3 ? own * (picture.code[channel].value[i] - wide_value(drawn, i, channel))
                          : own - wide_value(drawn, i, channel);
        }
      });
}

}  // namespace

Status find_missing(Context& context, const Picture& picture, std::span<const TracedCurve> curves,
                    TableMemory& memory, std::vector<Plane>& missing) {
  missing.resize(picture.opacity ? 4 : 3);
  for (Plane& plane : missing) {
    SFUMATO_TRY(make_plane(context, picture.width(), picture.height(), memory, plane));
  }
  // Colours count without their opacity: even where almost nothing is seen, they guide curves.
  ScopedCharge charge;
  Result<Image> drawn = draw(context, picture, curves, false, charge);
  SFUMATO_TRY(drawn);
  Status status;
  for (std::size_t c = 0; c < 3 && status; ++c) {
    status = subtract(context, picture, *drawn, c, missing[c]);
  }
  if (!status || !picture.opacity) return status;
  drawn = Image{};
  charge = {};
  drawn = draw(context, picture, curves, true, charge);
  return drawn ? subtract(context, picture, *drawn, 3, missing[3]) : drawn.status();
}

}  // namespace sfumato::tracing
