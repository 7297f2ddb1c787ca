#include "lint/hint_list.hpp"

#include <algorithm>

#include "base/output_buffer.hpp"
#include "base/text/json.hpp"

namespace sfumato::lint_detail {
namespace {

void write_place(JsonWriter& json, const Document& document, const Hint& hint) {
  if (hint.layer) {
    json.member("layer", *hint.layer).member("layer_id", document.layers[*hint.layer].id);
  }
  if (hint.curve) {
    json.member("curve", *hint.curve)
        .member("curve_id", document.layers[*hint.layer].curves[*hint.curve].id);
  }
  if (hint.side) json.member("side", *hint.side == CurveSide::left ? "left" : "right");
  if (hint.stack_item) json.member("stack_item", *hint.stack_item);
  if (hint.shader) {
    json.member("shader", *hint.shader).member("shader_id", document.shaders[*hint.shader].id);
  }
  if (hint.at) json.key("at").begin_array().value(hint.at->x).value(hint.at->y).end_array();
}

std::string hint_json(const Document& document, const Hint& hint) {
  JsonWriter json;
  json.begin_object().member("kind", hint_name(hint.kind));
  json.member("severity", is_note(hint.kind) ? "note" : "hint");
  write_place(json, document, hint);
  json.member("message", hint.message).end_object();
  return json.text();
}

}  // namespace

std::size_t count_hints(std::span<const Hint> hints) {
  return static_cast<std::size_t>(
      std::ranges::count_if(hints, [](const Hint& hint) { return !is_note(hint.kind); }));
}

Result<std::vector<std::uint8_t>> hints_json(const Context& context, const std::string& name,
                                             const Document& document,
                                             std::span<const Hint> hints) {
  OutputBuffer text(context, "the list of hints");
  ((text += "{\"file\":") += JsonWriter().value(name).text()) += ",\"hints\":[";
  for (const Hint& hint : hints) {
    if (context.cancelled()) return context.cancel_status();
    if (&hint != hints.data()) text += ',';
    text += hint_json(document, hint);
  }
  ((text += "],\"hint_count\":") += std::to_string(count_hints(hints))) += "}\n";
  return text.finish();
}

}  // namespace sfumato::lint_detail
