#include "sfumato/export/html/html.hpp"

#include <algorithm>
#include <span>
#include <string_view>

#include "base/charge.hpp"
#include "base/output_buffer.hpp"
#include "base/public_verb.hpp"
#include "base/table_memory.hpp"
#include "base/try.hpp"
#include "codecs/base64.hpp"
#include "codecs/data_uri_write.hpp"
#include "codecs/deflate.hpp"
#include "display/embedded.hpp"
#include "document/rules.hpp"
#include "export/html/html_text.hpp"
#include "export/html/viewer_payload.hpp"

namespace sfumato {
namespace {

using display::embedded_file;
using outputs::condensed;
using outputs::escaped_html;
using outputs::script_of_module;
using outputs::squeezed;

/// The scripts in the page's order: each script comes after the scripts that it imports; main.js
/// begins.
constexpr std::string_view kScripts[] = {
    "affine.js",       "bytes.js",        "mesh.js",        "field.js",        "gl.js",
    "tables.js",       "paints.js",       "segments.js",    "payload.js",      "layer_tables.js",
    "layers.js",       "strokes.js",      "targets.js",     "exact_fields.js", "exact_mesh.js",
    "exact_refine.js", "exact_tables.js", "exact_scene.js", "exact_work.js",   "exact.js",
    "painter.js",      "renderer.js",     "view.js",        "motion.js",       "input.js",
    "controls.js",     "paper.js",        "viewer.js",      "main.js"};

constexpr std::string_view kShaders[] = {
    "common.glsl",      "paint.glsl",          "patch.vert",       "patch.frag",
    "screen.vert",      "composite.frag",      "present.frag",     "stroke.vert",
    "stroke.frag",      "stroke_resolve.frag", "overlay.vert",     "overlay.frag",
    "edges.frag",       "exact.glsl",          "point_walk.glsl",  "exact.frag",
    "exact_place.vert", "exact_place.frag",    "exact_edges.vert", "exact_copy.frag"};

std::string scripts() {
  std::string text;
  for (std::string_view name : kScripts)
    text += squeezed(script_of_module(condensed(display::embedded_file(name))));
  return text;
}

/// Name and text of each script, each ended by a zero byte, in zlib's format.
Status append_shaders(const Context& context, OutputBuffer& page) {
  std::string text;
  for (const std::string_view name : kShaders) {
    text += std::string(name) + '\0';
    text += condensed(display::embedded_file("shaders/" + std::string(name))) + '\0';
  }
  TableMemory memory("the viewer's shaders");
  const auto* const bytes = reinterpret_cast<const std::uint8_t*>(text.data());
  const auto packed = codecs::deflated(context, {bytes, text.size()}, memory);
  if (packed) codecs::append_base64(context, *packed, page);
  return packed.status();
}

bool is_media_type(std::string_view type) {
  return type.starts_with("image/") && std::all_of(type.begin(), type.end(), [](char c) {
           return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '/' || c == '+' ||
                  c == '-' || c == '.';
         });
}

void append_fallback(const Context& context, const HtmlOptions& options, OutputBuffer& page) {
  if (options.fallback.empty()) return;
  page += "<img id=\"fallback\" alt=\"" + escaped_html(options.title) + "\" src=\"";
  codecs::append_data_uri(context, options.fallback_type, options.fallback, page);
  page += "\">";
}

/// The text that replaces the mark {{name}} of the page.
Status append_part(const Context& context, std::string_view name, const HtmlOptions& options,
                   std::span<const std::uint8_t> payload, OutputBuffer& page) {
  if (name == "title") page += escaped_html(options.title);
  if (name == "style") page += condensed(display::embedded_file("viewer.css"));
  if (name == "fallback") append_fallback(context, options, page);
  if (name == "shaders") return append_shaders(context, page);
  if (name == "payload") codecs::append_base64(context, payload, page);
  if (name == "script") page += scripts();
  return ok_status();
}

/// Returns the page with its marks replaced. Marks in the replacements are not replaced.
Result<std::vector<std::uint8_t>> filled(const Context& context, const HtmlOptions& options,
                                         std::span<const std::uint8_t> payload) {
  OutputBuffer page(context, "the HTML file");
  std::string_view rest = display::embedded_file("page.html");
  for (std::size_t begin; (begin = rest.find("{{")) != std::string_view::npos;) {
    page += rest.substr(0, begin);
    const std::size_t end = rest.find("}}", begin);
    const std::string_view name = rest.substr(begin + 2, end - begin - 2);
    SFUMATO_TRY(append_part(context, name, options, payload, page));
    rest.remove_prefix(end + 2);
  }
  page += rest;
  return page.finish();
}

void note_triangles(const Picture& picture, ExportNotes* notes) {
  if (!notes) return;
  for (const PatchLayer& layer : picture.layers) notes->triangle_count += layer.triangle_count();
}

/// Packs the picture's data for the page in zlib's format.
Result<std::vector<std::uint8_t>> packed_payload(Context& context, const Picture& picture,
                                                 const std::optional<Rgb>& background,
                                                 TableMemory& memory) {
  SFUMATO_TRY(rules::check_background(background));
  SFUMATO_TRY_ASSIGN(
      const auto& payload,
      outputs::viewer_payload(context, picture, outputs::viewer_background(picture, background)));
  ScopedCharge held;
  SFUMATO_TRY(held.add(context, capacity_bytes(payload), "the viewer's payload"));
  return codecs::deflated(context, payload, memory);
}

Result<std::vector<std::uint8_t>> write(Context& context, const Picture& picture,
                                        const HtmlOptions& options, ExportNotes* notes) {
  if (!options.fallback.empty() && !is_media_type(options.fallback_type))
    return make_error(StatusCode::bad_input, "the fallback picture has no media type of an image");
  TableMemory memory("the viewer's payload");
  SFUMATO_TRY_ASSIGN(const auto& payload,
                     packed_payload(context, picture, options.background, memory));
  note_triangles(picture, notes);
  return filled(context, options, payload);
}

}  // namespace

Result<std::vector<std::uint8_t>> export_html(Context& context, const Picture& picture,
                                              const HtmlOptions& options, ExportNotes* notes) {
  return public_verb(context, [&] { return write(context, picture, options, notes); });
}

Result<std::vector<std::uint8_t>> export_sfv(Context& context, const Picture& picture,
                                             const SfvOptions& options, ExportNotes* notes) {
  return public_verb(context, [&]() -> Result<std::vector<std::uint8_t>> {
    TableMemory memory("the viewer's payload");
    auto payload = packed_payload(context, picture, options.background, memory);
    if (payload) note_triangles(picture, notes);
    return payload;
  });
}

}  // namespace sfumato
