#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "sfumato/document/document.hpp"

namespace sfumato {

/// What a document may have got wrong without being invalid. docs/cli.md defines each.
enum class HintKind : std::uint8_t {
  open_loop,
  closed_loop,  ///< a note: which side is inside
  inside_empty,
  no_attribute,
  duplicate,
  unseen_side,
  outside,
  blur_without_shader,
  opacity_without_color,
  empty_layer,
  unused_layer,
  unused_shader,
  leak,
  invisible,
  instance_outside,
  one_stop_gradient,
  large_texture,
  seam,
  flood,
  crossing,
  gap,
  overshoot,
  stroke_radius,
  stroke_blur
};

/// "open-loop".
std::string_view hint_name(HintKind kind);

/// Whether it asks for nothing.
bool is_note(HintKind kind);

enum class CurveSide : std::uint8_t { left, right };

/// One hint and its place in the document; indices count from 0.
struct Hint {
  HintKind kind;
  std::optional<std::uint32_t> layer{};       ///< index into Document::layers
  std::optional<std::uint32_t> curve{};       ///< of the layer
  std::optional<CurveSide> side{};            ///< of the curve
  std::optional<std::uint32_t> stack_item{};  ///< index into Document::stack
  std::optional<std::uint32_t> shader{};      ///< index into Document::shaders
  std::string message{};                      ///< what is odd and what it means
};

/// `layer 0 "fish", curve 3 "fin", left side`; ids where there are any.
std::string place_text(const Document& document, const Hint& hint);

}  // namespace sfumato
