#include "export/facets/end_bands.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <random>
#include <span>

#include "export/support.hpp"
#include "raster/pictures.hpp"
#include "sfumato/export/pdf/pdf.hpp"
#include "sfumato/formats/svg/svg.hpp"
#include "sfumato/raster/rasterize.hpp"

namespace sfumato::outputs {
namespace {

/// Returns a grid with sides of 64 units whose borders are curves, except the left one, which is
/// the frame's.
PatchLayer open_grid() {
  PatchLayer layer = test::make_layer(
      test::jittered_grid(test::kSquareBox, 8, 4, [](int, int) { return 0; }), [](int, Vec2 p) {
        return Rgb{1, 0.5f, static_cast<float>(p.y / 64)};
      });
  layer.frame = test::kSquareBox;
  Context context;
  const auto edges = find_curve_edges(context, layer);
  for (std::uint32_t h = 0; h < edges->twin.size(); ++h) {
    const Vec2 a = layer.vertex_position[layer.triangle_vertex[h]];
    const Vec2 b = layer.vertex_position[layer.triangle_vertex[next_half_edge(h)]];
    layer.edge_is_curve[h] = edges->twin[h] == kNoHalfEdge && a.x + b.x > 1 ? 1 : 0;
  }
  return layer;
}

TEST(EndBands, colours_go_on_beyond_curves_and_not_beyond_the_frame) {
  const PatchLayer layer = open_grid();
  Context context;
  const auto edges = find_curve_edges(context, layer);
  ASSERT_TRUE(edges.ok());
  EXPECT_TRUE(has_ends(*edges));
  const auto band = make_end_band(context, layer, InterpolationSpace::srgb, {}, *edges, 2);
  ASSERT_TRUE(band.ok());
  double area = 0;
  for (std::size_t i = 0; i < band->facet_vertex.size(); i += 3) {
    Vec2 at[3];
    for (std::size_t k = 0; k < 3; ++k) at[k] = band->vertex_position[band->facet_vertex[i + k]];
    EXPECT_GT(cross(at[1] - at[0], at[2] - at[0]), 0);
    area += cross(at[1] - at[0], at[2] - at[0]) / 2;
  }
  // Three sides, half as wide again under the mesh, and two corners.
  EXPECT_GT(area, 3 * 64 * 3 + 5);
  EXPECT_LT(area, 3 * 64 * 3 + 15);
  for (std::size_t v = 0; v < band->vertex_position.size(); ++v) {
    const Vec2 at = band->vertex_position[v];
    EXPECT_GE(at.x, 0);
    EXPECT_NEAR(band->vertex_value[3 * v + 2], std::clamp(at.y, 0.0, 64.0) / 64, 0.02);
  }
  // A strip with neither bent curve nor bent colours needs few columns.
  EXPECT_LT(band->vertex_position.size(), 40u);
}

TEST(EndBands, the_outline_follows_the_curves_and_leaves_the_frame) {
  const PatchLayer layer = open_grid();
  Context context;
  const auto edges = find_curve_edges(context, layer);
  const auto outline = outline_of_ends(context, layer, *edges, 2);
  ASSERT_TRUE(outline.ok());
  ASSERT_EQ(outline->loop.size(), 1u);
  double area = 0;
  const std::vector<Vec2>& loop = outline->loop[0];
  for (std::size_t i = 0; i < loop.size(); ++i)
    area += cross(loop[i], loop[(i + 1) % loop.size()]) / 2;
  EXPECT_NEAR(area, 64 * 66, 1e-6);
}

TEST(EndBands, a_layer_that_fills_its_frame_has_none) {
  PatchLayer layer = open_grid();
  std::ranges::fill(layer.edge_is_curve, 0);
  Context context;
  const auto edges = find_curve_edges(context, layer);
  EXPECT_FALSE(has_ends(*edges));
  const auto band = make_end_band(context, layer, InterpolationSpace::srgb, {}, *edges, 2);
  ASSERT_TRUE(band.ok());
  EXPECT_TRUE(band->facet_vertex.empty());
}

std::string drawing(const std::string& shapes) {
  return R"(<svg xmlns="http://www.w3.org/2000/svg" xmlns:sf="urn:sfumato:1" sf:version="1"
      viewBox="0 0 100 100"><g sf:diffuse="true">)" +
         shapes + "</g></svg>";
}

struct Viewer {
  const char *program, *command;
  double mean = 0,
         far_percent =
             0;  ///< limits; without bands, the edges below differ by at least 1.9 and 0.8 %
};

constexpr Viewer kViewers[] = {
    {"pdftoppm", "pdftoppm -r 96 -png -singlefile IN OUT && mv OUT.png OUT", 0.7, 0.02},
    {"pdftocairo", "pdftocairo -r 96 -png -singlefile IN OUT && mv OUT.png OUT", 0.1, 0.02},
    {"mutool", "mutool draw -q -r 96 -o OUT IN", 0.2, 0.03},
    {"gs", "gs -q -dSAFER -dBATCH -dNOPAUSE -sDEVICE=png16m -dGraphicsAlphaBits=4 -r96 -o OUT IN",
     1, 0.1}};

/// Calls check(viewer, picture, shown) for the shapes in every installed program.
template <class Check>
void expect_shown(const std::string& shapes, std::span<const Viewer> viewers, const Check& check) {
  SCOPED_TRACE(shapes);
  Context context;
  const auto read = read_svg(context, drawing(shapes), "a.svg");
  ASSERT_TRUE(read) << to_string(read.status());
  const Picture picture = test::solved(read->document);
  const auto pdf = export_pdf(context, picture, {});
  ASSERT_TRUE(pdf.ok());
  for (const Viewer& viewer : viewers) {
    if (!test::has_program(viewer.program)) continue;
    SCOPED_TRACE(viewer.program);
    const auto shown = test::shown_by(*pdf, "in.pdf", viewer.command);
    ASSERT_TRUE(shown);
    check(viewer, picture, *shown);
  }
}

/// Expects smooth borders of shapes that end at `none`.
void expect_smooth(const std::string& shapes) {
  expect_shown(shapes, kViewers,
               [](const Viewer& viewer, const Picture& picture, const Image& shown) {
                 const auto found =
                     test::difference(shown, test::reference(picture, shown.width, shown.height));
                 std::printf("%-10s mean %.2f, more than 64 off: %.3f %%\n", viewer.program,
                             found.mean, found.far_percent);
                 EXPECT_LE(found.mean, viewer.mean);
                 EXPECT_LE(found.far_percent, viewer.far_percent);
               });
}

bool has_any_viewer() {
  return std::ranges::any_of(kViewers,
                             [](const Viewer& v) { return test::has_program(v.program); });
}

TEST(EndBands, an_edge_beside_nothing_is_antialiased) {
  if (!has_any_viewer()) GTEST_SKIP() << "no poppler, MuPDF or Ghostscript here";
  expect_smooth(R"(<circle cx="50" cy="50" r="40" sf:left="none" sf:right="#f00"/>)");
  expect_smooth(R"(<path d="M10 20 L93 31 L72 92 L21 80 Z" sf:left="none" sf:right="#06c"/>)");
  // Its outside is visible, and its inside is not.
  expect_smooth(R"(<circle cx="50" cy="50" r="31" sf:left="#080" sf:right="none"/>)");
}

TEST(EndBands, sharp_corners_and_narrow_gaps_beside_nothing_keep_their_colours) {
  if (!has_any_viewer()) GTEST_SKIP() << "no poppler, MuPDF or Ghostscript here";
  expect_smooth(R"(<path d="M50 5 L60 35 L95 37 L67 55 L80 95 L50 65 L20 95 L32 55 L5 37 L40 35 Z"
      sf:left="none" sf:right="#c00"/>)");
  expect_smooth(R"(<path d="M10 10 L50 12 L49 90 L10 88 Z" sf:left="none" sf:right="#c00"/>
      <path d="M53 10 L90 12 L90 88 L52 90 Z" sf:left="none" sf:right="#00c"/>)");
}

constexpr Viewer kFineViewers[] = {
    {"pdftoppm", "pdftoppm -r 192 -png -singlefile IN OUT && mv OUT.png OUT"},
    {"mutool", "mutool draw -q -r 192 -o OUT IN"}};

/// Returns how many pixels that the layer covers completely show something else, except in the
/// topmost row, where Splash leaves out triangles that begin left of the page.
int gap_count(const Image& shown, const Image& expected) {
  int count = 0;
  for (auto i = static_cast<std::size_t>(expected.width); 4 * i < expected.bytes.size(); ++i) {
    if (expected.bytes[4 * i + 3] != 255) continue;
    int most = 0;
    for (std::size_t c = 0; c < 3; ++c)
      most = std::max(most, std::abs(shown.bytes[3 * i + c] - expected.bytes[4 * i + c]));
    if (most > 60) ++count;
  }
  return count;
}

void expect_no_gaps(const std::string& shapes) {
  expect_shown(shapes, kFineViewers, [](const Viewer&, const Picture& picture, const Image& shown) {
    RasterOptions options;
    options.width = shown.width;
    options.height = shown.height;
    options.format = PixelFormat::rgba8;
    Context context;
    const auto expected = rasterize(context, picture, options);
    ASSERT_TRUE(expected.ok());
    ASSERT_EQ(shown.bytes.size() / 3, expected->bytes.size() / 4);
    EXPECT_EQ(gap_count(shown, *expected), 0);
  });
}

std::string red_beside_none(const std::string& path) {
  return "<path d=\"" + path + R"(" sf:left="none" sf:right="#f00"/>)";
}

bool has_fine_viewer() {
  return test::has_program("pdftoppm") || test::has_program("mutool");
}

TEST(EndBands, no_pixel_stays_free_between_band_and_mesh) {
  if (!has_fine_viewer()) GTEST_SKIP() << "no poppler or MuPDF here";
  expect_no_gaps(red_beside_none("M50 50L-30 40V120Z") + red_beside_none("M100 0L60 30L120 40Z"));
  expect_no_gaps(red_beside_none("M-20 -20H150V150H-20Z") +
                 R"(<path d="M40 40V60H60V40Z" sf:left="none" sf:right="#00f"/>)");
}

TEST(EndBands, no_pixel_stays_free_at_triangles_and_rectangles) {
  if (!has_fine_viewer()) GTEST_SKIP() << "no poppler or MuPDF here";
  std::mt19937 random(1);
  const auto between = [&](int least, int most) {
    return least + static_cast<int>(random() % static_cast<unsigned>(most - least));
  };
  for (int i = 0; i < 12; ++i) {
    std::string triangle = "M";
    for (int k = 0; k < 6; ++k) triangle += std::to_string(between(-40, 140)) + ' ';
    expect_no_gaps(red_beside_none(triangle + "Z"));

    const int width = between(20, 80), height = between(20, 80);
    const int left = between(0, 100) - width, top = between(0, 100) - height;
    const std::string size =
        std::to_string(2 * width) + R"(" height=")" + std::to_string(2 * height);
    const std::string turn = std::to_string(15 * i) + " 50 50)";
    expect_no_gaps("<rect x=\"" + std::to_string(left) + R"(" y=")" + std::to_string(top) +
                   R"(" width=")" + size + R"(" transform="rotate()" + turn +
                   R"(" sf:left="none" sf:right="#f00"/>)");
  }
}

}  // namespace
}  // namespace sfumato::outputs
