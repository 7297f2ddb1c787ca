#include "sfumato/lint/hint.hpp"

#include <array>
#include <vector>

namespace sfumato {
namespace {

constexpr std::array<std::string_view, 24> kNames{"open-loop",
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
                                                  "large-texture",
                                                  "seam",
                                                  "flood",
                                                  "crossing",
                                                  "gap",
                                                  "overshoot",
                                                  "stroke-radius",
                                                  "stroke-blur"};

void append(std::string& text, const char* what, std::uint32_t index, const std::string& id) {
  if (!text.empty()) text += ", ";
  text += what + std::to_string(index);
  if (!id.empty()) text += " \"" + id + '"';
}

/// Returns null if a hint of another document names a missing element.
template <class T>
const T* element(const std::vector<T>& list, std::uint32_t index) {
  return index < list.size() ? &list[index] : nullptr;
}

template <class T>
std::string id_of(const T* named) {
  return named ? named->id : std::string();
}

}  // namespace

std::string_view hint_name(HintKind kind) {
  const auto index = static_cast<std::size_t>(kind);
  return index < kNames.size() ? kNames[index] : "unknown";
}

bool is_note(HintKind kind) {
  return kind == HintKind::closed_loop;
}

std::string place_text(const Document& document, const Hint& hint) {
  std::string text;
  if (hint.stack_item) {
    const StackItem* item = element(document.stack, *hint.stack_item);
    const LocalStroke* stroke = item ? std::get_if<LocalStroke>(item) : nullptr;
    append(text, stroke ? "local curve at stack item " : "stack item ", *hint.stack_item,
           stroke ? stroke->curve.id : std::string());
  }
  const Layer* layer = hint.layer ? element(document.layers, *hint.layer) : nullptr;
  if (hint.layer) append(text, "layer ", *hint.layer, id_of(layer));
  if (hint.curve) {
    append(text, "curve ", *hint.curve,
           id_of(layer ? element(layer->curves, *hint.curve) : nullptr));
  }
  if (hint.side) text += *hint.side == CurveSide::left ? ", left side" : ", right side";
  if (hint.shader) {
    append(text, "shader ", *hint.shader, id_of(element(document.shaders, *hint.shader)));
  }
  return text;
}

}  // namespace sfumato
