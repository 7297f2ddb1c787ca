#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "codecs/deflate.hpp"
#include "codecs/image_file.hpp"
#include "codecs/photo/photo.hpp"
#include "formats/photo_files.hpp"
#include "limits/large_inputs.hpp"
#include "sfumato/api/render_pixels.hpp"
#include "sfumato/base/limits.hpp"
#include "sfumato/codecs/jpeg_encode.hpp"
#include "sfumato/codecs/png.hpp"
#include "sfumato/codecs/webp_encode.hpp"
#include "sfumato/export/glb/glb.hpp"
#include "sfumato/export/html/html.hpp"
#include "sfumato/export/pdf/pdf.hpp"
#include "sfumato/export/svg/svg.hpp"
#include "sfumato/export/tables/tables.hpp"
#include "sfumato/formats/read_document.hpp"
#include "sfumato/formats/svg/svg_write.hpp"
#include "sfumato/import/import_svg.hpp"
#include "sfumato/lint/lint.hpp"
#include "sfumato/raster/rasterize.hpp"
#include "support/poll_gap.hpp"

/// No work runs for long without a poll, in any stage, and after the flag is set all of it ends as
/// soon. On one thread, whose CPU time is measured. poll_gap.hpp defines the limit.
/// bench/poll_gaps.cpp measures the same with inputs near the limits.
namespace sfumato::test {
namespace {

/// Runs `work` to its end. Returns its longest gap, CPU seconds, and counts its polls.
template <class Work>
double longest_gap(const std::string& name, const Work& work, std::uint64_t& polls) {
  Context context;
  PollRecorder recorder;
  context.poll_watch = &recorder;
  recorder.start();
  const auto result = work(context);
  recorder.stop();
  EXPECT_TRUE(result.ok()) << name << ": " << result.status().message;
  EXPECT_EQ(context.budget.used(), 0u) << name;
  polls = recorder.polls();
  return recorder.longest_seconds();
}

/// Cancels `work` at a poll. Returns the CPU seconds until its end.
template <class Work>
double seconds_to_end(const std::string& name, const Work& work, std::uint64_t poll) {
  Context cancelled;
  PollRecorder until;
  until.cancel_at = poll;
  until.cancel = &cancelled.cancel;
  cancelled.poll_watch = &until;
  until.start();
  {
    const auto stopped = work(cancelled);
    EXPECT_EQ(stopped.status().code, StatusCode::cancelled) << name;
  }
  const double end = thread_seconds();
  EXPECT_EQ(cancelled.budget.used(), 0u) << name;
  return end - until.cancelled_at();
}

/// Runs `work` to its end, then again, cancelled half way through its polls.
template <class Work>
void expect_polls(const std::string& name, Work work) {
  expect_short_gaps(name, [&] {
    std::uint64_t polls = 0;
    const double gap = longest_gap(name, work, polls);
    return std::max(gap, seconds_to_end(name, work, polls / 2 + 1));
  });
}

TEST(Polls, readers_look_often) {
  const std::string svg = many_curves_svg(20'000), orzan = many_curves_orzan(10'000);
  const std::string path = long_path_svg(200'000);
  for (const std::string* text : {&svg, &orzan, &path}) {
    expect_polls(text->substr(0, 9),
                 [&](Context& c) { return read_document(c, *text, "drawing"); });
  }
}

std::string svg_of(const std::string& content) {
  return R"(<svg xmlns="http://www.w3.org/2000/svg" xmlns:sf="urn:sfumato:1" viewBox="0 0 64 64">)"
         R"(<g sf:diffuse="true">)" +
         content + "</g></svg>";
}

TEST(Polls, long_values_are_read_and_written_with_looks) {
  std::string transforms, points;
  for (int i = 0; i < 1'000'000; ++i) transforms += "scale(1)";
  for (int i = 0; i < 1'000'000; ++i) points += std::to_string(i % 64) + ' ';
  const std::string transformed =
      svg_of("<path d='M0 0L9 9' sf:left='red' transform='" + transforms + "'/>");
  const std::string polygon = svg_of("<polygon sf:left='red' points='" + points + "'/>");
  for (const std::string* text : {&transformed, &polygon}) {
    expect_polls("reading", [&](Context& c) { return read_document(c, *text, "a.svg"); });
  }
  Context context;
  const auto read = read_document(context, polygon, "a.svg");
  ASSERT_TRUE(read.ok());
  expect_polls("writing", [&](Context& c) { return write_svg(c, read->document); });
}

/// A fifth of the largest input. The XML parser reads it in one piece, without a poll; half of the
/// largest input takes up to 46 ms on a quiet machine.
TEST(Polls, tens_of_millions_of_blanks_or_digits_are_read_with_looks) {
  const std::size_t most = limits::kInputBytes / 5;
  const std::string blanks(most, ' ');
  std::string numbers;
  for (int i = 0; i < 20; ++i) numbers += "0." + std::string((1 << 20) - 3, '1') + ' ';
  const std::string shapes[] = {
      "<path sf:left='red' d='M0 0L9 " + blanks + "9'/>",
      "<path sf:left='red' d='M0 0L" + numbers + "'/>",
      "<polygon sf:left='red' points='0 0 9 9 9 0" + blanks + "'/>",
      "<path d='M0 0L9 9' sf:left='red' transform='" + blanks + "scale(1)'/>",
      "<rect sf:left='red' width='3' height='3' x='" + blanks + "1'/>",
      "<path d='M0 0L9 9' sf:left='red' sf:opacity='" + blanks + "1'/>",
  };
  for (const std::string& shape : shapes) {
    const std::string text = svg_of(shape);
    expect_polls(shape.substr(0, 48), [&](Context& c) { return read_document(c, text, "a.svg"); });
  }
}

TEST(Polls, solving_looks_often) {
  const Document curves = many_curves(500);
  expect_polls("curves", [&](Context& c) { return diffuse(c, curves, {.max_error = 0}); });
  const DiffuseOptions for_pixels{.max_error = 40, .pixel_grid = true};
  expect_polls("curves for pixels", [&](Context& c) { return diffuse(c, curves, for_pixels); });
  const DiffuseOptions fine{.max_area_fraction = 2e-4, .max_error = 0};
  const Document few = many_curves(10);
  expect_polls("triangles", [&](Context& c) { return diffuse(c, few, fine); });
  const DiffuseOptions in_rounds{.max_area_fraction = 2e-5};
  expect_polls("rounds", [&](Context& c) { return diffuse(c, few, in_rounds); });
}

TEST(Polls, imports_of_many_shapes_look_often) {
  for (const ShapePlaces places :
       {ShapePlaces::apart, ShapePlaces::on_ground, ShapePlaces::overlapping}) {
    const std::string text = many_shapes_svg(1'000, places);
    expect_polls(name_of(places), [&](Context& c) { return import_svg(c, text, "shapes.svg"); });
  }
}

TEST(Polls, one_node_that_sees_thousands_of_colours_looks_often) {
  const Document stops = curve_of_many_stops(1000);
  expect_polls("stops", [&](Context& c) {
    return render_pixels(c, stops, {}, {.width = 16, .height = 16});
  });
}

TEST(Polls, rasters_look_often) {
  Context context;
  const Result<Picture> picture = diffuse(context, many_curves(100), {.max_error = 0});
  ASSERT_TRUE(picture.ok());
  expect_polls(
      "wide", [&](Context& c) { return rasterize(c, *picture, {.width = 16'384, .height = 256}); });
  const Result<Picture> strokes = diffuse(context, many_strokes(50, 3000), {});
  ASSERT_TRUE(strokes.ok());
  expect_polls("strokes",
               [&](Context& c) { return rasterize(c, *strokes, {.width = 512, .height = 512}); });
}

TEST(Polls, codecs_look_often) {
  Context context;
  const Image image = noise_image(1500, 1500);
  expect_polls("PNG", [&](Context& c) { return encode_png(c, image); });
  expect_polls("JPEG", [&](Context& c) { return encode_jpeg(c, image, 90); });
  // With noise, libwebp's own passes take longer.
  const Result<Picture> picture = diffuse(context, many_curves(20), {});
  ASSERT_TRUE(picture.ok());
  const auto smooth = rasterize(context, *picture, {.width = 1500, .height = 1500});
  ASSERT_TRUE(smooth.ok());
  expect_polls("WebP", [&](Context& c) { return encode_webp(c, *smooth, {}); });
  const auto png = encode_png(context, image);
  const auto jpeg = encode_jpeg(context, image, 90);
  ASSERT_TRUE(png.ok() && jpeg.ok());
  expect_polls("PNG back", [&](Context& c) { return codecs::decode_image(c, *png); });
  expect_polls("JPEG back", [&](Context& c) { return codecs::decode_image(c, *jpeg); });
  const Bytes photo = with_exif(with_profile(*jpeg, display_p3_profile()), exif_of(6));
  expect_polls("photo", [&](Context& c) { return codecs::read_photo(c, photo, "a.jpg"); });
  const auto webp = encode_webp(context, *smooth, {});
  ASSERT_TRUE(webp.ok());
  expect_polls("WebP back", [&](Context& c) { return codecs::read_photo(c, *webp, "a.webp"); });
}

TEST(Polls, exporters_look_often) {
  Context context;
  const Document document = many_curves(1000);
  const Result<Picture> picture = diffuse(context, document, {.max_error = 0});
  ASSERT_TRUE(picture.ok());
  expect_polls("GLB", [&](Context& c) { return export_glb(c, *picture, {}); });
  expect_polls("NPZ", [&](Context& c) { return export_npz(c, *picture); });
  expect_polls("JSON", [&](Context& c) { return export_json(c, *picture); });
  expect_polls("PLY", [&](Context& c) { return export_ply(c, *picture); });
  expect_polls("HTML", [&](Context& c) { return export_html(c, *picture, {}); });
  expect_polls("PDF", [&](Context& c) { return export_pdf(c, *picture, {}); });
  expect_polls("SVG", [&](Context& c) {
    return export_svg(c, *picture, {.mode = SvgMode::vector, .force = true});
  });
  expect_polls("SVG of curves", [&](Context& c) { return write_svg(c, document); });
  expect_polls("lint", [&](Context& c) { return lint(c, document); });
}

TEST(Polls, packing_bytes_of_two_values_looks_often) {
  std::vector<std::uint8_t> bytes(std::size_t{1} << 17);
  std::uint32_t noise = 1;
  for (std::uint8_t& byte : bytes) {
    noise = noise * 1'664'525 + 1'013'904'223;
    byte = noise >> 24 & 1;
  }
  expect_polls("deflate", [&](Context& c) {
    TableMemory memory("packed bytes");
    return codecs::deflated(c, bytes, memory);
  });
}

TEST(Polls, exporters_of_large_textures_look_often) {
  Context context;
  const Document document = textured_curve(2500);
  const Result<Picture> picture = diffuse(context, document, {});
  ASSERT_TRUE(picture.ok());
  expect_polls("GLB", [&](Context& c) { return export_glb(c, *picture, {}); });
  expect_polls("HTML", [&](Context& c) { return export_html(c, *picture, {}); });
  expect_polls("PDF", [&](Context& c) { return export_pdf(c, *picture, {}); });
  expect_polls("SVG of curves", [&](Context& c) { return write_svg(c, document); });
}

}  // namespace
}  // namespace sfumato::test
