#include "sfumato/export/html/html.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "base/charge.hpp"
#include "base/large_vector.hpp"
#include "base/public_verb.hpp"
#include "codecs/base64.hpp"
#include "codecs/data_uri_write.hpp"
#include "display/embedded.hpp"
#include "document/rules.hpp"
#include "export/html/html_text.hpp"
#include "export/html/viewer_payload.hpp"

namespace sfumato {
namespace {

using display::embedded_file;
using outputs::condensed;
using outputs::escaped_html;

/// In the order in which they stand in the page; main.js begins.
constexpr std::string_view kScripts[] = {"affine.js",   "bytes.js",   "mesh.js",     "field.js",
                                         "gl.js",       "paints.js",  "segments.js", "payload.js",
                                         "layers.js",   "strokes.js", "targets.js",  "painter.js",
                                         "renderer.js", "view.js",    "motion.js",   "input.js",
                                         "controls.js", "paper.js",   "viewer.js",   "main.js"};

constexpr std::string_view kShaders[] = {"common.glsl",         "paint.glsl",   "patch.vert",
                                         "patch.frag",          "screen.vert",  "composite.frag",
                                         "present.frag",        "stroke.vert",  "stroke.frag",
                                         "stroke_resolve.frag", "overlay.vert", "overlay.frag"};

std::string scripts() {
  std::string text;
  for (std::string_view name : kScripts) text += condensed(display::embedded_file(name));
  return text;
}

std::string shaders() {
  std::string text;
  for (std::string_view name : kShaders) {
    text += "<script type=\"text/plain\" data-shader=\"" + std::string(name) + "\">" +
            condensed(display::embedded_file("shaders/" + std::string(name))) + "</script>\n";
  }
  return text;
}

bool is_media_type(std::string_view type) {
  return type.starts_with("image/") && std::all_of(type.begin(), type.end(), [](char c) {
           return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '/' || c == '+' ||
                  c == '-' || c == '.';
         });
}

Result<std::string> fallback(const Context& context, const HtmlOptions& options) {
  std::string text;
  if (options.fallback.empty()) return text;
  text = "<img id=\"fallback\" alt=\"" + escaped_html(options.title) + "\" src=\"";
  Status status = codecs::append_data_uri(context, options.fallback_type, options.fallback, text);
  if (!status) return status;
  return text += "\">";
}

/// The page with its marks, {{name}}, replaced; what replaces them is not looked through.
Result<std::vector<std::uint8_t>> filled(
    const Context& context, std::string_view page,
    const std::array<std::pair<std::string_view, std::string>, 6>& values) {
  std::size_t bytes = page.size();
  for (const auto& [key, value] : values) bytes += value.size();
  std::vector<std::uint8_t> file;
  file.reserve(bytes);
  while (true) {
    const std::size_t begin = page.find("{{");
    const std::string_view before = page.substr(0, begin);
    file.insert(file.end(), before.begin(), before.end());
    if (begin == std::string_view::npos) return file;
    const std::size_t end = page.find("}}", begin);
    const std::string_view name = page.substr(begin + 2, end - begin - 2);
    for (const auto& [key, value] : values) {
      if (key != name) continue;
      if (Status status = append_text(context, value, file); !status) return status;
    }
    page.remove_prefix(end + 2);
  }
}

Rgb background_of(const Picture& picture, const HtmlOptions& options) {
  if (options.background) return *options.background;
  return picture.background.value_or(Rgb{1, 1, 1});
}

Result<std::vector<std::uint8_t>> write(Context& context, const Picture& picture,
                                        const HtmlOptions& options, ExportNotes* notes) {
  if (!options.fallback.empty() && !is_media_type(options.fallback_type))
    return make_error(StatusCode::bad_input, "the fallback picture has no media type of an image");
  if (Status status = rules::check_background(options.background); !status) return status;
  const auto payload = outputs::viewer_payload(context, picture, background_of(picture, options));
  if (!payload) return payload.status();
  ScopedCharge charge;
  // Base64 is a third longer, and stands in a part and in the page.
  const std::size_t bytes =
      3 * (payload->size() + options.fallback.size()) + 16 * options.title.size() + (1 << 20);
  if (Status status = charge.add(context, bytes, "the HTML file"); !status) return status;
  Result<std::string> image = fallback(context, options);
  if (!image) return image.status();
  std::string packed;
  if (Status status = codecs::append_base64(context, *payload, packed); !status) return status;
  if (notes)
    for (const PatchLayer& layer : picture.layers) notes->triangle_count += layer.triangle_count();
  return filled(context, display::embedded_file("page.html"),
                {{{"title", escaped_html(options.title)},
                  {"style", condensed(display::embedded_file("viewer.css"))},
                  {"fallback", std::move(*image)},
                  {"shaders", shaders()},
                  {"payload", std::move(packed)},
                  {"script", scripts()}}});
}

}  // namespace

Result<std::vector<std::uint8_t>> export_html(Context& context, const Picture& picture,
                                              const HtmlOptions& options, ExportNotes* notes) {
  return public_verb(context, [&] { return write(context, picture, options, notes); });
}

}  // namespace sfumato
