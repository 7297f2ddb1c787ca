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

using outputs::escaped_html;

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

/// Appends what replaces the mark {{name}} of the page.
void append_part(const Context& context, std::string_view name, const HtmlOptions& options,
                 std::span<const std::uint8_t> payload, OutputBuffer& page) {
  if (name == "title") page += escaped_html(options.title);
  if (name == "fallback") append_fallback(context, options, page);
  if (name == "payload") codecs::append_base64(context, payload, page);
}

/// Returns the page with its marks replaced. Marks in the replacements are not replaced.
Result<std::vector<std::uint8_t>> filled(const Context& context, const HtmlOptions& options,
                                         std::span<const std::uint8_t> payload) {
  OutputBuffer page(context, "the HTML file");
  std::string_view rest = display::page_text("page.html");
  for (std::size_t begin; (begin = rest.find("{{")) != std::string_view::npos;) {
    page += rest.substr(0, begin);
    const std::size_t end = rest.find("}}", begin);
    const std::string_view name = rest.substr(begin + 2, end - begin - 2);
    append_part(context, name, options, payload, page);
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
