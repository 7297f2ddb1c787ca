// A drawing with scrambled colours recovers them from its own picture.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sfumato/base/native/thread_pool.hpp"
#include "sfumato/document/build.hpp"
#include "sfumato/trace/trace.hpp"
#include "support/cancel_at.hpp"
#include "support/draw.hpp"
#include "support/drawing.hpp"
#include "support/folder_files.hpp"
#include "support/picture_quality.hpp"
#include "support/places.hpp"
#include "support/same_document.hpp"

namespace sfumato {
namespace {

constexpr Rgb kGrey{0.5f, 0.5f, 0.5f};

Image drawn_at_width(const Document& document, int width = 200) {
  Context context;
  const Box& box = document.artboard;
  const int height = static_cast<int>(std::lround(width * box.height() / box.width()));
  Result<Image> image = test::draw(context, document, width, height, PixelFormat::rgb8);
  EXPECT_TRUE(image.ok()) << to_string(image.status());
  return image ? std::move(*image) : Image{};
}

template <class AnyDocument>
auto stops_of(AnyDocument& document) {
  std::vector<decltype(&document.layers[0].curves[0].left.color.stops.stops[0])> stops;
  for (auto& layer : document.layers) {
    for (auto& curve : layer.curves) {
      for (auto* side : {&curve.left, &curve.right}) {
        for (auto& stop : side->color.stops.stops) stops.push_back(&stop);
      }
    }
  }
  return stops;
}

/// Returns the document with all stops in unrelated colours.
Document scrambled(Document document) {
  std::uint32_t state = 1;
  const auto next = [&] {
    state = state * 1664525 + 1013904223;
    return static_cast<float>(state >> 24) / 255;
  };
  for (Stop<Rgb>* stop : stops_of(document)) stop->value = {next(), next(), next()};
  return document;
}

Document fitted(const Document& drawing, const Image& picture, const ColorFit& options = {},
                TraceStats* stats = nullptr) {
  Context context;
  Result<Document> document = fit_colors(context, drawing, picture, options, stats);
  EXPECT_TRUE(document.ok()) << to_string(document.status());
  return document ? std::move(*document) : Document{};
}

/// One code value of 255, as a difference of two floats.
constexpr double kOneCode = 1.001;

/// Returns the largest difference of any channel of any stop, in code values of 255.
double largest_difference(const Document& a, const Document& b) {
  const auto of_a = stops_of(a), of_b = stops_of(b);
  EXPECT_EQ(of_a.size(), of_b.size());
  double largest = 0;
  for (std::size_t i = 0; i < std::min(of_a.size(), of_b.size()); ++i) {
    const Rgb x = of_a[i]->value, y = of_b[i]->value;
    for (const float d : {x.r - y.r, x.g - y.g, x.b - y.b}) {
      largest = std::max(largest, 255 * std::abs(double{d}));
    }
  }
  return largest;
}

Rgb rounded(Rgb color) {
  const auto code = [](float value) { return std::round(255 * value) / 255; };
  return {code(color.r), code(color.g), code(color.b)};
}

double psnr_to(const Document& document, const Image& picture) {
  return test::psnr_db(test::planes_of(drawn_at_width(document, picture.width)),
                       test::planes_of(picture));
}

/// Returns a square along the artboard, coloured inside.
Curve frame_curve(std::vector<Rgb> inside, double side = 100) {
  Curve curve = polyline({{0, 0}, {side, 0}, {side, side}, {0, side}, {0, 0}});
  curve.right = colored(inside);
  return curve;
}

Document disc_in_frame() {
  return test::one_layer(
      {frame_curve({rgb(0x2060a0)}),
       test::colored(test::circle_curve({50, 50}, 25), rgb(0x2060a0), rgb(0xe0a030))});
}

TEST(FitColors, disc_of_one_colour_comes_back_exactly) {
  const Document disc = disc_in_frame();
  EXPECT_EQ(largest_difference(fitted(scrambled(disc), drawn_at_width(disc)), disc), 0);
}

TEST(FitColors, gradients_come_back) {
  Document drawing = test::one_layer({frame_curve({rgb(0x2060a0), rgb(0xf0f0c0), rgb(0x104020)})});
  Curve line = bezier({{20, 70}, {40, 20}, {60, 20}, {80, 70}});
  line.left = colored({rgb(0xff2000), rgb(0x20c040), rgb(0x4020ff)});
  line.right = colored({rgb(0x000000), rgb(0xffffff)});
  drawing.layers[0].curves.push_back(line);
  EXPECT_LE(largest_difference(fitted(scrambled(drawing), drawn_at_width(drawing, 300)), drawing),
            2);
}

LocalStroke stroke(Vec2 from, Vec2 to, Rgb color, float radius) {
  LocalStroke out;
  out.curve.control_points = test::straight_curve(from, to).control_points;
  out.curve.left_color = colored({color}).color.stops;
  out.curve.influence_radius = {StopSpace::parameter, {{0, radius}}};
  out.curve.alpha = 0.7;
  return out;
}

/// Returns a single disc; its layer is transparent outside.
std::vector<Curve> clear_disc(Vec2 center, std::vector<Rgb> colors, float opacity = 1) {
  Curve disc = test::with_opacity(test::circle_curve(center, 25), 0, opacity);
  disc.right.color = colored(colors).color;
  return {disc};
}

TEST(FitColors, layers_with_opacity_come_back) {
  Document drawing = test::one_layer({frame_curve({rgb(0x2060a0)})});
  add_layer(drawing, clear_disc({40, 45}, {rgb(0xe0a030)}, 0.6f));
  drawing.stack.push_back(GroupBegin{0.7f, BlendMode::normal});
  add_layer(drawing, clear_disc({60, 45}, {rgb(0x30c080), rgb(0xf0f000)}), 0.8f);
  add_layer(drawing, clear_disc({50, 65}, {rgb(0xc03080)}));
  drawing.stack.push_back(GroupEnd{});
  EXPECT_LE(largest_difference(fitted(scrambled(drawing), drawn_at_width(drawing)), drawing),
            kOneCode);
}

TEST(FitColors, instances_share_their_colours) {
  Document drawing = test::one_layer({frame_curve({rgb(0x2060a0)})});
  const std::uint32_t disc = add_layer(drawing, clear_disc({30, 30}, {kGrey, rgb(0xf08020)}), 0.9f);
  add_instance(drawing, disc, {0.5, 0.2, -0.1, 0.6, 50, 40}, 0.5f);
  add_instance(drawing, disc, {-1, 0, 0, 1, 150, 10});
  EXPECT_LE(largest_difference(fitted(scrambled(drawing), drawn_at_width(drawing)), drawing),
            kOneCode);
}

TEST(FitColors, what_is_hidden_keeps_its_colours) {
  Document drawing = test::one_layer({frame_curve({rgb(0x123456), rgb(0xfedcba)})});
  add_layer(drawing, {frame_curve({kGrey})});
  const Document before = scrambled(drawing);
  const Document back = fitted(before, drawn_at_width(drawing));
  EXPECT_EQ(back.layers[0].curves, before.layers[0].curves);
  EXPECT_EQ(back.layers[1].curves[0].right.color.stops.stops[0].value, rgb(0x808080));
}

TEST(FitColors, nothing_changes_but_colours) {
  Document drawing = disc_in_frame();
  add_layer(drawing, clear_disc({40, 45}, {rgb(0xe0a030)}, 0.6f), 0.5f);
  drawing.stack.push_back(stroke({5, 5}, {5, 95}, kGrey, 4));
  drawing.background = kGrey;
  const Document before = scrambled(drawing);
  Document back = fitted(before, drawn_at_width(drawing));
  EXPECT_GT(largest_difference(back, before), 10);
  const auto now = stops_of(back);
  const auto then = stops_of(before);
  for (std::size_t i = 0; i < now.size(); ++i) {
    EXPECT_EQ(now[i]->value, rounded(now[i]->value)) << "colours of 8 bits make short files";
    now[i]->value = then[i]->value;
  }
  EXPECT_TRUE(test::same_document(back, before));
}

TEST(FitColors, local_curves_and_image_domain_shaders_are_looked_past) {
  Document drawing = disc_in_frame();
  drawing.shaders.push_back({"", GradientFill{LinearGradient{{0, 0}, {100, 0}},
                                              SpreadMethod::pad,
                                              {},
                                              {{0, rgb(0x00ff00)}, {1, rgb(0xff00ff)}}}});
  drawing.layers[0].curves.push_back(test::straight_curve({10, 90}, {90, 90}));
  drawing.layers[0].curves.back().left.color = {ShaderKind::image_domain, {}, 0};
  drawing.layers[0].curves.back().right.color = {ShaderKind::image_domain, {}, 0};
  drawing.stack.push_back(stroke({5, 50}, {95, 50}, rgb(0x00ff80), 12));
  EXPECT_LE(largest_difference(fitted(scrambled(drawing), drawn_at_width(drawing)), drawing),
            kOneCode);
}

TEST(FitColors, what_lies_below_multiply_and_screen_is_fitted_through_them) {
  for (const BlendMode mode : {BlendMode::multiply, BlendMode::screen}) {
    for (const bool in_group : {false, true}) {
      Document drawing = test::one_layer({frame_curve({rgb(0x6090d0), rgb(0xd0b090)})});
      if (in_group) drawing.stack.push_back(GroupBegin{0.8f, mode});
      add_layer(drawing, clear_disc({50, 50}, {rgb(0x804020)}, 0.9f), 1,
                in_group ? BlendMode::normal : mode);
      if (in_group) drawing.stack.push_back(GroupEnd{});
      Document before = scrambled(drawing);
      before.layers[1] = drawing.layers[1];
      const Document back = fitted(before, drawn_at_width(drawing));
      EXPECT_LE(largest_difference(back, drawing), kOneCode) << in_group;
      EXPECT_EQ(back.layers[1].curves, before.layers[1].curves);
    }
  }
}

TEST(FitColors, layers_of_other_modes_and_pixels_below_them_are_left_as_they_are) {
  Document drawing = disc_in_frame();
  add_layer(drawing, clear_disc({50, 50}, {rgb(0x804020)}), 1, BlendMode::soft_light);
  const Document before = scrambled(drawing);
  TraceStats stats;
  const Document back = fitted(before, drawn_at_width(drawing), {}, &stats);
  EXPECT_EQ(back.layers[1].curves, before.layers[1].curves);
  EXPECT_EQ(back.layers[0].curves[1].right, before.layers[0].curves[1].right);
  EXPECT_EQ(back.layers[0].curves[1].left, drawing.layers[0].curves[1].left);
}

TEST(FitColors, other_interpolation_spaces_are_fitted_in_themselves) {
  for (const InterpolationSpace space : {InterpolationSpace::linear, InterpolationSpace::oklab}) {
    Document drawing = test::one_layer(
        {frame_curve({rgb(0x2060a0), rgb(0xf0f0c0), rgb(0x104020)}),
         test::colored(test::circle_curve({50, 50}, 25), rgb(0x2060a0), rgb(0xe0a030))});
    drawing.interpolation = space;
    add_layer(drawing, clear_disc({40, 45}, {rgb(0x30c080)}), 0.6f);
    const Image picture = drawn_at_width(drawing);
    const Document back = fitted(scrambled(drawing), picture);
    EXPECT_LE(largest_difference(back, drawing), 3);
  }
}

TEST(FitColors, transparent_pictures_are_as_on_the_backdrop) {
  Document drawing = disc_in_frame();
  drawing.background = rgb(0x204060);
  Image clear{64, 64, PixelFormat::rgba8, {}};
  clear.bytes.assign(4 * 64 * 64, 0);
  const Document back = fitted(drawing, clear);
  for (const Stop<Rgb>* stop : stops_of(back)) EXPECT_EQ(stop->value, rgb(0x204060));
}

TEST(FitColors, pictures_of_any_size_lie_over_the_artboard) {
  Document drawing = test::one_layer(
      {frame_curve({rgb(0x2060a0)}, 50),
       test::colored(test::circle_curve({25, 25}, 12), rgb(0x2060a0), rgb(0xe0a030))},
      {{10, 5}, {40, 45}});
  Context context;
  const Result<Image> wide = test::draw(context, drawing, 240, 90, PixelFormat::rgb16);
  ASSERT_TRUE(wide.ok());
  TraceStats stats;
  EXPECT_LE(
      largest_difference(fitted(scrambled(drawing), *wide, {.max_side = 120}, &stats), drawing),
      kOneCode);
  EXPECT_EQ(stats.scale, 0.5);
}

TEST(FitColors, radii_are_found) {
  const auto blurred = [](float radius) {
    Document drawing = disc_in_frame();
    drawing.layers[0].curves[1] = test::blurred(drawing.layers[0].curves[1], radius);
    return drawing;
  };
  const Document drawing = blurred(6);
  const Image picture = drawn_at_width(drawing);
  const Document back = fitted(scrambled(blurred(4.5f)), picture);
  EXPECT_NEAR(back.layers[0].curves[1].left.blur_radius.stops[0].value, 6, 0.4);
  EXPECT_EQ(back.layers[0].curves[1].right.blur_radius, back.layers[0].curves[1].left.blur_radius);
  for (const TraceBlur blur : {TraceBlur::estimated, TraceBlur::sharp}) {
    const Document kept = fitted(scrambled(blurred(4.5f)), picture, {.blur = blur});
    EXPECT_EQ(kept.layers[0].curves[1].left.blur_radius,
              blurred(4.5f).layers[0].curves[1].left.blur_radius);
  }
  const Document sharp = fitted(scrambled(disc_in_frame()), picture);
  EXPECT_TRUE(sharp.layers[0].curves[1].left.blur_radius.empty());
}

TEST(FitColors, chosen_curves_alone_are_fitted) {
  for (const InterpolationSpace space : {InterpolationSpace::srgb, InterpolationSpace::oklab}) {
    Document drawing = disc_in_frame();
    drawing.interpolation = space;
    add_layer(drawing, clear_disc({40, 45}, {rgb(0xe0a030), kGrey}, 0.6f));
    Document before = drawing;
    before.layers[1] = scrambled(drawing).layers[1];
    before.layers[0].curves[0].right.color.stops.stops[0].value = rgb(0x2868a0);
    const Image picture = drawn_at_width(drawing, 100);
    const Document back = fitted(before, picture, {.only = {{1, 0}}});
    EXPECT_EQ(back.layers[0].curves, before.layers[0].curves);
    Document of_chosen = back;
    of_chosen.layers[0] = drawing.layers[0];
    EXPECT_LE(largest_difference(of_chosen, drawing), 20);
    EXPECT_GT(psnr_to(back, picture), psnr_to(before, picture) + 5);
    const Document all = fitted(before, picture, {.only = {{0, 0}, {0, 1}, {1, 0}}});
    EXPECT_TRUE(test::same_document(all, fitted(before, picture)));
  }
}

TEST(FitColors, radii_are_found_without_colours) {
  const auto blurred = [](float disc, float other) {
    Document drawing = disc_in_frame();
    std::vector<Curve>& curves = drawing.layers[0].curves;
    curves[1] = test::blurred(curves[1], disc);
    curves.push_back(test::blurred(
        test::colored(test::circle_curve({12, 12}, 8), rgb(0x2060a0), rgb(0x40c040)), other));
    return drawing;
  };
  const Image picture = drawn_at_width(blurred(7, 4));
  const Document before = blurred(1, 1);
  const auto radius_of = [](const Document& drawing, std::size_t curve) {
    return drawing.layers[0].curves[curve].left.blur_radius.stops[0].value;
  };
  const Document both = fitted(before, picture, {.keeps_colors = true});
  EXPECT_EQ(largest_difference(both, before), 0);
  EXPECT_NEAR(radius_of(both, 1), 7, 0.5);
  EXPECT_NEAR(radius_of(both, 2), 4, 0.5);
  const Document one = fitted(before, picture, {.keeps_colors = true, .only = {{0, 2}}});
  EXPECT_EQ(radius_of(one, 1), 1);
  EXPECT_NEAR(radius_of(one, 2), 4, 0.5);
}

TEST(FitColors, stats_say_how_it_was_and_is) {
  const Document disc = disc_in_frame();
  const Image picture = drawn_at_width(disc);
  const Document before = scrambled(disc);
  TraceStats stats;
  const Document back = fitted(before, picture, {}, &stats);
  ASSERT_EQ(stats.rounds.size(), 2u);
  EXPECT_NEAR(stats.rounds[0].psnr_db, psnr_to(before, picture), 0.2);
  EXPECT_GT(stats.rounds[1].psnr_db, 40);
  EXPECT_EQ(stats.rounds[1].curves, 2u);
  EXPECT_EQ(stats.rounds[1].control_points, 13u + 13u);
  EXPECT_EQ(stats.rounds[1].stops, 3u);
  // A result that is as good as possible is not made worse.
  EXPECT_EQ(back.layers[0].curves, fitted(back, picture).layers[0].curves);
}

TEST(FitColors, refuses_what_it_cannot_fit) {
  Context context;
  const Image picture = drawn_at_width(disc_in_frame(), 50);
  const auto code_of = [&](const Document& drawing, const Image& image, const ColorFit& options) {
    return fit_colors(context, drawing, image, options).status().code;
  };
  EXPECT_EQ(code_of(disc_in_frame(), picture, {.max_side = 0}), StatusCode::bad_input);
  EXPECT_EQ(code_of(disc_in_frame(), picture, {.max_side = 1 << 20}), StatusCode::bad_input);
  EXPECT_EQ(code_of(disc_in_frame(), picture, {.blur = static_cast<TraceBlur>(7)}),
            StatusCode::bad_input);
  EXPECT_EQ(code_of(disc_in_frame(), picture, {.blur = TraceBlur::sharp, .keeps_colors = true}),
            StatusCode::bad_input);
  EXPECT_EQ(code_of(disc_in_frame(), picture, {.only = {{0, 1}, {0, 2}}}), StatusCode::bad_input);
  EXPECT_EQ(code_of(disc_in_frame(), picture, {.only = {{1, 0}}}), StatusCode::bad_input);
  EXPECT_EQ(code_of(disc_in_frame(), Image{}, {}), StatusCode::bad_input);
  Image cut = picture;
  cut.bytes.pop_back();
  EXPECT_EQ(code_of(disc_in_frame(), cut, {}), StatusCode::bad_input);
  Document invalid = disc_in_frame();
  invalid.layers[0].curves[0].control_points.pop_back();
  EXPECT_EQ(code_of(invalid, picture, {}), StatusCode::bad_input);
  EXPECT_EQ(code_of(test::one_layer({test::straight_curve({0, 0}, {9, 9})}), picture, {}),
            StatusCode::bad_input);
  Document unpainted = disc_in_frame();
  unpainted.stack.clear();
  EXPECT_EQ(code_of(unpainted, picture, {}), StatusCode::bad_input);
}

TEST(FitColors, has_the_same_bytes_for_any_number_of_threads) {
  Document drawing = disc_in_frame();
  drawing.layers[0].curves[1] = test::blurred(drawing.layers[0].curves[1], 5);
  add_layer(drawing, clear_disc({40, 45}, {rgb(0xe0a030), kGrey}, 0.6f), 0.5f);
  const Image picture = drawn_at_width(drawing);
  drawing.layers[0].curves[1] = test::blurred(drawing.layers[0].curves[1], 4);
  const Document before = scrambled(drawing);
  const Document expected = fitted(before, picture);
  for (const int threads : {1, 2, 3}) {
    ThreadPool pool(threads);
    Context context;
    context.executor = &pool;
    const Result<Document> back = fit_colors(context, before, picture);
    ASSERT_TRUE(back.ok());
    EXPECT_TRUE(test::same_document(*back, expected)) << threads;
    EXPECT_EQ(context.budget.used(), 0u);
  }
}

TEST(FitColors, can_be_cancelled_at_any_poll) {
  const Document before = scrambled(disc_in_frame());
  const Image picture = drawn_at_width(disc_in_frame(), 40);
  int cancelled = 0;
  for (std::uint64_t poll = 1; poll < 4'000'000; poll = 1 + poll * 3 / 2) {
    Context context;
    test::CancelAt at(poll, context.cancel);
    context.poll_watch = &at;
    const Result<Document> back = fit_colors(context, before, picture);
    if (back) break;
    ASSERT_EQ(back.status().code, StatusCode::cancelled);
    EXPECT_EQ(context.budget.used(), 0u);
    ++cancelled;
  }
  EXPECT_GT(cancelled, 15);
}

TEST(FitColors, beyond_a_budget_is_a_limit_error) {
  const Document before = scrambled(disc_in_frame());
  const Image picture = drawn_at_width(disc_in_frame(), 100);
  int failures = 0;
  for (std::size_t room = 1 << 12; room <= std::size_t{1} << 28; room *= 2) {
    Context poor;
    ASSERT_TRUE(poor.budget.charge(poor.budget.limit() - room, "the rest").ok());
    const Result<Document> back = fit_colors(poor, before, picture);
    failures += !back.ok();
    EXPECT_TRUE(back.ok() || back.status().code == StatusCode::limit);
  }
  EXPECT_GT(failures, 5);
  EXPECT_LT(failures, 16);
}

/// An example, and the least PSNR that it must reach again.
struct Example {
  const char* name;
  double psnr_db;
};

/// Layers mixed by blend modes keep their colours, so these are not scrambled.
Document scrambled_but_for_modes(const Document& document) {
  Document out = scrambled(document);
  std::size_t mixed = 0;
  for (const StackItem& item : document.stack) {
    if (const auto* group = std::get_if<GroupBegin>(&item)) {
      mixed += mixed > 0 || group->blend != BlendMode::normal;
    } else if (std::holds_alternative<GroupEnd>(item)) {
      mixed -= mixed > 0;
    } else if (const auto* instance = std::get_if<LayerInstance>(&item)) {
      if (mixed == 0 && instance->blend == BlendMode::normal) continue;
      out.layers[instance->layer] = document.layers[instance->layer];
    }
  }
  return out;
}

class FitColorsOf : public testing::TestWithParam<Example> {};

TEST_P(FitColorsOf, example_looks_as_it_did) {
  const std::string folder = test::source_path("examples/");
  const auto bytes = read_file(folder + GetParam().name, limits::kInputBytes);
  ASSERT_TRUE(bytes.ok());
  ThreadPool pool(2);
  Context context;
  context.executor = &pool;
  const test::FolderFiles files(folder);
  const Result<ReadDocument> read = read_document(context, *bytes, GetParam().name, &files);
  ASSERT_TRUE(read.ok()) << to_string(read.status());
  const Image picture = drawn_at_width(read->document, 240);
  const Document before = scrambled_but_for_modes(read->document);
  TraceStats stats;
  const Result<Document> back = fit_colors(context, before, picture, {}, &stats);
  ASSERT_TRUE(back.ok());
  EXPECT_LT(psnr_to(before, picture), 22);
  const double psnr_db = psnr_to(*back, picture);
  EXPECT_GT(psnr_db, GetParam().psnr_db);
  EXPECT_GT(stats.rounds[1].psnr_db, GetParam().psnr_db - 5) << "as the gather has it";
}

INSTANTIATE_TEST_SUITE_P(Examples, FitColorsOf,
                         testing::Values(Example{"portrait.svg", 40}, Example{"fish.svg", 35},
                                         Example{"sunset.svg", 40}, Example{"flower.svg", 35},
                                         Example{"apple.svg", 40}, Example{"blur.svg", 40},
                                         Example{"strokes.svg", 45}, Example{"textures.svg", 45}));

}  // namespace
}  // namespace sfumato
