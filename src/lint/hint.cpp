#include "lint/hint.hpp"

#include <array>

namespace sfumato {
namespace {

constexpr std::array<std::string_view, 17> kNames{"open-loop",
                                                  "closed-loop",
                                                  "inside-empty",
                                                  "no-attribute",
                                                  "duplicate",
                                                  "unseen-side",
                                                  "outside",
                                                  "blur-without-shader",
                                                  "opacity-without-color",
                                                  "empty-layer",
                                                  "unused-layer",
                                                  "unused-shader",
                                                  "leak",
                                                  "invisible",
                                                  "instance-outside",
                                                  "one-stop-gradient",
                                                  "large-texture"};

void append(std::string& text, const char* what, std::uint32_t index, const std::string& id) {
  if (!text.empty()) text += ", ";
  text += what + std::to_string(index);
  if (!id.empty()) text += " \"" + id + '"';
}

}  // namespace

std::string_view hint_name(HintKind kind) {
  return kNames[static_cast<std::size_t>(kind)];
}

bool is_note(HintKind kind) {
  return kind == HintKind::closed_loop;
}

std::string place_text(const Document& document, const Hint& hint) {
  std::string text;
  if (hint.stack_item) {
    const auto* stroke = std::get_if<LocalStroke>(&document.stack[*hint.stack_item]);
    append(text, stroke ? "local curve at stack item " : "stack item ", *hint.stack_item,
           stroke ? stroke->curve.id : std::string());
  }
  if (hint.layer) append(text, "layer ", *hint.layer, document.layers[*hint.layer].id);
  if (hint.curve) {
    append(text, "curve ", *hint.curve, document.layers[*hint.layer].curves[*hint.curve].id);
  }
  if (hint.side) text += *hint.side == CurveSide::left ? ", left side" : ", right side";
  if (hint.shader) append(text, "shader ", *hint.shader, document.shaders[*hint.shader].id);
  return text;
}

}  // namespace sfumato
