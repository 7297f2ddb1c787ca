// With every wrong value in every field of every public struct, every public function gives an
// answer: no crash, no exception, no undefined behaviour (the sanitizers run this too).
#include "trust/wrong_values.hpp"

#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <initializer_list>
#include <limits>
#include <optional>
#include <utility>

#include "allocation/documents.hpp"
#include "picture/check_picture.hpp"
#include "sfumato/api/render_pixels.hpp"
#include "sfumato/base/native/file.hpp"
#include "sfumato/base/native/thread_pool.hpp"
#include "sfumato/codecs/jpeg_encode.hpp"
#include "sfumato/codecs/png.hpp"
#include "sfumato/codecs/webp_encode.hpp"
#include "sfumato/document/document.hpp"
#include "sfumato/export/eps/eps.hpp"
#include "sfumato/export/glb/glb.hpp"
#include "sfumato/export/html/html.hpp"
#include "sfumato/export/pdf/pdf.hpp"
#include "sfumato/export/svg/svg.hpp"
#include "sfumato/export/tables/tables.hpp"
#include "sfumato/formats/orzan/orzan.hpp"
#include "sfumato/formats/read_document.hpp"
#include "sfumato/formats/svg/svg.hpp"
#include "sfumato/formats/svg/svg_write.hpp"
#include "sfumato/gpu/render.hpp"
#include "sfumato/import/import_svg.hpp"
#include "sfumato/lint/lint.hpp"
#include "sfumato/raster/rasterize.hpp"
#include "sfumato/solve/diffuse.hpp"
#include "sfumato/solve/solution.hpp"
#include "support/soak.hpp"

namespace sfumato::test {
namespace {

/// Limits for an attempt; reaching one of them is a valid answer, too.
constexpr double kSeconds = 0.2;
constexpr std::size_t kBytes = std::size_t{256} << 20;

Context limited() {
  return Context{.budget = Budget(kBytes), .deadline = Deadline::in(kSeconds)};
}

const RasterOptions kSmall{.width = 12, .height = 9};
// Thousands of attempts: each draws few triangles, however wrong the one value is.
const DiffuseOptions kFewNodes{.tolerance = 0.2, .max_area_fraction = 1, .max_error = 8};
const DiffuseOptions kFewTriangles{.tolerance = 0.2, .max_area_fraction = 1, .max_error = 0};
constexpr double kMostError = 32;
const PdfOptions kCoarsePdf{.dpi = 24, .max_error = kMostError};
const GlbOptions kCoarseGlb{.max_error = kMostError, .dpi = 24};
const SvgOptions kCoarseSvg{.mode = SvgMode::vector, .dpi = 24, .max_error = kMostError};

/// The answer of a function; nothing: it ran out of time, as may happen on a busy machine.
using Answer = std::optional<StatusCode>;

/// Returns the code; requires ok or an error that the caller can fix.
Answer answer(const Status& status, const std::string& place) {
  const bool is_honest =
      status.ok() || status.code == StatusCode::bad_input || status.code == StatusCode::limit;
  EXPECT_TRUE(is_honest) << place << ": " << int(status.code) << ' ' << status.message;
  EXPECT_EQ(status.ok(), status.message.empty()) << place;
  return status.limit == "time" ? std::nullopt : Answer(status.code);
}

/// Expects that the functions refuse in the same way as the check.
void expect_as_checked(Answer checked, std::initializer_list<Answer> answers,
                       const std::string& place) {
  if (!checked || checked == StatusCode::ok) return;
  for (const Answer& said : answers) {
    EXPECT_EQ(said.value_or(*checked), *checked) << place;
  }
}

/// Calls a function in a new Context, which must end as it began.
template <class Verb>
Answer answer_of(const std::string& place, Verb verb) {
  Context context = limited();
  Status status;
  {
    const auto result = verb(context);
    if constexpr (std::is_same_v<std::remove_const_t<decltype(result)>, Status>) {
      status = result;
    } else {
      status = result.status();
    }
  }
  EXPECT_EQ(context.budget.used(), 0u) << place;
  return answer(status, place);
}

Document document_of_everything() {
  Context context;
  Result<ReadDocument> read = read_document(context, document_with_everything(), "all.svg");
  EXPECT_TRUE(read.ok()) << to_string(read.status());
  Document document = std::move(read->document);
  document.background = Rgb{0.5f, 0.5f, 1};
  return document;
}

Picture picture_of_everything() {
  Context context;
  Result<Picture> picture = diffuse(context, document_of_everything(), kFewTriangles);
  EXPECT_TRUE(picture.ok()) << to_string(picture.status());
  return std::move(*picture);
}

/// Chooses one function of three for an attempt, and the next ones for the next attempt, so that
/// every function sees wrong values of every field; in `make soak` all of them.
class Turns {
 public:
  Turns(std::size_t attempt, std::size_t step) : next_(attempt), step_(step) {}

  template <class Verb>
  Answer ask(const std::string& place, Verb verb) {
    return next_++ % step_ == 0 ? answer_of(place, verb) : std::nullopt;
  }

 private:
  std::size_t next_, step_;
};

void draw(const Document& document, const std::string& place) {
  const Answer valid =
      answer_of(place + ", validate", [&](Context& c) { return validate(c, document); });
  answer_of(place + ", shaders", [&](Context& c) { return validate(c, document.shaders); });
  answer_of(place + ", frame", [&](Context& c) { return picture_frame(c, document, {}); });
  static_cast<void>(bytes_of(document));
  expect_as_checked(
      valid,
      {answer_of(place + ", diffuse", [&](Context& c) { return diffuse(c, document, kFewNodes); }),
       answer_of(place + ", lint", [&](Context& c) { return lint(c, document); }),
       answer_of(place + ", pixels",
                 [&](Context& c) { return render_pixels(c, document, {}, kSmall); }),
       answer_of(place + ", write", [&](Context& c) { return write_svg(c, document); })},
      place);
}

/// Expects that the written bytes can be read, and give the same picture.
Result<std::vector<std::uint8_t>> kept(Context& context, const Picture& picture,
                                       const PictureOrigin& origin = {}) {
  auto bytes = write_picture(context, picture, origin);
  if (!bytes) return bytes;
  PictureOrigin found;
  const Result<Picture> read = read_picture(context, *bytes, &found);
  if (!read) return read.status();
  const auto again = write_picture(context, *read, found);
  if (!again) return again.status();
  EXPECT_EQ(*again, *bytes);
  return bytes;
}

/// Makes every output of a valid picture, or some of them in turn.
void show(const Picture& picture, const std::string& place, std::size_t attempt) {
  const Answer valid =
      answer_of(place + ", check", [&](Context& c) { return picture::check_picture(c, picture); });
  static_cast<void>(bytes_of(picture));
  const bool is_valid = valid.value_or(StatusCode::ok) == StatusCode::ok;
  const Answer written = answer_of(place + ", file", [&](Context& c) { return kept(c, picture); });
  EXPECT_TRUE(is_valid || written != StatusCode::ok) << place;
  const Answer drawable = answer_of(place + ", check for pixels", [&](Context& c) {
    return picture::check_picture(c, picture, picture::PictureUse::pixels);
  });
  const Answer shown =
      answer_of(place + ", rasterize", [&](Context& c) { return rasterize(c, picture, kSmall); });
  expect_as_checked(drawable, {shown}, place);
  if (shown == StatusCode::bad_input) {  // before a device is requested
    expect_as_checked(
        shown,
        {answer_of(place + ", gpu", [&](Context& c) { return render_on_gpu(c, picture, kSmall); })},
        place);
  }
  Turns turns(attempt, is_valid ? random_case_count<std::size_t>(3, 1) : 1);
  expect_as_checked(
      valid,
      {turns.ask(place + ", html", [&](Context& c) { return export_html(c, picture, {}); }),
       turns.ask(place + ", pdf", [&](Context& c) { return export_pdf(c, picture, kCoarsePdf); }),
       turns.ask(place + ", eps", [&](Context& c) { return export_eps(c, picture, {.dpi = 24}); }),
       turns.ask(place + ", svg", [&](Context& c) { return export_svg(c, picture, kCoarseSvg); }),
       turns.ask(place + ", glb", [&](Context& c) { return export_glb(c, picture, kCoarseGlb); }),
       turns.ask(place + ", npz", [&](Context& c) { return export_npz(c, picture); }),
       turns.ask(place + ", json", [&](Context& c) { return export_json(c, picture); }),
       turns.ask(place + ", ply", [&](Context& c) { return export_ply(c, picture); })},
      place);
}

template <class Options, class Verb>
void try_options(const std::string& name, Options options, Verb verb) {
  try_wrong_values(options, name, [&](const std::string& place) {
    answer_of(place, [&](Context& c) { return verb(c, options); });
  });
}

TEST(WrongValues, of_documents_are_answered) {
  Document document = document_of_everything();
  draw(document, "as it was");
  try_wrong_values(document, "document", [&](const std::string& place) { draw(document, place); });
}

/// Returns an attempt that calls show() for one attempt after the other.
Attempt shown_in_turn(const Picture& picture) {
  return [&picture, count = std::size_t{0}](const std::string& place) mutable {
    show(picture, place, count++);
  };
}

TEST(WrongValues, of_pictures_are_answered) {
  Picture picture = picture_of_everything();
  for (std::size_t i = 0; i < 3; ++i) show(picture, "as it was", i);
  try_wrong_values(picture, "picture", shown_in_turn(picture));
}

TEST(WrongValues, of_layers_of_pictures_are_answered) {
  Picture picture = picture_of_everything();
  const Attempt attempt = shown_in_turn(picture);
  for (std::size_t i = 1; i + 1 < picture.layers.size(); ++i) {
    try_wrong_values(picture.layers[i], "layer " + std::to_string(i), attempt);
  }
}

TEST(WrongValues, of_items_of_a_stack_are_answered) {
  Document document = document_of_everything();
  for (StackItem& item : document.stack) {
    try_wrong_values(item, "item", [&](const std::string& place) {
      draw(document, place);
      if (const auto* stroke = std::get_if<LocalStroke>(&item)) {
        answer_of(place, [&](Context& c) { return validate(c, *stroke); });
      }
    });
  }
}

TEST(WrongValues, of_what_documents_and_pictures_share_are_the_same_to_both) {
  Document document = document_of_everything();
  Context context;
  const auto compare = [&](const std::string& place) {
    Picture picture;
    picture.interpolation = document.interpolation;
    picture.background = document.background;
    picture.shaders = document.shaders;
    picture.layers.resize(document.layers.size());
    for (const StackItem& item : document.stack) {
      if (const auto* i = std::get_if<LayerInstance>(&item)) {
        picture.stack.push_back(
            PatchInstance{i->layer, i->artboard_from_layer, i->opacity, i->blend});
      } else if (const auto* stroke = std::get_if<LocalStroke>(&item)) {
        picture.stack.push_back(*stroke);
      } else if (const auto* group = std::get_if<GroupBegin>(&item)) {
        picture.stack.push_back(*group);
      } else {
        picture.stack.push_back(GroupEnd{});
      }
    }
    const Status of_document = validate(context, document);
    const Status of_picture = picture::check_picture(context, picture);
    EXPECT_EQ(of_document.code, of_picture.code)
        << place << ": " << of_document.message << "; " << of_picture.message;
  };
  try_wrong_values(document.interpolation, "interpolation", compare);
  try_wrong_values(document.background, "background", compare);
  for (StackItem& item : document.stack) try_wrong_values(item, "item", compare);
  document.layers.clear();  // they refer to shaders
  document.stack.clear();
  try_wrong_values(document.shaders, "shaders", compare);
}

TEST(WrongValues, of_options_are_answered) {
  const Document document = document_of_everything();
  const Picture picture = picture_of_everything();
  try_options("diffuse", DiffuseOptions{}, [&](Context& c, const DiffuseOptions& options) {
    return diffuse(c, document, options);
  });
  try_options("pixels", DiffuseOptions{}, [&](Context& c, const DiffuseOptions& options) {
    return render_pixels(c, document, options, kSmall);
  });
  try_options("pixels' raster", kSmall, [&](Context& c, const RasterOptions& options) {
    return render_pixels(c, document, {}, options);
  });
  try_options("raster", kSmall, [&](Context& c, const RasterOptions& options) {
    return rasterize(c, picture, options);
  });
  try_options("pdf", PdfOptions{}, [&](Context& c, const PdfOptions& options) {
    return export_pdf(c, picture, options);
  });
  try_options("eps", EpsOptions{}, [&](Context& c, const EpsOptions& options) {
    return export_eps(c, picture, options);
  });
  try_options("svg", SvgOptions{.mode = SvgMode::vector},
              [&](Context& c, const SvgOptions& o) { return export_svg(c, picture, o); });
  try_options("svg of pixels", SvgOptions{}, [&](Context& c, const SvgOptions& options) {
    return export_svg(c, picture, options);
  });
  try_options("origin", PictureOrigin{},
              [&](Context& c, const PictureOrigin& origin) { return kept(c, picture, origin); });
  try_options("glb", GlbOptions{}, [&](Context& c, const GlbOptions& options) {
    return export_glb(c, picture, options);
  });
  try_options(
      "html", HtmlOptions{.fallback = {1, 2, 3}},
      [&](Context& c, const HtmlOptions& options) { return export_html(c, picture, options); });
}

TEST(WrongValues, of_images_are_answered) {
  Image image{3, 2, PixelFormat::rgb8, std::vector<std::uint8_t>(18, 7)};
  const auto encode = [&](const std::string& place) {
    answer_of(place + ", validate", [&](Context& c) { return validate(c.limits, image); });
    answer_of(place + ", png", [&](Context& c) { return encode_png(c, image); });
    answer_of(place + ", jpeg", [&](Context& c) { return encode_jpeg(c, image, 80); });
    answer_of(place + ", webp", [&](Context& c) { return encode_webp(c, image, {}); });
    answer_of(place + ", lossless",
              [&](Context& c) { return encode_webp(c, image, {.lossless = true}); });
  };
  try_wrong_values(image, "image", encode);
  image.width = image.height = 4000;
  encode("too few bytes");
  image = {3, 2, PixelFormat::rgb8, std::vector<std::uint8_t>(18, 7)};
  int quality = 80;
  try_wrong_values(quality, "quality", [&](const std::string& place) {
    answer_of(place, [&](Context& c) { return encode_jpeg(c, image, quality); });
  });
  try_options("webp", WebpOptions{}, [&](Context& c, const WebpOptions& options) {
    return encode_webp(c, image, options);
  });
}

TEST(WrongValues, of_names_and_texts_are_answered) {
  const std::string text = document_with_everything();
  const std::vector<std::uint8_t> bytes(text.begin(), text.end());
  const auto read = [&](const std::string& file, const std::string& drawing) {
    const std::string place = "a name of " + std::to_string(file.size());
    answer_of(place, [&](Context& c) { return read_document(c, drawing, file); });
    answer_of(place, [&](Context& c) { return read_svg(c, drawing, file); });
    answer_of(place, [&](Context& c) { return import_svg(c, drawing, file); });
    answer_of(place, [&](Context& c) { return read_orzan(c, drawing, file); });
    answer_of(place, [&](Context& c) { return decode_png(c, bytes, file); });
    answer_of(place, [&](Context& c) { return decode_png_with_alpha(c, bytes, file); });
  };
  for (const std::string& wrong : wrong::strings()) {
    read(wrong, text);
    read("a.svg", wrong);
    for (const std::size_t most : {std::size_t{0}, std::numeric_limits<std::size_t>::max()}) {
      EXPECT_EQ(read_file(wrong, most).status().code, StatusCode::io);
      EXPECT_EQ(read_bytes(wrong, most).status().code, StatusCode::io);
    }
  }
}

TEST(WrongValues, of_statuses_have_words) {
  Status status = make_error(StatusCode::io, "words", {"file", 1, 1});
  try_wrong_values(status, "status",
                   [&](const std::string&) { static_cast<void>(to_string(status)); });
}

TEST(WrongValues, of_hints_have_words) {
  const Document document = document_of_everything();
  Hint hint{HintKind::leak, 0, 0, CurveSide::left, 0, 0, Vec2{1, 2}, "words"};
  try_wrong_values(hint, "hint", [&](const std::string&) {
    static_cast<void>(place_text(document, hint));
    static_cast<void>(hint_name(hint.kind));
    static_cast<void>(is_note(hint.kind));
  });
}

/// All public functions that take a Context, each with small valid arguments.
class Verbs {
 public:
  /// Runs them in a Context that `change` has made wrong. Null: each may give any honest answer.
  void run(const std::function<void(Context&)>& change, const std::string& place,
           const StatusCode* expected = nullptr) {
    const auto ask = [&](auto verb) {
      Context context = limited();
      change(context);
      const auto result = verb(context);
      Status status;
      if constexpr (std::is_same_v<std::remove_const_t<decltype(result)>, Status>) {
        status = result;
      } else {
        status = result.status();
      }
      if (expected) {
        EXPECT_EQ(status.code, *expected) << place << ": " << status.message;
      } else {
        answer(status, place);
      }
      EXPECT_EQ(context.budget.used(), 0u) << place;
    };
    ask([&](Context& c) { return read_document(c, text_, "a"); });
    ask([&](Context& c) { return read_svg(c, text_, "a"); });
    ask([&](Context& c) { return import_svg(c, text_, "a"); });
    ask([&](Context& c) { return read_orzan(c, small_documents()[9].text, "a"); });
    ask([&](Context& c) { return validate(c, document_); });
    ask([&](Context& c) { return write_svg(c, document_); });
    ask([&](Context& c) { return lint(c, document_); });
    ask([&](Context& c) { return diffuse(c, document_, {}); });
    ask([&](Context& c) {
      Document changed = document_;
      return apply_change(c, changed, RemoveCurve{0, 0});
    });
    ask([&](Context& c) {
      Result<Solution> solution = Solution::create(c, document_);
      Status status = solution.status();
      if (status) status = solution->apply(c, RemoveCurve{0, 0}).status();
      return status ? solution->solve(c, {}) : status;
    });
    ask([&](Context& c) { return render_pixels(c, document_, {}, kSmall); });
    ask([&](Context& c) { return rasterize(c, picture_, kSmall); });
    if (expected) ask([&](Context& c) { return render_on_gpu(c, picture_, kSmall); });
    ask([&](Context& c) { return export_html(c, picture_, {}); });
    ask([&](Context& c) { return export_pdf(c, picture_, {}); });
    ask([&](Context& c) { return export_eps(c, picture_, {}); });
    ask([&](Context& c) { return export_svg(c, picture_, {.mode = SvgMode::vector}); });
    ask([&](Context& c) { return export_glb(c, picture_, {}); });
    ask([&](Context& c) { return export_npz(c, picture_); });
    ask([&](Context& c) { return export_json(c, picture_); });
    ask([&](Context& c) { return export_ply(c, picture_); });
    ask([&](Context& c) { return encode_png(c, image_); });
    ask([&](Context& c) { return encode_jpeg(c, image_, 80); });
    ask([&](Context& c) { return encode_webp(c, image_, {}); });
    ask([&](Context& c) { return decode_png(c, png_, "a"); });
    ask([&](Context& c) { return decode_png_with_alpha(c, png_, "a"); });
    ask([&](Context& c) { return picture_frame(c, document_, document_.artboard); });
    ask([&](Context& c) { return validate(c, document_.shaders); });
  }

 private:
  std::string text_ = document_with_everything();
  Document document_ = document_of_everything();
  Picture picture_ = picture_of_everything();
  Image image_{3, 2, PixelFormat::rgb8, std::vector<std::uint8_t>(18, 7)};
  std::vector<std::uint8_t> png_ = [] {
    Context context;
    const Image image{1, 1, PixelFormat::rgb8, {1, 2, 3}};
    return *encode_png(context, image);
  }();
};

const StatusCode kBadInput = StatusCode::bad_input;

TEST(WrongValues, of_limits_are_answered) {
  Verbs verbs;
  for (const LimitName& known : limit_names()) {
    for (const std::size_t low : {0, 1, 2}) {
      verbs.run([&](Context& c) { c.limits.*(known.value) = low; }, std::string(known.name));
    }
    for (const std::size_t high : {known.highest + 1, std::numeric_limits<std::size_t>::max()}) {
      verbs.run([&](Context& c) { c.limits.*(known.value) = high; }, std::string(known.name),
                &kBadInput);
    }
  }
}

TEST(WrongValues, of_contexts_are_answered) {
  Verbs verbs;
  Context wrong;
  wrong.deadline = Deadline::in(1);
  try_wrong_values(wrong.deadline->seconds, "deadline", [&](const std::string& place) {
    verbs.run([&](Context& c) { c.deadline = Deadline::in(wrong.deadline->seconds); }, place);
  });
  verbs.run([](Context& c) { c.deadline = Deadline::in(std::nan("")); }, "deadline", &kBadInput);
  for (const int level : {3, 200, 255}) {
    verbs.run([&](Context& c) { c.simd = SimdLevel(level); }, "simd", &kBadInput);
  }
  verbs.run([](Context& c) { c.outer = &c; }, "outer", &kBadInput);
}

TEST(WrongValues, of_budgets_are_answered) {
  Verbs verbs;
  for (const std::size_t bytes : {std::size_t{0}, std::size_t{1}, std::size_t{100'000}}) {
    Context context{.budget = Budget(bytes)};
    const auto read = read_document(context, document_with_everything(), "a");
    answer(read.status(), "budget");
    EXPECT_EQ(context.budget.used(), 0u);
  }
  Budget all(std::numeric_limits<std::size_t>::max());
  EXPECT_TRUE(all.charge(std::numeric_limits<std::size_t>::max(), "all").ok());
  EXPECT_FALSE(all.charge(1, "more").ok());
}

/// An executor that claims a number of threads.
class Boaster : public Executor {
 public:
  explicit Boaster(int threads) : threads_(threads) {}
  int thread_count() const override { return threads_; }

 private:
  int threads_;
};

TEST(WrongValues, of_executors_are_answered) {
  Verbs verbs;
  for (const int threads : {-5, 0, 1'000'000'000}) {
    Boaster boaster(threads);
    verbs.run([&](Context& c) { c.executor = &boaster; }, "threads", &kBadInput);
  }
  EXPECT_LE(ThreadPool(100'000).thread_count(), limits::kThreads);
}

TEST(WrongValues, more_shaders_than_a_layer_may_have_do_not_reach_the_rays) {
  Document document;
  document.artboard = {{0, 0}, {100, 100}};
  document.layers.resize(1);
  for (std::uint32_t i = 0; i < 1500; ++i) {
    document.shaders.push_back({"", GradientFill{LinearGradient{}, {}, {}, {{0, {1, 0, 0}}}}});
    const double y = i * 0.06;
    Curve curve{.control_points = {{1, y}, {2, y}, {3, y}, {4, y}}};
    curve.left.color = {ShaderKind::image_domain, {}, i};
    document.layers[0].curves.push_back(curve);
  }
  document.stack = {LayerInstance{}};
  DiffuseOptions options{.max_error = 0};
  options.gather.method = gather::Method::rays;
  for (const std::size_t limit : {64, 2000}) {
    Context context;
    context.limits.shaders_per_layer = limit;
    EXPECT_EQ(diffuse(context, document, options).status().code,
              limit == 64 ? StatusCode::limit : StatusCode::bad_input);
  }
}

}  // namespace
}  // namespace sfumato::test
