#include "import/paint_opacity.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <variant>

#include "base/poll.hpp"
#include "base/try.hpp"

namespace sfumato::svg_import {
namespace {

using Alphas = std::optional<std::variant<GradientFill, Texture>>;

/// Returns whether a gradient has a colour everywhere: only cones leave parts of the plane out.
bool fills_plane(const std::variant<LinearGradient, RadialGradient>& shape) {
  const auto* radial = std::get_if<RadialGradient>(&shape);
  if (!radial) return true;
  const double between = length(radial->focus - radial->center);
  return between + radial->focal_radius <= radial->radius;
}

Result<Alphas> alphas_of(const Context& /*context*/, GradientFill& fill, TableMemory& /*memory*/) {
  const auto is_opaque = [](const GradientStop& stop) { return stop.alpha >= 1; };
  if (fills_plane(fill.shape) && std::ranges::all_of(fill.stops, is_opaque)) return Alphas{};
  GradientFill alphas = fill;
  for (GradientStop& stop : alphas.stops) stop.color = {1, 1, 1};
  for (GradientStop& stop : fill.stops) stop.alpha = 1;
  return Alphas(std::move(alphas));
}

Result<bool> is_opaque_texture(const Context& context, const Texture& texture) {
  RarePoll<65536> poll(context);
  for (std::size_t i = 3; i < texture.rgba.size(); i += 4) {
    if (poll.cancelled()) return context.cancel_status();
    if (texture.rgba[i] != 255) return false;
  }
  return true;
}

/// The alphas of the texture stay: as a colour they weight its texels, so that clear texels do not
/// show beside others.
Result<Alphas> alphas_of(const Context& context, Texture& texture, TableMemory& memory) {
  SFUMATO_TRY_ASSIGN(const bool opaque, is_opaque_texture(context, texture));
  if (opaque) return Alphas{};
  Texture alphas{texture.width,   texture.height, {}, texture.layer_from_texture,
                 texture.repeats, texture.period, {}};
  SFUMATO_TRY(memory.append(context, texture.rgba, alphas.rgba));
  RarePoll<65536> poll(context);
  for (std::size_t i = 0; i + 3 < alphas.rgba.size(); i += 4) {
    if (poll.cancelled()) return context.cancel_status();
    std::fill_n(alphas.rgba.begin() + static_cast<std::ptrdiff_t>(i), 3, std::uint8_t{255});
  }
  return Alphas(std::move(alphas));
}

}  // namespace

Result<std::optional<Shader>> take_alphas(const Context& context, Shader& shader,
                                          TableMemory& memory) {
  SFUMATO_TRY_ASSIGN(
      auto&& alphas,
      std::visit([&](auto& paint) { return alphas_of(context, paint, memory); }, shader.paint));
  if (!alphas) return std::optional<Shader>{};
  const std::string id = shader.id.empty() ? "" : shader.id + "-opacity";
  return std::optional<Shader>(Shader{id, std::move(*alphas)});
}

}  // namespace sfumato::svg_import
