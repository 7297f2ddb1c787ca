#include "gpu/table.hpp"

#include <string>

#include "base/try.hpp"

namespace sfumato::gpu {

Result<Table> Table::create(Context& context, const Device& device, const TableFormat& format,
                            std::size_t texels, std::string_view purpose) {
  Table table;
  const std::size_t rows = std::max<std::size_t>((texels + kTableWidth - 1) / kTableWidth, 1);
  if (rows > static_cast<std::size_t>(device.largest_side())) {
    const std::size_t most = kTableWidth * static_cast<std::size_t>(device.largest_side());
    return make_error(StatusCode::limit,
                      std::string(purpose) + ": a table of " + std::to_string(texels) +
                          " entries; the device's textures hold " + std::to_string(most));
  }
  SFUMATO_TRY(table.charge_.add(context, rows * kTableWidth * format.texel_bytes(), purpose));
  table.format_ = format;
  table.texels_ = texels;
  table.texture_ = make_texture();
  glBindTexture(GL_TEXTURE_2D, table.name());
  glTexStorage2D(GL_TEXTURE_2D, 1, format.internal, kTableWidth, static_cast<GLsizei>(rows));
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  return table;
}

void Table::upload(std::size_t first, std::size_t count, const void* channels) const {
  glBindTexture(GL_TEXTURE_2D, texture_.name());
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  const std::size_t rows = count / kTableWidth, rest = count % kTableWidth;
  const auto put = [&](std::size_t row, std::size_t width, std::size_t height, const void* data) {
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, static_cast<GLint>(row), static_cast<GLsizei>(width),
                    static_cast<GLsizei>(height), format_.format, format_.type, data);
  };
  const std::size_t row = first / kTableWidth;
  if (rows > 0) put(row, kTableWidth, rows, channels);
  const auto* bytes = static_cast<const unsigned char*>(channels);
  if (rest > 0) put(row + rows, rest, 1, bytes + rows * kTableWidth * format_.texel_bytes());
}

}  // namespace sfumato::gpu
