// Every allocation of every public function is refused in turn. README.md explains the counts.
#include <gtest/gtest.h>

#include <cstring>
#include <map>
#include <optional>
#include <span>

#include "allocation/documents.hpp"
#include "allocation/every_allocation.hpp"
#include "base/no_throw.hpp"
#include "base/parallel.hpp"
#include "codecs/photo/photo.hpp"
#include "formats/image_files.hpp"
#include "formats/photo_files.hpp"
#include "sfumato/api/render_pixels.hpp"
#include "sfumato/base/native/file.hpp"
#include "sfumato/base/native/thread_pool.hpp"
#include "sfumato/codecs/jpeg_encode.hpp"
#include "sfumato/codecs/png.hpp"
#include "sfumato/codecs/webp_encode.hpp"
#include "sfumato/export/eps/eps.hpp"
#include "sfumato/export/glb/glb.hpp"
#include "sfumato/export/html/html.hpp"
#include "sfumato/export/pdf/pdf.hpp"
#include "sfumato/export/svg/svg.hpp"
#include "sfumato/export/tables/tables.hpp"
#include "sfumato/formats/read_document.hpp"
#include "sfumato/formats/svg/svg_write.hpp"
#include "sfumato/lint/lint.hpp"
#include "sfumato/picture/picture_file.hpp"
#include "sfumato/raster/rasterize.hpp"
#include "sfumato/solve/diffuse.hpp"
#include "sfumato/solve/solution.hpp"
#include "sfumato/trace/trace.hpp"
#include "support/same_document.hpp"
#include "support/sanitizers.hpp"
#include "support/soak.hpp"
#include "support/temporary_folder.hpp"

namespace sfumato::test {
namespace {

/// Makes a value while no allocation is refused.
template <class Make>
auto made(const Make& make) {
  Context context;
  auto result = make(context);
  EXPECT_TRUE(result.ok()) << to_string(result.status());
  return std::move(*result);
}

Document document_of(const std::string& text) {
  return made([&](Context& context) { return read_document(context, text, "a.svg"); }).document;
}

Picture picture_of(const Document& document, const DiffuseOptions& options = {}) {
  return made([&](Context& context) { return diffuse(context, document, options); });
}

template <class Value>
void append(std::string& text, const std::vector<Value>& values) {
  text.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(Value));
}

/// Returns a text that distinguishes results.
std::string digest(const ReadDocument& read) {
  std::string text = made([&](Context& context) { return write_svg(context, read.document); });
  for (const Diagnostic& warning : read.warnings) text += to_string(warning) + '\n';
  return text;
}

std::string digest(const Picture& picture) {
  std::string text = std::to_string(picture.stack.size());
  for (const PatchLayer& layer : picture.layers) {
    append(text, layer.vertex_position);
    append(text, layer.triangle_vertex);
    append(text, layer.color.node_value);
    append(text, layer.opacity.node_value);
  }
  return text;
}

std::string digest(const Solution& solution) {
  return digest(solution.picture());
}

std::string digest(const Image& image) {
  std::string text = std::to_string(image.width);
  append(text, image.bytes);
  return text;
}

std::string digest(const std::vector<std::uint8_t>& bytes) {
  return {bytes.begin(), bytes.end()};
}

std::string digest(const std::string& text) {
  return text;
}

std::string digest(const std::vector<Hint>& hints) {
  std::string text;
  for (const Hint& hint : hints) text += std::string(hint_name(hint.kind)) + hint.message + '\n';
  return text;
}

template <class Make>
void check(const std::string& name, const Make& make, const Sampling& sampling = {}) {
  expect_every_refusal_is_survived(
      name, make, [](const auto& value) { return digest(value); }, sampling);
}

class Allocation : public testing::TestWithParam<SmallDocument> {};

TEST_P(Allocation, read) {
  const std::string& text = GetParam().text;
  const bool has_png = std::string(GetParam().name) == "png_texture";
  check("read", [&](Context& context) { return read_document(context, text, "a.svg"); },
        {.also = has_png ? StatusCode::bad_input : StatusCode::out_of_memory});
}

TEST_P(Allocation, convert) {
  const Document document = document_of(GetParam().text);
  check("convert", [&](Context& context) { return write_svg(context, document); });
}

TEST_P(Allocation, lint) {
  const Document document = document_of(GetParam().text);
  check("lint", [&](Context& context) { return lint(context, document); });
}

TEST_P(Allocation, diffuse) {
  const Document document = document_of(GetParam().text);
  check("diffuse", [&](Context& context) { return diffuse(context, document, {}); });
  check("diffuse for pixels",
        [&](Context& context) { return diffuse(context, document, {.pixel_grid = true}); });
}

/// Two frames of a film; the second frame has another curve. If memory for the film's reused data
/// is lacking, its frames have another mesh.
TEST_P(Allocation, film) {
  const Document document = document_of(GetParam().text);
  const auto make = [&](Context& context) -> Result<Solution> {
    Result<Solution> solution = Solution::create(context, document);
    if (!solution) return solution;
    const bool has_curves = !document.layers.empty() && !document.layers[0].curves.empty();
    Status status;
    Curve curve;
    if (has_curves) {
      curve = document.layers[0].curves[0];
      for (Vec2& point : curve.control_points) point = point + Vec2{1, 2};
      status = solution->apply(context, InsertCurve{0, 0, curve}).status();
    }
    if (status) status = solution->solve_next(context, {});
    for (Vec2& point : curve.control_points) point = point + Vec2{2, 1};
    if (status && has_curves) {
      status = solution->apply(context, ReplaceCurve{0, 0, std::move(curve)}).status();
    }
    if (status) status = solution->solve_next(context, {});
    return status ? std::move(solution) : Result<Solution>(std::move(status));
  };
  expect_every_refusal_is_survived(
      "film", [&](Context& context) { return no_throw([&] { return make(context); }); },
      [](const Solution& film) { return std::to_string(film.picture().layers.size()); },
      {.every = random_case_count<std::size_t>(SFUMATO_HAS_SANITIZER ? 41 : 29, 7)});
}

/// Solved, changed, and solved again.
TEST_P(Allocation, solution) {
  const Document document = document_of(GetParam().text);
  const auto make = [&](Context& context) -> Result<Solution> {
    Result<Solution> solution = Solution::create(context, document);
    Status status = solution ? solution->solve(context, {}) : solution.status();
    if (status && !document.layers.empty() && !document.layers[0].curves.empty()) {
      const Curve& curve = document.layers[0].curves[0];
      status = solution->apply(context, InsertCurve{0, 0, curve}).status();
      if (status) status = solution->solve_roughly(context, {});
      if (status) status = solution->apply(context, RemoveCurve{0, 1}).status();
    }
    if (status) status = solution->apply(context, ReplaceStack{document.stack}).status();
    if (status) status = solution->solve(context, {});
    return status ? std::move(solution) : Result<Solution>(std::move(status));
  };
  // The caller owns the copies of the arguments.
  check("solution", [&](Context& context) { return no_throw([&] { return make(context); }); },
        {.every = 5});
}

TEST_P(Allocation, rasterize) {
  const Picture picture = picture_of(document_of(GetParam().text));
  const RasterOptions options{.width = 32, .height = 24, .format = PixelFormat::rgba8};
  check("rasterize", [&](Context& context) { return rasterize(context, picture, options); });
}

TEST_P(Allocation, picture_file) {
  const Picture picture = picture_of(document_of(GetParam().text), {.max_error = 0});
  const auto file = made([&](Context& context) { return write_picture(context, picture); });
  check("write_picture", [&](Context& context) { return write_picture(context, picture); });
  check("read_picture", [&](Context& context) { return read_picture(context, file); });
}

TEST_P(Allocation, render_pixels) {
  const Document document = document_of(GetParam().text);
  const RasterOptions options{.width = 16, .height = 12};
  check("render_pixels",
        [&](Context& context) { return render_pixels(context, document, {}, options); });
}

INSTANTIATE_TEST_SUITE_P(Of, Allocation, testing::ValuesIn(small_documents()),
                         [](const auto& instance) { return std::string(instance.param.name); });

Image image_of(int width, int height, PixelFormat format) {
  Image image{width, height, format, {}};
  image.bytes.resize(image.row_bytes() * static_cast<std::size_t>(height));
  for (std::size_t i = 0; i < image.bytes.size(); ++i) {
    image.bytes[i] = static_cast<std::uint8_t>(i * i % 251);
  }
  return image;
}

std::string digest_of_drawing(const Document& drawing) {
  return made([&](Context& context) { return write_svg(context, drawing); });
}

/// Returns a picture of a disc, whose edge gives every step of a trace something to do. If the
/// format has alpha, the picture around the disc is half transparent.
Image picture_of_disc(PixelFormat format) {
  constexpr int kSide = 12;
  Image image{kSide, kSide, format, {}};
  for (int i = 0; i < kSide * kSide; ++i) {
    const int x = i % kSide - 5, y = i / kSide - 6;
    const bool is_inside = x * x + y * y < 16;
    image.bytes.insert(image.bytes.end(), {is_inside ? std::uint8_t{230} : std::uint8_t{40},
                                           static_cast<std::uint8_t>(90 + 6 * x), 60});
    if (format == PixelFormat::rgba8) image.bytes.push_back(is_inside ? 255 : 128);
  }
  return image;
}

void check_trace(PixelFormat format, const TraceOptions& options, std::size_t every) {
  const Image picture = picture_of_disc(format);
  expect_every_refusal_is_survived(
      "trace", [&](Context& context) { return trace(context, picture, options); },
      digest_of_drawing, {.every = every});
}

TEST(AllocationOf, a_trace) {
  check_trace(PixelFormat::rgb8, {.points = 60, .edges_only = true}, 31);
}

TEST(AllocationOf, a_trace_of_all_that_there_is) {
  check_trace(PixelFormat::rgba8, {.points = 100, .has_texture = true}, 809);
}

TEST(AllocationOf, colours_of_a_picture) {
  const Image picture = picture_of_disc(PixelFormat::rgb8);
  const Document drawing = made([&](Context& context) {
    return trace(context, picture, {.points = 60, .edges_only = true});
  });
  const Image other = image_of(12, 12, PixelFormat::rgb8);
  expect_every_refusal_is_survived(
      "fit", [&](Context& context) { return fit_colors(context, drawing, other); },
      digest_of_drawing, {.every = 11});
}

TEST(AllocationOf, png_encoder) {
  const Image wide = image_of(70, 900, PixelFormat::rgba16);  // more stripes than one
  check("png16", [&](Context& context) { return encode_png(context, wide); });
  const Image plain = image_of(7, 5, PixelFormat::rgb8);
  check("png8", [&](Context& context) { return encode_png(context, plain); });
}

TEST(AllocationOf, png_decoder) {
  const Image image = image_of(40, 30, PixelFormat::rgba16);
  const Bytes file = made([&](Context& context) { return encode_png(context, image); });
  // libspng reports a damaged file if zlib lacks memory.
  check("decode", [&](Context& context) { return decode_png(context, file, "a.png"); },
        {.also = StatusCode::bad_input});
}

// WebP is left out: libwebp's decoder ends by a signal if it is refused memory (README.md).
TEST(AllocationOf, photo_reader) {
  const Bytes jpeg = jpeg_file(20, 10, 3, {200, 100, 50, 0});
  const Bytes inks = jpeg_file(20, 10, 4, {200, 100, 50, 0});
  for (const Bytes& file :
       {with_profile(with_exif(jpeg, exif_of(6)), display_p3_profile()),
        with_profile(jpeg, gray_profile(1)), with_profile(inks, ink_profile()), inks}) {
    check("photo", [&](Context& context) { return codecs::read_photo(context, file, "a.jpg"); });
  }
}

TEST(AllocationOf, jpeg_encoder) {
  const Image image = image_of(150, 130, PixelFormat::rgb8);  // its file grows twice
  check("jpeg", [&](Context& context) { return encode_jpeg(context, image, 95); });
}

/// libwebp may not report refused memory, and may then leave another or even a broken file
/// (README.md), so the bytes are not compared.
std::string no_digest(const Bytes&) {
  return "a file";
}

TEST(AllocationOf, webp_encoder) {
  const Image image = image_of(20, 18, PixelFormat::rgba8);
  const auto webp = [&](bool lossless) {
    return [&image, lossless](Context& context) {
      return encode_webp(context, image, {.lossless = lossless});
    };
  };
  expect_every_refusal_is_survived("lossy", webp(false), no_digest);
  expect_every_refusal_is_survived("lossless", webp(true), no_digest);
}

/// Refuses each allocation for the small document, or every `every`-th; for the other document, one
/// of many.
template <class Export>
void check_output(const Export& export_as, std::size_t every = 1) {
  const auto exporting = [&](const Picture& picture) {
    return [&](Context& context) { return export_as(context, picture); };
  };
  const DiffuseOptions coarse{.pixels_per_unit = 0.25, .max_error = 40};
  const Picture small = picture_of(document_of(small_document_for_outputs()), coarse);
  check("small", exporting(small), {.every = every});
  const Picture everything = picture_of(document_of(document_with_everything()), coarse);
  check("everything", exporting(everything), {.every = 211 * every});
}

TEST(AllocationOfOutput, html) {
  const HtmlOptions options{.title = "a", .fallback = {1, 2, 3}, .fallback_type = "image/jpeg"};
  check_output([&](Context& context,
                   const Picture& picture) { return export_html(context, picture, options); },
               random_case_count<std::size_t>(7, 1));
}

TEST(AllocationOfOutput, pdf) {
  check_output([](Context& context,
                  const Picture& picture) { return export_pdf(context, picture, {.title = "a"}); },
               11);
}

TEST(AllocationOfOutput, eps) {
  check_output([](Context& context, const Picture& picture) {
    return export_eps(context, picture, {.title = "a"});
  });
}

TEST(AllocationOfOutput, svg_image) {
  check_output(
      [](Context& context, const Picture& picture) { return export_svg(context, picture, {}); });
}

TEST(AllocationOfOutput, svg_of_triangles) {
  check_output(
      [](Context& context, const Picture& picture) {
        return export_svg(context, picture, {.mode = SvgMode::vector});
      },
      101);
}

TEST(AllocationOfOutput, glb) {
  check_output(
      [](Context& context, const Picture& picture) { return export_glb(context, picture, {}); }, 7);
}

TEST(AllocationOfOutput, sfv) {
  check_output(
      [](Context& context, const Picture& picture) { return export_sfv(context, picture, {}); });
}

TEST(AllocationOfOutput, tables) {
  check_output(
      [](Context& context, const Picture& picture) { return export_npz(context, picture); });
  check_output(
      [](Context& context, const Picture& picture) { return export_json(context, picture); }, 101);
  check_output(
      [](Context& context, const Picture& picture) { return export_ply(context, picture); });
}

TEST(AllocationOf, files) {
  const TemporaryFolder folder;
  const std::string path = folder.file("a");
  const Bytes bytes(1000, 'x');
  const auto write_and_read = [&](Context&) -> Result<std::string> {
    if (Status status = write_file(path, bytes); !status) return status;
    return read_file(path, 1 << 20);
  };
  check("files", write_and_read);
  EXPECT_EQ(folder.entry_count(), 1u);
}

/// Returns the call from document to PNG.
auto whole_render(const std::string& text, int width, int height) {
  return [=](Context& context) -> Result<Bytes> {
    const auto read = read_document(context, text, "a.svg");
    if (!read) return read.status();
    const auto picture = diffuse(context, read->document, {});
    if (!picture) return picture.status();
    const auto image = rasterize(context, *picture, {.width = width, .height = height});
    if (!image) return image.status();
    return encode_png(context, *image);
  };
}

TEST(AllocationOf, a_whole_render) {
  check("render", whole_render(document_with_everything(), 32, 24),
        {.every = 29, .also = StatusCode::bad_input});
}

TEST(AllocationOf, a_whole_render_on_many_threads) {
  ThreadPool executor(4);
  check("render", whole_render(document_with_everything(), 128, 96),
        {.every = 41, .executor = &executor, .also = StatusCode::bad_input});
}

/// Whatever is refused while a solution changes and is solved, it continues as if nothing had
/// happened.
TEST(AllocationOf, a_solution_that_goes_on) {
  const Document document = document_of(small_documents().front().text);
  ASSERT_FALSE(document.layers.empty());
  const Curve curve = document.layers[0].curves.at(0);
  Document larger = document;
  larger.layers.resize(document.layers.size() + 20);
  std::size_t changed = 0, refused = 0;
  const auto go_on = [&](std::size_t k, Refusal refusal, const Change& next) {
    Context context;
    Solution solution = std::move(*Solution::create(context, document));
    EXPECT_TRUE(solution.solve(context, {}).ok());
    bool was_changed = false, was_refused = false;
    {
      const RefusedAllocations refused_allocations(k, refusal);
      was_changed = no_throw([&] { return solution.apply(context, next); }).ok();
      const Status status = solution.solve(context, {});
      was_refused = RefusedAllocations::requests() > k;
      was_changed ? ++changed : ++refused;
      EXPECT_TRUE(status.ok() || status.code == StatusCode::out_of_memory) << to_string(status);
    }
    EXPECT_TRUE(was_changed || same_document(solution.document(), document));
    EXPECT_TRUE(solution.solve(context, {}).ok());
    EXPECT_TRUE(digest(solution) == digest(picture_of(solution.document())));
    EXPECT_EQ(context.budget.used(), bytes_of(solution.document()) + bytes_of(solution.picture()));
    return was_refused && !testing::Test::HasFailure();
  };
  for (const Refusal refusal : {Refusal::one, Refusal::all_from}) {
    for (const Change& next : {Change(InsertCurve{0, 0, curve}), Change(ReplaceDocument{larger})}) {
      SCOPED_TRACE(next.index());
      for (std::size_t k = 0; go_on(k, refusal, next); k += 1 + k / 64) {
      }
    }
  }
  EXPECT_GT(changed, 0u);
  EXPECT_GT(refused, 0u);
}

TEST(AllocationOf, a_loop_on_many_threads) {
  ThreadPool executor(3);
  for (std::size_t k = 0; k < 32; ++k) {
    for (const Refusal refusal : {Refusal::one, Refusal::all_from}) {
      Context context{.executor = &executor};
      Status status = ok_status();
      {
        const RefusedAllocations refused(k, refusal);
        status = parallel_for(context, 100, 1, [](std::size_t, std::size_t) {});
      }
      EXPECT_TRUE(status.ok() || status.code == StatusCode::out_of_memory) << to_string(status);
      EXPECT_TRUE(parallel_for(context, 100, 1, [](std::size_t, std::size_t) {}).ok());
    }
  }
}

}  // namespace
}  // namespace sfumato::test
