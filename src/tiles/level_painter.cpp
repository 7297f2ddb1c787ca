#include "tiles/level_painter.hpp"

#include <cstring>
#include <utility>

#include "base/try.hpp"

namespace sfumato::tiles {

Status LevelPainter::prepare(const Pyramid& pyramid, int level) {
  if (level == level_) return ok_status();
  prepared_.reset();
  level_ = -1;
  RasterOptions options = raster_;
  options.width = pyramid.level_width(level);
  options.height = pyramid.level_height(level);
  SFUMATO_TRY_ASSIGN(auto&& made, PreparedRaster::create(context_, picture_, options));
  prepared_.emplace(std::move(made));
  level_ = level;
  return ok_status();
}

Result<const Image*> LevelPainter::paint(const Pyramid& pyramid, int level, const PixelRect& rect) {
  SFUMATO_TRY(prepare(pyramid, level));
  image_.format = raster_.format;
  image_.width = rect.x1 - rect.x0;
  image_.height = rect.y1 - rect.y0;
  const std::size_t bytes = image_.row_bytes() * static_cast<std::size_t>(image_.height);
  SFUMATO_TRY(memory_.resize(context_, image_.bytes, bytes));
  // Progress counts the pyramid as a whole.
  Progress* const progress = std::exchange(context_.progress, nullptr);
  const Status status = prepared_->paint(context_, rect.x0, rect.y0, image_.width, image_.height,
                                         image_.bytes.data(), image_.row_bytes());
  context_.progress = progress;
  if (!status) return status;
  return &image_;
}

void copy_part(const Image& image, int x, int y, Image& tile) {
  const std::size_t pixel = image.row_bytes() / static_cast<std::size_t>(image.width);
  for (int row = 0; row < tile.height; ++row) {
    const std::uint8_t* from = image.bytes.data() +
                               image.row_bytes() * static_cast<std::size_t>(y + row) +
                               pixel * static_cast<std::size_t>(x);
    std::memcpy(tile.bytes.data() + tile.row_bytes() * static_cast<std::size_t>(row), from,
                tile.row_bytes());
  }
}

}  // namespace sfumato::tiles
