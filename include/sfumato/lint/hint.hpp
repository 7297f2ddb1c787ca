#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "sfumato/document/document.hpp"
#include "sfumato/document/stop_place.hpp"

namespace sfumato {

/// The kinds of probable mistakes in a valid document. docs/cli.md ("lint") has the exact
/// conditions.
enum class HintKind : std::uint8_t {
  open_loop,              ///< the ends of a curve nearly meet: colours leak through the gap
  closed_loop,            ///< a note: the side of a closed curve that is its inside
  inside_empty,           ///< the inside of a closed curve has no colour, its outside has one
  no_attribute,           ///< a curve has no colour on either side, or a local curve has no colour
  duplicate,              ///< a curve hides an earlier one with the same control points
  unseen_side,            ///< no ray from the artboard reaches a side's colour or opacity
  outside,                ///< a curve lies wholly outside the artboard
  blur_without_shader,    ///< a side has a blur radius, but neither colour nor opacity
  opacity_without_color,  ///< curves of a layer have opacity, none has a colour: it paints nothing
  empty_layer,            ///< a layer has no curves
  unused_layer,           ///< nothing paints a layer
  unused_shader,          ///< no curve uses a shader
  leak,                   ///< a layer's colours reach the artboard's border all around
  invisible,              ///< an instance or a group has opacity 0, or a local curve alpha 0
  instance_outside,       ///< nothing of an instance shows on the artboard
  one_stop_gradient,      ///< a gradient has one stop: a plain colour would do
  large_texture,          ///< a texture is finer than a picture of 4096 pixels can show
  seam,                   ///< the colours where a smooth closed curve closes differ
  flood,                  ///< a colour fills the artboard through the open side of a closed curve
  crossing,   ///< curves cross so that colours of one leak into the area that the other encloses
  gap,        ///< an end stops shortly before another curve: colours leak through the gap
  overshoot,  ///< an end lies shortly beyond a curve that it crosses: its colours show there
  stroke_radius,  ///< a local curve is too thin to be seen, or covers the whole picture
  stroke_blur     ///< a local curve's blur changes nothing, or leaves neither colour unmixed
};

/// Returns the name of a kind as the command prints it: "open-loop" for HintKind::open_loop.
std::string_view hint_name(HintKind kind);

/// Returns whether hints of this kind only inform and need no change.
bool is_note(HintKind kind);

/// A hint and its place in the document. Indices count from 0; indices that do not apply are empty.
struct Hint {
  HintKind kind;                              ///< the probable mistake
  std::optional<std::uint32_t> layer{};       ///< index into Document::layers
  std::optional<std::uint32_t> curve{};       ///< index into Layer::curves of `layer`
  std::optional<CurveSide> side{};            ///< of `curve`
  std::optional<std::uint32_t> stack_item{};  ///< index into Document::stack
  std::optional<std::uint32_t> shader{};      ///< index into Document::shaders
  std::optional<Vec2> at{};                   ///< the point that `message` names, frame of `layer`
  std::string message{};                      ///< the mistake and its effect
};

/// Returns the place of a hint in words, with ids where there are any: `layer 0 "fish", curve 3
/// "fin", left side`.
std::string place_text(const Document& document, const Hint& hint);

}  // namespace sfumato
