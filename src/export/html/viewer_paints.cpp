#include "export/html/viewer_paints.hpp"

#include <algorithm>
#include <bit>
#include <string_view>
#include <variant>
#include <vector>

#include "base/charge.hpp"
#include "base/table_memory.hpp"
#include "base/try.hpp"
#include "codecs/data_uri_write.hpp"
#include "display/paint_table.hpp"

namespace sfumato::outputs {
namespace {

/// The data of a paint besides its values in the table.
enum class PaintFile : std::uint8_t { none, png, jpeg };

/// Browsers turn pictures as their Exif data say; the texture's texels lie as the file has them.
bool may_be_turned(std::span<const std::uint8_t> file) {
  constexpr std::string_view kMark = "Exif";
  return std::search(file.begin(), file.end(), kMark.begin(), kMark.end()) != file.end();
}

void write_file(const Texture& texture, PaintFile type, std::span<const std::uint8_t> file,
                ByteWriter& out) {
  out.u8(static_cast<std::uint8_t>(type));
  out.varint(static_cast<std::uint64_t>(texture.width));
  out.varint(static_cast<std::uint64_t>(texture.height));
  out.counted(file);
}

/// The texture's own file, or its texels as PNG.
Status write_texture(Context& context, const Texture& texture, ByteWriter& out) {
  const std::string_view type = codecs::image_media_type(texture.file);
  if (!type.empty() && !may_be_turned(texture.file)) {
    write_file(texture, type == "image/png" ? PaintFile::png : PaintFile::jpeg, texture.file, out);
    return out.status();
  }
  const auto png = codecs::texture_png(context, texture);
  SFUMATO_TRY(png);
  ScopedCharge held;
  SFUMATO_TRY(held.add(context, capacity_bytes(*png), "a texture's file"));
  write_file(texture, PaintFile::png, *png, out);
  return out.status();
}

std::vector<bool> used_shaders(const Picture& picture) {
  std::vector<bool> is_used(picture.shaders.size());
  for (const PatchLayer& layer : picture.layers) {
    for (const PatchField* field : {&layer.color, &layer.opacity})
      for (std::uint32_t shader : field->shader) is_used[shader] = true;
  }
  return is_used;
}

Status write_values(const Context& context, const std::vector<float>& values, ByteWriter& out) {
  TableMemory memory("the viewer's paints");
  std::vector<std::uint32_t> bits;
  SFUMATO_TRY(memory.resize(context, bits, values.size()));
  std::transform(values.begin(), values.end(), bits.begin(),
                 [](float value) { return std::bit_cast<std::uint32_t>(value); });
  out.varint(values.size() / 4);
  out.planes(bits, sizeof(float));
  return out.status();
}

}  // namespace

Status write_paints(Context& context, const Picture& picture, ByteWriter& out) {
  SFUMATO_TRY_ASSIGN(const display::PaintTable& table,
                     display::make_paint_table(context, picture, display::PaintTexels::counted));
  SFUMATO_TRY(write_values(context, table.values, out));
  out.varint(table.texel_count);
  const std::vector<bool> is_used = used_shaders(picture);
  out.varint(picture.shaders.size());
  for (std::size_t i = 0; i < picture.shaders.size(); ++i) {
    const Affine& m = table.paint_from_layer[i];
    out.varint(table.first_value[i]);
    for (double value : {m.a, m.b, m.c, m.d, m.e, m.f}) out.f64(value);
    const auto* texture = std::get_if<Texture>(&picture.shaders[i].paint);
    if (!texture || !is_used[i]) {
      out.u8(static_cast<std::uint8_t>(PaintFile::none));
      continue;
    }
    SFUMATO_TRY(write_texture(context, *texture, out));
  }
  return out.status();
}

}  // namespace sfumato::outputs
