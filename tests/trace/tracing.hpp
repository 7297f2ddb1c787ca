#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>

#include "sfumato/base/context.hpp"
#include "sfumato/base/image.hpp"
#include "sfumato/formats/read_document.hpp"
#include "sfumato/formats/svg/svg_write.hpp"
#include "sfumato/trace/trace.hpp"
#include "support/draw.hpp"
#include "support/picture_quality.hpp"
#include "support/places.hpp"
#include "support/planes.hpp"
#include "support/scenes.hpp"

namespace sfumato::test {

/// Returns a trace that must succeed and be valid.
inline Document trace_of(const Image& picture, const TraceOptions& options = {},
                         TraceStats* stats = nullptr) {
  Context context;
  Result<Document> drawing = trace(context, picture, options, stats);
  EXPECT_TRUE(drawing.ok()) << to_string(drawing.status());
  if (!drawing) return {};
  const Status status = validate(context, *drawing);
  EXPECT_TRUE(status.ok()) << to_string(status);
  EXPECT_EQ(drawing->artboard.width(), picture.width);
  EXPECT_EQ(drawing->artboard.height(), picture.height);
  return std::move(*drawing);
}

/// Returns the drawing's picture at a size, on a background where it is transparent.
inline Planes look_of(const Document& drawing, int width, int height, Rgb background = {1, 1, 1}) {
  Context context;
  const Result<Image> image = draw(context, drawing, width, height, PixelFormat::rgba16);
  EXPECT_TRUE(image.ok()) << to_string(image.status());
  return image.ok() ? planes_of(*image, background) : Planes{};
}

/// Returns the PSNR of the drawing against the picture.
inline double rendered_psnr_db(const Document& drawing, const Image& picture,
                               Rgb background = {1, 1, 1}) {
  return psnr_db(look_of(drawing, picture.width, picture.height, background),
                 planes_of(picture, background));
}

inline std::size_t point_count(const Document& drawing) {
  std::size_t count = 0;
  for (const Layer& layer : drawing.layers) {
    for (const Curve& curve : layer.curves) count += curve.control_points.size();
  }
  return count;
}

inline std::size_t curve_count(const Document& drawing) {
  std::size_t count = 0;
  for (const Layer& layer : drawing.layers) count += layer.curves.size();
  return count;
}

inline std::string svg_of(const Document& drawing) {
  Context context;
  Result<std::string> text = write_svg(context, drawing);
  EXPECT_TRUE(text.ok()) << to_string(text.status());
  return text.ok() ? std::move(*text) : std::string();
}

inline Document evening() {
  Context context;
  const auto bytes = file_bytes(source_path("examples/evening.xml"));
  Result<ReadDocument> read = read_document(context, bytes.value_or(""), "evening.xml");
  EXPECT_TRUE(read.ok()) << to_string(read.status());
  return read.ok() ? std::move(read->document) : Document{};
}

/// Returns a document as a picture whose longer side has so many pixels.
inline Image picture_of(const Document& document, int longer_side) {
  const double scale =
      longer_side / std::max(document.artboard.width(), document.artboard.height());
  Context context;
  Result<Image> image =
      draw(context, document, static_cast<int>(scale * document.artboard.width() + 0.5),
           static_cast<int>(scale * document.artboard.height() + 0.5), PixelFormat::rgb8);
  EXPECT_TRUE(image.ok()) << to_string(image.status());
  return image.ok() ? std::move(*image) : Image{};
}

}  // namespace sfumato::test
