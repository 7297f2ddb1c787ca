// Pictures as PDF in programs that show PDF, compared with our raster. ViewerLimits are slightly
// above the measured values. Ghostscript antialiases only on request.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "export/support.hpp"
#include "sfumato/export/pdf/pdf.hpp"
#include "sfumato/formats/svg/svg.hpp"
#include "support/random_document.hpp"
#include "support/scenes.hpp"
#include "support/soak.hpp"

namespace sfumato {
namespace {

using test::Bytes;

struct Viewer {
  std::string program, command;
};

const Viewer kSplash{"pdftoppm", "pdftoppm -r 96 -png -singlefile IN OUT && mv OUT.png OUT"};
const Viewer kCairo{"pdftocairo", "pdftocairo -r 96 -png -singlefile IN OUT && mv OUT.png OUT"};
const Viewer kMuPdf{"mutool", "mutool draw -q -r 96 -o OUT IN"};
const Viewer kGhostscript{"gs",
                          "gs -q -dSAFER -dBATCH -dNOPAUSE -sDEVICE=png16m -dGraphicsAlphaBits=4 "
                          "-r96 -o OUT IN"};

Bytes pdf_of(const Picture& picture) {
  Context context;
  Result<Bytes> bytes = export_pdf(context, picture, {});
  EXPECT_TRUE(bytes.ok()) << to_string(bytes.status());
  return bytes ? std::move(*bytes) : Bytes{};
}

/// Largest mean and 99th percentile of the differences, code values, and the share of channels that
/// differ by more than 64, which is large for an aliased edge.
struct ViewerLimits {
  double mean;
  int p99;
  double far_percent = 100;
};

void expect_shown(const Picture& picture, const Bytes& pdf, const Viewer& viewer,
                  const ViewerLimits& limits) {
  if (!test::has_program(viewer.program)) {
    std::printf("no %s here: skipped\n", viewer.program.c_str());
    return;
  }
  const auto shown = test::shown_by(pdf, "in.pdf", viewer.command);
  ASSERT_TRUE(shown) << viewer.program;
  const auto found =
      test::difference(*shown, test::reference(picture, shown->width, shown->height));
  std::printf("%-10s mean %.2f p99 %d, more than 64 off: %.3f %%\n", viewer.program.c_str(),
              found.mean, found.p99, found.far_percent);
  EXPECT_LE(found.mean, limits.mean) << viewer.program;
  EXPECT_LE(found.p99, limits.p99) << viewer.program;
  EXPECT_LE(found.far_percent, limits.far_percent) << viewer.program;
}

void expect_valid(const Bytes& pdf) {
  if (!test::has_program("qpdf")) return;
  const test::Said said = test::said_of(pdf, "in.pdf", "qpdf --check IN");
  EXPECT_EQ(said.exit_code, 0) << said.text;
}

/// Compares one document in all programs; limits in the order Splash, cairo, MuPDF, Ghostscript.
/// Splash is the slowest: some drawings take twice as long as in all the others together. These run
/// in Splash only in `make soak`.
void expect_shown_everywhere(const Document& document, const ViewerLimits (&limits)[4],
                             bool is_slow_in_splash = false) {
  const Picture picture = test::solved(document);
  const Bytes pdf = pdf_of(picture);
  std::printf("%zu bytes\n", pdf.size());
  expect_valid(pdf);
  const Viewer* viewers[] = {&kSplash, &kCairo, &kMuPdf, &kGhostscript};
  for (std::size_t i = is_slow_in_splash && !test::is_soak() ? 1 : 0; i < 4; ++i) {
    expect_shown(picture, pdf, *viewers[i], limits[i]);
  }
}

bool has_any_program() {
  return test::has_program("qpdf") || test::has_program("pdftoppm") ||
         test::has_program("mutool") || test::has_program("gs");
}

#define SKIP_WITHOUT_PROGRAMS() \
  if (!has_any_program()) GTEST_SKIP() << "no qpdf, poppler, MuPDF or Ghostscript here"

TEST(PdfInViewers, the_lady_bug) {
  SKIP_WITHOUT_PROGRAMS();
  const auto document = test::shared_scene("lady_bug.xml");
  if (!document) GTEST_SKIP() << "no public scene lady_bug.xml";
  expect_shown_everywhere(*document,
                          {{0.8, 7, 0.03}, {0.6, 6, 0.03}, {0.9, 9, 0.1}, {0.8, 11, 0.03}});
}

TEST(PdfInViewers, the_apple) {
  SKIP_WITHOUT_PROGRAMS();
  if (const auto document = test::example("apple.svg"))
    expect_shown_everywhere(
        *document, {{2.1, 15, 0.03}, {0.6, 6, 0.03}, {1.4, 14, 0.03}, {1.3, 13, 0.03}}, true);
}

TEST(PdfInViewers, blurred_curves_and_clipped_frames) {
  SKIP_WITHOUT_PROGRAMS();
  if (const auto document = test::example("blur.svg"))
    expect_shown_everywhere(*document, {{3.5, 65}, {1, 14, 0.01}, {1.5, 19, 0.05}, {0.8, 7, 0.05}});
}

TEST(PdfInViewers, textures) {
  SKIP_WITHOUT_PROGRAMS();
  if (const auto document = test::example("textures.svg"))
    expect_shown_everywhere(*document, {{8, 75}, {2, 14}, {6, 58}, {6, 60}});
}

TEST(PdfInViewers, local_curves) {
  SKIP_WITHOUT_PROGRAMS();
  if (const auto document = test::example("strokes.svg"))
    expect_shown_everywhere(*document, {{3, 33}, {0.7, 9}, {2.5, 28}, {3, 31}});
}

TEST(PdfInViewers, the_fish) {
  SKIP_WITHOUT_PROGRAMS();
  if (const auto document = test::example("fish.svg"))
    expect_shown_everywhere(*document, {{2.1, 25}, {0.7, 8}, {2, 25}, {1.3, 19}});
}

/// Returns processor time, seconds, of ended child processes, because other programs must not
/// count.
double seconds_of_programs() {
  rusage used{};
  getrusage(RUSAGE_CHILDREN, &used);
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  return seconds(used.ru_utime) + seconds(used.ru_stime);
}

/// As triangles, its hundred fishes would take several minutes. The export takes as long as two
/// flowers.
TEST(PdfInViewers, the_fish_is_open_in_splash_as_soon_as_eight_flowers) {
  if (!test::has_program(kSplash.program) || !test::has_program("prlimit"))
    GTEST_SKIP() << "no pdftoppm or prlimit here";
  const auto flower = test::example("flower.svg"), fish = test::example("fish.svg");
  if (!flower || !fish) return;
  const double begin = seconds_of_programs();
  ASSERT_TRUE(test::shown_by(pdf_of(test::solved(*flower)), "in.pdf", kSplash.command));
  const double most = std::ceil(8 * (seconds_of_programs() - begin));
  EXPECT_TRUE(test::shown_by(pdf_of(test::solved(*fish)), "in.pdf",
                             "prlimit --cpu=" + std::to_string(int(most)) + " " + kSplash.command));
}

/// Opacity by a gradient ends at the circle, and so does the gradient's image.
TEST(PdfInViewers, opacity_by_a_paint_leaves_no_dark_pixels_where_it_ends) {
  if (!test::has_program("mutool")) GTEST_SKIP() << "no mutool here";
  Context context;
  const auto read = read_svg(context, R"svg(<svg xmlns="http://www.w3.org/2000/svg"
      xmlns:sf="urn:sfumato:1" viewBox="0 0 200 150" sf:version="1"><defs>
      <linearGradient id="fade" gradientUnits="userSpaceOnUse" x1="0" y1="0" x2="200" y2="0">
      <stop stop-color="#fff" stop-opacity="0"/><stop offset="1" stop-color="#fff"/>
      </linearGradient></defs><g sf:diffuse="true"><circle cx="60" cy="75" r="45"
      sf:left-opacity="0" sf:right-opacity="url(#fade)" sf:left="#000" sf:right="#000"/></g>
      </svg>)svg",
                             "a.svg");
  ASSERT_TRUE(read) << to_string(read.status());
  const auto shown = test::shown_by(pdf_of(test::solved(read->document)), "in.pdf",
                                    "mutool draw -q -r 192 -o OUT IN");
  ASSERT_TRUE(shown);
  // The circle is darkest where the gradient has 105 of its 200 units.
  EXPECT_GE(*std::min_element(shown->bytes.begin(), shown->bytes.end()), 255 - 255 * 105 / 200 - 4);
}

TEST(PdfInViewers, everything_that_documents_can_hold_is_valid) {
  if (!test::has_program("qpdf")) GTEST_SKIP() << "no qpdf here";
  const auto last = test::random_case_count<std::uint64_t>(5, 12);
  for (std::uint64_t seed = 1; seed <= last; ++seed) {
    SCOPED_TRACE(seed);
    expect_valid(pdf_of(test::solved(test::random_document(seed))));
  }
}

}  // namespace
}  // namespace sfumato
