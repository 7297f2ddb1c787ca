// trace(): drawings that resemble their pictures, and the effects of options.
#include "sfumato/trace/trace.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "sfumato/lint/lint.hpp"
#include "support/flat_art.hpp"
#include "support/found_curves.hpp"
#include "support/synthetic_photo.hpp"
#include "trace/tracing.hpp"

namespace sfumato {
namespace {

Image flat(const std::string& name, bool has_background = true, double scale = 1) {
  Context context;
  const Result<Image> image = test::flat_picture(context, name, has_background, scale);
  EXPECT_TRUE(image.ok()) << to_string(image.status());
  return image.ok() ? *image : Image{};
}

TEST(Trace, draws_a_photo_and_predicts_how_well) {
  const Image photo = test::synthetic_photo(240);
  TraceStats stats;
  const Document drawing = test::trace_of(photo, {.points = 1000}, &stats);
  const double rendered = test::rendered_psnr_db(drawing, photo);
  RecordProperty("psnr", std::to_string(rendered));
  EXPECT_GE(rendered, 34);
  ASSERT_FALSE(stats.rounds.empty());
  EXPECT_NEAR(stats.rounds.back().psnr_db, rendered, 0.3);
  EXPECT_NEAR(stats.noise, 2 / 255.0, 1 / 255.0);
  EXPECT_EQ(stats.scale, 1);
}

class ProgressLog : public Progress {
 public:
  void report(std::string_view stage, double fraction) override {
    EXPECT_EQ(stage, "trace");
    fractions.push_back(fraction);
  }
  std::vector<double> fractions;
};

TEST(Trace, tells_one_progress_from_its_beginning_to_its_end) {
  ProgressLog log;
  Context context{.progress = &log};
  ASSERT_TRUE(trace(context, test::synthetic_photo(120), {}).ok());
  EXPECT_GT(log.fractions.size(), 5u);
  EXPECT_TRUE(std::ranges::is_sorted(log.fractions));
  EXPECT_EQ(log.fractions.back(), 1);
  EXPECT_EQ(context.progress, &log);
}

TEST(Trace, says_what_the_drawing_has) {
  TraceStats stats;
  const Document drawing = test::trace_of(test::synthetic_photo(120), {}, &stats);
  const TraceState& end = stats.rounds.back();
  EXPECT_EQ(end.curves, test::curve_count(drawing));
  EXPECT_EQ(end.control_points, test::point_count(drawing));
  std::size_t stops = 0;
  for (const Curve& curve : drawing.layers[0].curves) {
    stops += curve.left.color.stops.stops.size() + curve.right.color.stops.stops.size();
  }
  EXPECT_EQ(end.stops, stops);
  for (std::size_t i = 1; i < stats.rounds.size(); ++i) {
    EXPECT_GE(stats.rounds[i].round, stats.rounds[i - 1].round);
    EXPECT_GE(stats.rounds[i].seconds, stats.rounds[i - 1].seconds);
    EXPECT_LT(stats.rounds[i].round, stats.rounds[i].round_count);
  }
}

void expect_no_hints(const Document& drawing) {
  Context context;
  const auto hints = lint(context, drawing);
  ASSERT_TRUE(hints.ok()) << to_string(hints.status());
  for (const Hint& hint : *hints) {
    if (!is_note(hint.kind)) ADD_FAILURE() << hint_name(hint.kind) << ": " << hint.message;
  }
}

TEST(Trace, finds_the_curves_of_a_drawing_again) {
  const Document truth = test::evening();
  const Image picture = test::picture_of(truth, 512);
  const Document drawing = test::trace_of(picture, {.points = 870});
  EXPECT_GE(test::rendered_psnr_db(drawing, picture), 34.5);
  const test::FoundCurves found = test::find_curves(truth, drawing, test::planes_of(picture));
  EXPECT_GE(found.found_share, 0.85);
  expect_no_hints(drawing);
}

/// The quality that a trace of flat art must reach.
struct FlatCase {
  const char* name;
  double psnr_db;
  double found_share;
  double true_share;
};

class FlatTrace : public testing::TestWithParam<FlatCase> {};

TEST_P(FlatTrace, looks_like_it_with_its_curves) {
  const FlatCase& least = GetParam();
  const Image picture = flat(least.name);
  Context context;
  const Result<Document> truth = test::flat_art(context, least.name);
  ASSERT_TRUE(truth.ok());
  const Document drawing = test::trace_of(picture);
  const test::FoundCurves found = test::find_curves(*truth, drawing, test::planes_of(picture));
  const double rendered = test::rendered_psnr_db(drawing, picture);
  EXPECT_GE(rendered, least.psnr_db);
  EXPECT_GE(found.found_share, least.found_share);
  EXPECT_GE(found.true_share, least.true_share);
  expect_no_hints(drawing);
}

INSTANTIATE_TEST_SUITE_P(
    Of, FlatTrace,
    testing::Values(FlatCase{"gear", 34.2, 0.95, 0.95}, FlatCase{"map", 37.9, 0.95, 0.73},
                    FlatCase{"flag", 33.3, 0.95, 0.74}, FlatCase{"logo", 32.4, 0.95, 0.86},
                    FlatCase{"checker", 32.9, 0.95, 0.52}, FlatCase{"face", 30.3, 0.85, 0.75},
                    FlatCase{"fish", 30.5, 0.9, 0.65}),
    [](const auto& instance) { return std::string(instance.param.name); });

TEST(Trace, has_a_frame_along_the_artboard_at_whatever_size_it_looks) {
  const Image photo = test::synthetic_photo(148);  // 148 × 111
  for (const int side : {20, 50, 64, 100}) {
    const Document drawing = test::trace_of(photo, {.points = 13, .max_side = side});
    const Curve& frame = drawing.layers.at(0).curves.at(0);
    EXPECT_EQ(frame.control_points.at(6).x, photo.width) << side;
    EXPECT_EQ(frame.control_points.at(6).y, photo.height) << side;
  }
}

TEST(Trace, gives_a_transparent_picture_opacity) {
  const Image picture = flat("gear", false);
  const Document drawing = test::trace_of(picture);
  EXPECT_GE(test::rendered_psnr_db(drawing, picture, {1, 1, 1}), 30);
  EXPECT_GE(test::rendered_psnr_db(drawing, picture, {0, 0, 0}), 30);
  const Document solid = test::trace_of(picture, {.has_opacity = false});
  EXPECT_GE(test::rendered_psnr_db(solid, picture, {1, 1, 1}), 30);
  EXPECT_LT(test::rendered_psnr_db(solid, picture, {0, 0, 0}), 15);
}

TEST(Trace, loses_little_where_it_leaves_stops_out) {
  const Image photo = test::synthetic_photo(160);
  std::vector<double> psnr;
  std::vector<std::size_t> stops;
  for (const TraceStops amount : {TraceStops::many, TraceStops::normal, TraceStops::few}) {
    TraceStats stats;
    psnr.push_back(test::rendered_psnr_db(test::trace_of(photo, {.stops = amount}, &stats), photo));
    stops.push_back(stats.rounds.back().stops);
  }
  EXPECT_LT(static_cast<double>(stops[1]), 0.75 * static_cast<double>(stops[0]));
  EXPECT_LT(static_cast<double>(stops[2]), 0.6 * static_cast<double>(stops[0]));
  EXPECT_GE(psnr[1], psnr[0] - 0.3);
  EXPECT_GE(psnr[2], psnr[0] - 0.8);
}

TEST(Trace, ends_once_it_has_reached_the_psnr) {
  const Image photo = test::synthetic_photo(120);
  TraceStats all, some;
  test::trace_of(photo, {}, &all);
  test::trace_of(photo, {.psnr_db = all.rounds[0].psnr_db + 0.01}, &some);
  EXPECT_LT(some.rounds.size(), all.rounds.size());
  EXPECT_GE(some.rounds.back().psnr_db, all.rounds[0].psnr_db - 0.5);
}

TEST(Trace, has_at_most_the_points_and_curves_that_are_asked_for) {
  const Image photo = test::synthetic_photo(120);
  constexpr std::size_t kFrame = 13;
  for (const int points : {1, 13, 40, 100, 400}) {
    const Document drawing = test::trace_of(photo, {.points = points});
    EXPECT_LE(test::point_count(drawing), std::max<std::size_t>(points, kFrame));
  }
  for (const int curves : {1, 2, 7}) {
    EXPECT_LE(test::curve_count(test::trace_of(photo, {.max_curves = curves})), curves);
  }
}

TEST(Trace, ends_after_the_edges_for_a_draft) {
  const Image photo = test::synthetic_photo(120);
  TraceStats draft, whole;
  test::trace_of(photo, {.edges_only = true}, &draft);
  test::trace_of(photo, {}, &whole);
  EXPECT_EQ(draft.rounds.back().round, 0);
  EXPECT_EQ(draft.rounds.back().round_count, 1);
  EXPECT_GT(draft.rounds.back().curves, 1u);
  EXPECT_LT(draft.rounds.back().curves, whole.rounds.back().curves);
  EXPECT_EQ(draft.rounds.front().control_points, whole.rounds.front().control_points);
}

double largest_radius(const Document& drawing) {
  double most = 0;
  for (const Curve& curve : drawing.layers[0].curves) {
    for (const Side* side : {&curve.left, &curve.right}) {
      for (const auto& stop : side->blur_radius.stops) most = std::max(most, double{stop.value});
    }
  }
  return most;
}

TEST(Trace, has_blur_but_where_it_is_to_be_sharp) {
  const Image photo = test::synthetic_photo(160);
  EXPECT_EQ(largest_radius(test::trace_of(photo, {.blur = TraceBlur::sharp})), 0);
  EXPECT_GT(largest_radius(test::trace_of(photo, {.blur = TraceBlur::estimated})), 2);
  EXPECT_GT(largest_radius(test::trace_of(photo, {.blur = TraceBlur::fitted})), 2);
}

/// In one picture a single curve decides, so several are compared, each with a tolerance of a tenth
/// of a decibel.
TEST(Trace, does_not_lose_by_fitted_blur) {
  double gain = 0;
  for (const int side : {120, 160, 200, 240}) {
    const Image photo = test::synthetic_photo(side);
    const auto psnr_db = [&](TraceBlur blur) {
      return test::rendered_psnr_db(test::trace_of(photo, {.blur = blur}), photo);
    };
    gain += psnr_db(TraceBlur::fitted) - psnr_db(TraceBlur::estimated);
  }
  EXPECT_GT(gain, -0.4);
}

TEST(Trace, looks_at_a_large_picture_scaled_down) {
  Image wide{1500, 20, PixelFormat::rgb8, {}};
  for (int y = 0; y < 20; ++y) {
    for (int x = 0; x < 1500; ++x) {
      const auto value = static_cast<std::uint8_t>(x < 700 ? 40 : 200);
      wide.bytes.insert(wide.bytes.end(), {value, value, 90});
    }
  }
  TraceStats stats;
  const Document drawing = test::trace_of(wide, {}, &stats);
  EXPECT_NEAR(stats.scale, 1024.0 / 1500, 1e-3);
  EXPECT_GE(test::rendered_psnr_db(drawing, wide), 35);
  test::trace_of(wide, {.max_side = 2000}, &stats);
  EXPECT_EQ(stats.scale, 1);
}

TEST(Trace, takes_fine_texture_for_none_where_it_is_to_smooth) {
  Image stripes{120, 90, PixelFormat::rgb8, {}};
  for (int y = 0; y < 90; ++y) {
    for (int x = 0; x < 120; ++x) {
      const auto value =
          static_cast<std::uint8_t>((x < 60 ? 80 : 170) + (x / 3 % 2 == 0 ? 15 : -15));
      stripes.bytes.insert(stripes.bytes.end(), 3, value);
    }
  }
  TraceStats fine, smooth;
  test::trace_of(stripes, {.edges_only = true}, &fine);
  test::trace_of(stripes, {.smooth_px = 6, .edges_only = true}, &smooth);
  EXPECT_GT(fine.rounds.back().curves, smooth.rounds.back().curves + 5);
  EXPECT_GE(smooth.rounds.back().curves, 2u);
}

/// Returns an ellipse's ring that the picture's sides cut, black on a transparent ground, four
/// samples per pixel side.
Image cut_ring(int side) {
  Image image{side, side, PixelFormat::rgba8, {}};
  const auto covers = [side](double x, double y) {
    const double u = 2 * x / side - 1, v = 2 * y / side - 1;
    return u * u / 1.21 + v * v / 0.64 < 1 && u * u / 0.44 + v * v / 0.21 > 1;
  };
  for (int i = 0; i < side * side; ++i) {
    int count = 0;
    for (int k = 0; k < 16; ++k) {
      count += covers(i % side + (k % 4 + 0.5) / 4, i / side + (k / 4 + 0.5) / 4);
    }
    image.bytes.insert(image.bytes.end(), {0, 0, 0, static_cast<std::uint8_t>(255 * count / 16)});
  }
  return image;
}

TEST(Trace, opacity_counts_in_what_is_reached_and_said) {
  const Image ring = cut_ring(150);
  TraceStats stats, wished;
  const Document drawing = test::trace_of(ring, {}, &stats);
  const double on_white = test::rendered_psnr_db(drawing, ring, {1, 1, 1});
  EXPECT_GE(on_white, 28);
  EXPECT_NEAR(stats.rounds.back().psnr_db, on_white, 4);
  test::trace_of(ring, {.psnr_db = stats.rounds[0].psnr_db + 0.01}, &wished);
  EXPECT_GT(wished.rounds.size(), 2u);
}

/// Returns level stripes of two pixels.
Image stripes(int side) {
  Image image{side, side, PixelFormat::rgb8, {}};
  for (int y = 0; y < side; ++y) {
    image.bytes.resize(image.bytes.size() + image.row_bytes(),
                       static_cast<std::uint8_t>(y / 2 % 2 == 0 ? 0 : 255));
  }
  return image;
}

TEST(Trace, stops_and_memory_follow_the_control_points_whatever_the_edges) {
  const Image picture = stripes(400);
  TraceStats stats;
  Context context{.budget = Budget(std::size_t{100} << 20)};
  const Result<Document> drawing =
      trace(context, picture, {.points = 100, .stops = TraceStops::many}, &stats);
  ASSERT_TRUE(drawing.ok()) << to_string(drawing.status());
  const Curve& frame = drawing->layers.at(0).curves.at(0);
  EXPECT_LE(frame.right.color.stops.stops.size(), 300u);
  EXPECT_LE(stats.rounds.back().stops, 2200u);
}

/// Ends the time at the first report of a round.
class LateWatch : public TraceWatch {
 public:
  LateWatch(Context& context, std::size_t round) : context_(context), left_(round + 2) {}
  void reached(const TraceState&, const Document& drawing) override {
    if (--left_ == 0) context_.deadline = Deadline::in(-1);
    told = test::svg_of(drawing);
  }
  std::string told;

 private:
  Context& context_;
  std::size_t left_;
};

TEST(Trace, keeps_the_drawing_of_its_last_round_where_time_is_over) {
  const Image photo = test::synthetic_photo(120);
  for (const int round : {0, 1, 4}) {
    Context context;
    context.deadline = Deadline::in(3600);
    LateWatch watch(context, static_cast<std::size_t>(round));
    TraceStats stats;
    const Result<Document> drawing = trace(context, photo, {.watch = &watch}, &stats);
    ASSERT_TRUE(drawing.ok()) << to_string(drawing.status());
    EXPECT_TRUE(stats.ended_early);
    EXPECT_EQ(stats.rounds.back().round, round);
    EXPECT_EQ(stats.rounds.back().curves, test::curve_count(*drawing));
    EXPECT_EQ(test::svg_of(*drawing), watch.told);
    EXPECT_GE(test::rendered_psnr_db(*drawing, photo), 20);
    EXPECT_EQ(context.budget.used(), 0u);
  }
}

TEST(Trace, says_nothing_of_time_where_there_was_enough) {
  TraceStats stats;
  test::trace_of(test::synthetic_photo(80), {.max_seconds = 3600}, &stats);
  EXPECT_FALSE(stats.ended_early);
}

/// Counts its reports.
class CountingWatch : public TraceWatch {
 public:
  void reached(const TraceState& state, const Document& drawing) override {
    states.push_back(state);
    Context context;
    EXPECT_TRUE(validate(context, drawing).ok());
    EXPECT_EQ(test::curve_count(drawing), state.curves);
    EXPECT_EQ(test::point_count(drawing), state.control_points);
  }
  std::vector<TraceState> states;
};

TEST(Trace, tells_its_watch_of_edges_and_of_each_round) {
  CountingWatch watch;
  TraceStats stats;
  test::trace_of(test::synthetic_photo(120), {.watch = &watch}, &stats);
  ASSERT_EQ(watch.states.size(), stats.rounds.size() + 1);
  EXPECT_EQ(watch.states[0].psnr_db, 0);
  for (std::size_t i = 0; i < stats.rounds.size(); ++i) {
    EXPECT_EQ(watch.states[i + 1].round, stats.rounds[i].round);
    EXPECT_EQ(watch.states[i + 1].psnr_db, stats.rounds[i].psnr_db);
  }
}

}  // namespace
}  // namespace sfumato
