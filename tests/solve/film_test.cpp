#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <random>
#include <span>
#include <string>
#include <vector>

#include "sfumato/api/render_pixels.hpp"
#include "sfumato/raster/rasterize.hpp"
#include "sfumato/solve/solution.hpp"
#include "solve/diffused.hpp"
#include "solve/mean_difference.hpp"
#include "solve/solved.hpp"
#include "support/cancel_at.hpp"
#include "support/drawing.hpp"
#include "support/random_document.hpp"
#include "support/same_picture.hpp"
#include "support/sanitizers.hpp"

/// Frames of films.
namespace sfumato {
namespace {

using test::blurred;
using test::circle_curve;
using test::colored;
using test::diffused;
using test::kBlue;
using test::kGreen;
using test::kRed;
using test::mean_difference;
using test::solution_of;

constexpr int kSide = 160;  ///< pixels
constexpr int kFrames = 24;
constexpr int kFrameStep = SFUMATO_HAS_SANITIZER ? 8 : 1;
constexpr DiffuseOptions kOptions{.pixels_per_unit = 1.6};

struct Disc {
  Vec2 center;
  double radius;
};

/// Discs inside a circle that encloses them, beyond its blur.
constexpr Disc kStill[] = {{{24, 30}, 11}, {{74, 74}, 9}};

Curve varied_circle(Vec2 center, double radius) {
  Curve circle = colored(circle_curve(center, radius), kGreen, kBlue);
  circle.right.color.stops = {StopSpace::parameter,
                              {{0, kRed}, {1, kGreen}, {2, {0.9f, 0.8f, 0.1f}}, {3, kBlue}}};
  return circle;
}

/// Returns a circle that moves past two still ones; it is blurred, and so is the second of them;
/// both have their own curves inside.
std::vector<Curve> curves_at(Vec2 moving) {
  return {colored(circle_curve({50, 50}, 46), kBlue, kGreen),
          varied_circle({24, 30}, 13),
          colored(circle_curve({24, 30}, 4), kRed, kBlue),
          blurred(colored(circle_curve(moving, 7), kBlue, kRed), 2),
          blurred(varied_circle({74, 74}, 14), 3),
          colored(circle_curve({74, 74}, 3), kGreen, kRed)};
}

Vec2 place_at(int frame) {
  const double t = frame / double{kFrames - 1};
  return {46 + 6 * t, 18 + 60 * t};
}

Image pixels_of(const Picture& picture) {
  Context context;
  RasterOptions options;
  options.width = options.height = kSide;
  Result<Image> image = rasterize(context, picture, options);
  EXPECT_TRUE(image.ok());
  return std::move(*image);
}

/// Returns the largest difference of a channel inside the discs or, without discs, anywhere.
int largest_difference(const Image& a, const Image& b, std::span<const Disc> discs) {
  int largest = 0;
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      const Vec2 p = (100.0 / kSide) * Vec2{x + 0.5, y + 0.5};
      const auto holds = [&](const Disc& disc) {
        return length(p - disc.center) < disc.radius - 1;
      };
      if (!discs.empty() && std::ranges::none_of(discs, holds)) continue;
      for (std::size_t c = 0; c < 3; ++c) {
        const std::size_t i = 3 * static_cast<std::size_t>(kSide * y + x) + c;
        largest = std::max(largest, std::abs(int{a.bytes[i]} - int{b.bytes[i]}));
      }
    }
  }
  return largest;
}

/// A Solution whose frames follow documents.
class Film {
 public:
  /// Shows a document. Returns how its layers were made.
  FrameLayers show(Document document, const DiffuseOptions& options = kOptions) {
    FrameLayers layers;
    if (solution_) {
      EXPECT_TRUE(solution_->apply(context_, ReplaceDocument{std::move(document)}).ok());
    } else {
      solution_.emplace(solution_of(context_, std::move(document)));
    }
    const Status status = solution_->solve_next(context_, options, &layers);
    EXPECT_TRUE(status.ok()) << to_string(status);
    return layers;
  }
  Solution& solution() { return *solution_; }
  const Picture& picture() const { return solution_->picture(); }
  Context& context() { return context_; }

 private:
  Context context_;
  std::optional<Solution> solution_;
};

TEST(Films, where_nothing_moves_no_pixel_does) {
  Film film;
  std::vector<Image> frames;
  for (int i = 0; i < kFrames; ++i) {
    const FrameLayers layers = film.show(test::one_layer(curves_at(place_at(i))));
    EXPECT_EQ(layers.begun, i == 0 ? 1u : 0u) << i;
    EXPECT_EQ(layers.continued, i == 0 ? 0u : 1u) << i;
    frames.push_back(pixels_of(film.picture()));
  }
  for (int i = 1; i < kFrames; ++i) {
    const auto f = static_cast<std::size_t>(i);
    EXPECT_LE(largest_difference(frames[f - 1], frames[f], kStill), 1) << i;
    EXPECT_LE(largest_difference(frames[0], frames[f], kStill), 1) << "over the whole film, " << i;
    EXPECT_GT(largest_difference(frames[f - 1], frames[f], {}), 20) << "something moves, " << i;
  }
}

/// The differences of pixels from the exact solution, which has no smooth edges: near curves, the
/// other two are not compared with it.
struct Misses {
  double shown = 0, solved = 0;         ///< mean, code values
  int many_shown = 0, many_solved = 0;  ///< channels that differ by more than the bound

  Misses(const Image& film, const Image& alone, const Image& exact) {
    constexpr int kEdge = 8, kBound = 2;  // with rounding
    int count = 0;
    for (std::size_t i = 0; i < exact.bytes.size(); ++i) {
      const int of_film = std::abs(int{film.bytes[i]} - int{exact.bytes[i]});
      const int of_alone = std::abs(int{alone.bytes[i]} - int{exact.bytes[i]});
      if (of_alone > kEdge) continue;
      ++count;
      shown += of_film;
      solved += of_alone;
      many_shown += of_film > kBound;
      many_solved += of_alone > kBound;
    }
    shown /= count;
    solved /= count;
  }
};

Image exact_pixels_of(const Document& document) {
  Context context;
  RasterOptions options;
  options.width = options.height = kSide;
  options.antialias = false;
  Result<Image> image = render_pixels(context, document, kOptions, options);
  EXPECT_TRUE(image.ok());
  return std::move(*image);
}

TEST(Films, frames_are_as_exact_as_those_of_the_drawings_alone) {
  Film film;
  for (int i = 0; i < kFrames; i += kFrameStep) {
    const Document document = test::one_layer(curves_at(place_at(i)));
    film.show(document);
    const Picture alone = diffused(document, kOptions);
    const Misses misses(pixels_of(film.picture()), pixels_of(alone), exact_pixels_of(document));
    EXPECT_LT(misses.shown, 1.1 * misses.solved + 0.02) << i;
    EXPECT_LE(misses.many_shown, misses.many_solved + 10) << i;
    EXPECT_LT(mean_difference(film.picture(), alone, kSide), 0.1) << i;
    EXPECT_LT(film.picture().layers[0].triangle_count(), 2 * alone.layers[0].triangle_count()) << i;
  }
}

/// A frame's refinement is kept in the next one, so that nothing flickers.
TEST(Films, a_curve_that_goes_back_and_forth_finds_its_mesh_again) {
  Film film;
  const auto show = [&](int frame) {
    film.show(test::one_layer(curves_at(place_at(frame))));
    return pixels_of(film.picture());
  };
  show(4);
  const Image first = show(5);
  show(4);
  const std::uint32_t triangles = film.picture().layers[0].triangle_count();
  for (int i = 0; i < 3; ++i) {
    EXPECT_LE(largest_difference(show(5), first, {}), 1) << i;
    show(4);
    EXPECT_NEAR(film.picture().layers[0].triangle_count(), triangles, 0.01 * triangles) << i;
  }
}

/// Meanwhile, the mesh is reset several times.
TEST(Films, a_long_way_leaves_no_mesh_behind) {
  Film film;
  std::optional<Image> first;
  std::uint32_t most = 0, fresh = 0;
  int went_back = 0;
  for (int i = 0; i < 40; i += kFrameStep) {
    const std::uint32_t before = first ? film.picture().layers[0].triangle_count() : 0;
    film.show(test::one_layer(curves_at({50 + 3 * std::sin(i), 22 + 1.4 * i})));
    const std::uint32_t triangles = film.picture().layers[0].triangle_count();
    if (i == 0) fresh = triangles;
    went_back += triangles < before;
    most = std::max(most, triangles);
    const Image pixels = pixels_of(film.picture());
    if (!first) first = pixels;
    EXPECT_LE(largest_difference(*first, pixels, kStill), 1) << i;
  }
  EXPECT_LT(most, 3 * fresh);
  EXPECT_TRUE(went_back >= 2 || kFrameStep > 1);
}

TEST(Films, other_layers_are_kept) {
  Film film;
  Document document = test::one_layer(curves_at(place_at(0)));
  document.layers.push_back({"above", {colored(circle_curve({70, 20}, 9), kGreen, kRed)}});
  document.stack.push_back(LayerInstance{1, {}, 0.5f});
  EXPECT_EQ(film.show(document).begun, 2u);
  document.layers[0].curves = curves_at(place_at(1));
  FrameLayers layers = film.show(document);
  EXPECT_EQ(layers.continued, 1u);
  EXPECT_EQ(layers.kept, 1u);
  document.background = kRed;
  layers = film.show(document);
  EXPECT_EQ(layers.kept, 2u);
  EXPECT_EQ(film.picture().background, kRed);
}

TEST(Films, are_begun_anew_where_the_mesh_cannot_go_on) {
  const std::vector<Curve> first = curves_at(place_at(3));
  std::vector<std::vector<Curve>> others(6, first);
  others[0].push_back(colored(circle_curve({80, 30}, 5), kRed, kGreen));  // one more
  others[1].pop_back();                                                   // one less
  for (std::size_t i = 1; i < 5; ++i) others[2][i].weight = 2;            // most of them
  others[3][3] = colored(circle_curve({900, 50}, 4), kRed, kGreen);       // far away
  others[4][3] = test::with_opacity(first[3], 0.5f, 1);                   // another attribute
  others[5][1] = colored(circle_curve({24, 30}, 4), kGreen, kRed);        // below another one
  for (std::size_t i = 0; i < others.size(); ++i) {
    Film film;
    film.show(test::one_layer(first));
    const Document document = test::one_layer(others[i]);
    EXPECT_EQ(film.show(document).begun, 1u) << i;
    EXPECT_LT(mean_difference(film.picture(), diffused(document, kOptions), kSide), 0.1) << i;
    const Document next = test::one_layer(first);
    film.show(next);
    EXPECT_LT(mean_difference(film.picture(), diffused(next, kOptions), kSide), 0.1) << i;
  }
  Film film;
  film.show(test::one_layer(first));
  EXPECT_EQ(film.show(test::one_layer(first), {.pixels_per_unit = 2}).begun, 1u);
  EXPECT_EQ(film.show(test::one_layer(first, {{0, 0}, {100, 90}}), {.pixels_per_unit = 2}).begun,
            1u);
}

/// Its pixels are then solve()'s, and a film continues from there.
TEST(Films, of_a_context_of_its_own_are_solved_each_for_itself) {
  Film film;
  film.show(test::one_layer(curves_at(place_at(0))));
  const Document document = test::one_layer(curves_at(place_at(1)));
  ASSERT_TRUE(film.solution().apply(film.context(), ReplaceDocument{document}).ok());
  Context other;
  FrameLayers layers;
  ASSERT_TRUE(film.solution().solve_next(other, kOptions, &layers).ok());
  EXPECT_EQ(layers.begun, 1u);
  EXPECT_EQ(test::difference_of(film.picture(), diffused(document, kOptions)), "");
  EXPECT_EQ(film.show(test::one_layer(curves_at(place_at(2)))).begun, 1u);
  EXPECT_EQ(film.show(test::one_layer(curves_at(place_at(3)))).continued, 1u);
}

/// solve() makes the exact picture of the document, whatever frames came before.
TEST(Films, end_in_the_picture_of_diffuse) {
  Film film;
  for (int i = 0; i < 3; ++i) film.show(test::one_layer(curves_at(place_at(i))));
  ASSERT_TRUE(film.solution().solve(film.context(), kOptions).ok());
  EXPECT_EQ(test::difference_of(film.picture(), diffused(film.solution().document(), kOptions)),
            "");
}

TEST(Films, with_little_memory_are_solved_without_what_is_kept_or_are_as_they_were) {
  int shown = 0, refused = 0;
  for (std::size_t room = 1000; shown < 3; room *= 2) {
    Film film;
    film.show(test::one_layer(curves_at(place_at(0))));
    const std::size_t others =
        film.context().budget.room() - std::min(room, film.context().budget.room());
    ASSERT_TRUE(film.context().budget.charge(others, "others").ok());
    const Picture before = film.picture();
    const Document document = test::one_layer(curves_at(place_at(1)));
    Status status = film.solution().apply(film.context(), ReplaceDocument{document}).status();
    if (status) status = film.solution().solve_next(film.context(), kOptions);
    if (status) {
      ++shown;
      EXPECT_LT(mean_difference(film.picture(), diffused(document, kOptions), kSide), 0.1) << room;
    } else {
      ++refused;
      EXPECT_EQ(status.code, StatusCode::limit) << to_string(status);
      EXPECT_EQ(test::difference_of(film.picture(), before), "") << room;
    }
    film.context().budget.release(others);
  }
  EXPECT_GT(refused, 0);
}

TEST(Films, that_are_cancelled_keep_the_last_frame) {
  Film film;
  film.show(test::one_layer(curves_at(place_at(0))));
  const Picture before = film.picture();
  const Document document = test::one_layer(curves_at(place_at(1)));
  ASSERT_TRUE(film.solution().apply(film.context(), ReplaceDocument{document}).ok());
  int cancelled = 0;
  for (std::uint64_t poll = 100;; poll *= 3) {
    film.context().cancel.store(false);
    test::CancelAt watch(poll, film.context().cancel);
    film.context().poll_watch = &watch;
    const Status status = film.solution().solve_next(film.context(), kOptions);
    film.context().poll_watch = nullptr;
    if (status) break;
    ++cancelled;
    ASSERT_EQ(status.code, StatusCode::cancelled);
    ASSERT_EQ(test::difference_of(film.picture(), before), "");
  }
  EXPECT_GT(cancelled, 3);
  EXPECT_LT(mean_difference(film.picture(), diffused(document, kOptions), kSide), 0.1);
}

/// Moves a random curve of a layer that has others.
void move_a_curve(std::mt19937& random, Document& document) {
  std::vector<std::uint32_t> choices;
  for (std::uint32_t i = 0; i < document.layers.size(); ++i) {
    if (document.layers[i].curves.size() > 1) choices.push_back(i);
  }
  if (choices.empty()) return;
  std::vector<Curve>& curves = document.layers[choices[random() % choices.size()]].curves;
  const Vec2 by{static_cast<double>(random() % 9) - 4, static_cast<double>(random() % 9) - 4};
  for (Vec2& point : curves[random() % curves.size()].control_points) point = point + by;
}

/// Random documents with all features.
TEST(Films, of_random_documents_are_those_of_the_drawings) {
  constexpr std::uint32_t kDocuments = 10;
  std::size_t continued = 0;
  for (std::uint32_t seed = 0; seed < kDocuments; ++seed) {
    std::mt19937 random(seed);
    Document document = test::random_document(4000 + seed);
    Film film;
    film.show(document);
    for (int step = 0; step < 3; ++step) {
      move_a_curve(random, document);
      continued += film.show(document).continued;
      const Picture alone = diffused(document, kOptions);
      const double missed = mean_difference(film.picture(), alone, 96);
      EXPECT_LT(missed, 0.15) << seed << ", " << step;
    }
  }
  EXPECT_GT(continued, kDocuments);
}

}  // namespace
}  // namespace sfumato
