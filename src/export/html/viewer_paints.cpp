#include "export/html/viewer_paints.hpp"

#include <algorithm>
#include <bit>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "codecs/data_uri_write.hpp"
#include "display/paint_table.hpp"

namespace sfumato::outputs {
namespace {

/// What a paint has besides its values in the table.
enum class PaintFile : std::uint8_t { none, png, jpeg };

/// Browsers turn pictures as their Exif data say; the texture's texels lie as the file has them.
bool may_be_turned(std::span<const std::uint8_t> file) {
  constexpr std::string_view kMark = "Exif";
  return std::search(file.begin(), file.end(), kMark.begin(), kMark.end()) != file.end();
}

struct TextureFile {
  PaintFile type = PaintFile::png;
  std::vector<std::uint8_t> bytes;
};

Result<TextureFile> file_of(Context& context, const Texture& texture) {
  const std::string_view type = codecs::image_media_type(texture.file);
  if (!type.empty() && !may_be_turned(texture.file))
    return TextureFile{type == "image/png" ? PaintFile::png : PaintFile::jpeg, texture.file};
  auto png = codecs::texture_png(context, texture);
  if (!png) return png.status();
  return TextureFile{PaintFile::png, std::move(*png)};
}

Status write_texture(Context& context, const Texture& texture, ByteWriter& out) {
  const Result<TextureFile> file = file_of(context, texture);
  if (!file) return file.status();
  out.u8(static_cast<std::uint8_t>(file->type));
  out.varint(static_cast<std::uint64_t>(texture.width));
  out.varint(static_cast<std::uint64_t>(texture.height));
  return out.counted_large(context, file->bytes);
}

std::vector<bool> used_shaders(const Picture& picture) {
  std::vector<bool> is_used(picture.shaders.size());
  for (const PatchLayer& layer : picture.layers) {
    for (const PatchField* field : {&layer.color, &layer.opacity})
      for (std::uint32_t shader : field->shader) is_used[shader] = true;
  }
  return is_used;
}

void write_values(const std::vector<float>& values, ByteWriter& out) {
  std::vector<std::uint32_t> bits(values.size());
  std::transform(values.begin(), values.end(), bits.begin(),
                 [](float value) { return std::bit_cast<std::uint32_t>(value); });
  out.varint(values.size() / 4);
  out.planes(bits, sizeof(float));
}

}  // namespace

Status write_paints(Context& context, const Picture& picture, ByteWriter& out) {
  const Result<display::PaintTable> table =
      display::make_paint_table(context, picture, display::PaintTexels::counted);
  if (!table) return table.status();
  write_values(table->values, out);
  out.varint(table->texel_count);
  const std::vector<bool> is_used = used_shaders(picture);
  out.varint(picture.shaders.size());
  for (std::size_t i = 0; i < picture.shaders.size(); ++i) {
    const Affine& m = table->paint_from_layer[i];
    out.varint(table->first_value[i]);
    for (double value : {m.a, m.b, m.c, m.d, m.e, m.f}) out.f64(value);
    const auto* texture = std::get_if<Texture>(&picture.shaders[i].paint);
    if (!texture || !is_used[i]) {
      out.u8(static_cast<std::uint8_t>(PaintFile::none));
      continue;
    }
    if (Status status = write_texture(context, *texture, out); !status) return status;
  }
  return ok_status();
}

}  // namespace sfumato::outputs
