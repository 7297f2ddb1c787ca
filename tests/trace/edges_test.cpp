// Edges are found where they exist, and only there; chains that meet.
#include "trace/image/edges.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "support/poll_gap.hpp"
#include "trace/curves/chains.hpp"
#include "trace/planes_of.hpp"
#include "trace/tracing.hpp"

namespace sfumato::tracing {
namespace {

EdgeMap edges_of(Context& context, const Plane& plane, const EdgeOptions& options = {}) {
  Result<EdgeMap> edges = find_edges(context, std::span(&plane, 1), options);
  EXPECT_TRUE(edges.ok()) << to_string(edges.status());
  return edges.ok() ? std::move(*edges) : EdgeMap{};
}

std::vector<Chain> chains_of(const EdgeMap& edges) {
  Context context;
  TableMemory memory("chains");
  Result<std::vector<Chain>> chains = link_chains(context, edges, memory);
  EXPECT_TRUE(chains.ok()) << to_string(chains.status());
  return chains.ok() ? std::move(*chains) : std::vector<Chain>{};
}

/// Calls visit(place on the edge, strength) for each pixel that has one.
template <class Visit>
int each_edge(const EdgeMap& edges, Visit visit) {
  int count = 0;
  for (int y = 0; y < edges.height; ++y) {
    for (int x = 0; x < edges.width; ++x) {
      const EdgePixel& edge = edges.at(x, y);
      if (!(edge.scale > 0)) continue;
      ++count;
      visit(Vec2{x + 0.5 + double{edge.offset_x}, y + 0.5 + double{edge.offset_y}}, edge.strength);
    }
  }
  return count;
}

TEST(FindEdges, finds_a_step_between_pixels) {
  Context context;
  for (const double place : {20.0, 20.2, 20.5, 20.7}) {
    const EdgeMap edges = edges_of(
        context, test::plane_of(40, 30, [&](Vec2 p) { return 0.3 * test::cover(p.x - place); }));
    const int count = each_edge(edges, [&](Vec2 at, float) { EXPECT_NEAR(at.x, place, 0.1); });
    EXPECT_GE(count, 28) << place;
    EXPECT_LE(count, 32) << place;
  }
}

TEST(FindEdges, finds_a_slanted_step_between_pixels) {
  Context context;
  for (const double angle_deg : {10.0, 30.0, 45.0, 70.0}) {
    const double angle = angle_deg * std::numbers::pi / 180;
    const auto distance = [&](Vec2 p) {
      return std::cos(angle) * (p.x - 30.3) + std::sin(angle) * (p.y - 29.8);
    };
    const EdgeMap edges = edges_of(context, test::cover_plane(60, 60, distance));
    int near_border = 0;
    const int count = each_edge(edges, [&](Vec2 at, float) {
      if (at.x < 5 || at.y < 5 || at.x > 55 || at.y > 55) return void(++near_border);
      EXPECT_NEAR(distance(at), 0, 0.1) << angle_deg;
    });
    EXPECT_GE(count - near_border, 45) << angle_deg;
  }
}

TEST(FindEdges, says_how_strong_a_step_is) {
  Context context;
  for (const double height : {0.1, 0.4}) {
    const EdgeMap edges = edges_of(
        context, test::plane_of(40, 30, [&](Vec2 p) { return height * test::cover(p.x - 20); }));
    each_edge(edges,
              [&](Vec2, float strength) { EXPECT_NEAR(strength, 0.4 * height, 0.05 * height); });
  }
}

TEST(FindEdges, finds_soft_steps_at_coarser_scales) {
  Context context;
  const EdgeMap edges = edges_of(context, test::plane_of(80, 40, [&](Vec2 p) {
                                   return 0.06 * test::blurred_step(p.x - 40, 4);
                                 }));
  const int count = each_edge(edges, [&](Vec2 at, float) { EXPECT_NEAR(at.x, 40, 0.3); });
  EXPECT_GE(count, 35);
  EXPECT_GT(edges.at(39, 20).scale + edges.at(40, 20).scale, 1.5f);
}

TEST(FindEdges, finds_nothing_in_one_color) {
  Context context;
  for (const auto& [width, height] : {std::pair{1, 1}, {1, 50}, {50, 1}, {60, 40}}) {
    const EdgeMap edges =
        edges_of(context, test::plane_of(width, height, [](Vec2) { return 0.4; }));
    EXPECT_EQ(each_edge(edges, [](Vec2, float) {}), 0) << width << " x " << height;
  }
}

TEST(FindEdges, finds_next_to_nothing_in_noise) {
  Context context;
  const double deviation = 4 / 255.0;
  for (std::uint32_t seed = 1; seed <= 3; ++seed) {
    Plane plane = test::plane_of(200, 150, [](Vec2) { return 0.4; });
    test::add_noise(plane, deviation, seed);
    EdgeOptions options;
    options.noise = deviation;
    const int count = each_edge(edges_of(context, plane, options), [](Vec2, float) {});
    EXPECT_LT(count, 0.003 * 200 * 150) << "seed " << seed;
  }
}

TEST(FindEdges, finds_nothing_where_something_is_taken) {
  const Plane plane = test::plane_of(40, 30, [](Vec2 p) { return 0.3 * test::cover(p.x - 20); });
  const Plane taken = test::plane_of(40, 30, [](Vec2 p) { return p.x == 19.5 ? 0.0 : 1e10; });
  Context context;
  const Result<EdgeMap> edges = find_edges(context, std::span(&plane, 1), {}, taken);
  ASSERT_TRUE(edges.ok());
  EXPECT_EQ(each_edge(*edges, [](Vec2, float) {}), 0);
}

double distance_to(const Chain& chain, Vec2 p) {
  double least = std::numeric_limits<double>::infinity();
  for (const Vec2 q : chain.point) least = std::min(least, length(q - p));
  return least;
}

TEST(LinkChains, makes_a_circle_one_closed_chain) {
  Context context;
  for (const double radius : {8.0, 15.0, 22.0, 30.0}) {
    const Vec2 center{40.3, 39.6};
    const std::vector<Chain> chains = chains_of(edges_of(
        context, test::cover_plane(80, 80, [&](Vec2 p) { return radius - length(p - center); })));
    ASSERT_EQ(chains.size(), 1u) << radius;
    EXPECT_TRUE(chains[0].is_closed);
    EXPECT_EQ(chains[0].point.front(), chains[0].point.back());
    EXPECT_EQ(chains[0].point.size(), chains[0].strength.size());
    for (const Vec2 p : chains[0].point) EXPECT_NEAR(length(p - center), radius, 0.25);
  }
}

TEST(LinkChains, lets_an_end_meet_the_line_ahead) {
  Context context;
  const std::vector<Chain> chains =
      chains_of(edges_of(context, test::plane_of(80, 80, [](Vec2 p) {
                           const double right = test::cover(p.x - 40.3);
                           return right * (0.4 + 0.4 * test::cover(p.y - 39.7));
                         })));
  ASSERT_EQ(chains.size(), 2u);
  const bool is_first_long = chains[0].point.size() > chains[1].point.size();
  const Chain &bar = chains[is_first_long ? 0 : 1], &stem = chains[is_first_long ? 1 : 0];
  const double near =
      std::min(distance_to(bar, stem.point.front()), distance_to(bar, stem.point.back()));
  EXPECT_LE(near, 0.75);
  EXPECT_GE(bar.point.size(), 75u);
  EXPECT_GE(stem.point.size(), 35u);
}

/// Returns many short lines, whose ends are close to others.
EdgeMap dashes(int side) {
  EdgeMap edges{side, side, std::vector<EdgePixel>(static_cast<std::size_t>(side * side))};
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const bool is_dash = y % 3 == 0 && x % 8 < 6;
      if (is_dash) edges.pixel[static_cast<std::size_t>(y * side + x)] = {1, 0.1f, 0, 0};
    }
  }
  return edges;
}

/// Returns the memory of chains.
std::size_t bytes_of(const std::vector<Chain>& chains) {
  std::size_t bytes = capacity_bytes(chains);
  for (const Chain& chain : chains) bytes += capacity_bytes(chain.point, chain.strength);
  return bytes;
}

TEST(LinkChains, charges_what_it_has_to_the_byte) {
  const EdgeMap edges = dashes(512);
  Context context;
  {
    TableMemory memory("chains");
    const Result<std::vector<Chain>> chains = link_chains(context, edges, memory);
    ASSERT_TRUE(chains.ok());
    EXPECT_GT(chains->size(), 1000u);
    EXPECT_EQ(context.budget.used(), bytes_of(*chains));
  }
  EXPECT_EQ(context.budget.used(), 0u);
}

TEST(LinkChains, every_memory_is_a_limit_or_enough) {
  const EdgeMap edges = dashes(128);
  constexpr std::size_t kPixels = 128 * 128, kMost = 64 * kPixels;
  // A fourth of the pixels: places of chains, their positions, and a second copy while they are
  // linked; beside a table of all pixels.
  constexpr std::size_t kLeast = 3 * 8 * kPixels / 4 + 4 * kPixels;
  bool was_enough = false;
  for (std::size_t bytes = 1000; bytes < kMost; bytes += 997) {
    Context context{.budget = Budget(bytes)};
    const StatusCode code = [&] {
      TableMemory memory("chains");
      return link_chains(context, edges, memory).status().code;
    }();
    EXPECT_TRUE(code == StatusCode::ok || (code == StatusCode::limit && !was_enough)) << bytes;
    EXPECT_FALSE(code == StatusCode::ok && bytes < kLeast) << bytes;
    EXPECT_EQ(context.budget.used(), 0u) << bytes;
    was_enough = was_enough || code == StatusCode::ok;
  }
  EXPECT_TRUE(was_enough);
}

TEST(LinkChains, looks_at_the_flag_often) {
  const EdgeMap edges = dashes(1536);
  test::expect_short_gaps("chains", [&edges] {
    Context context;
    test::PollRecorder recorder;
    context.poll_watch = &recorder;
    recorder.start();
    TableMemory memory("chains");
    EXPECT_TRUE(link_chains(context, edges, memory).ok());
    recorder.stop();
    return recorder.longest_seconds();
  });
}

TEST(LinkChains, drops_what_is_short) {
  Context context;
  const std::vector<Chain> chains =
      chains_of(edges_of(context, test::plane_of(60, 60, [](Vec2 p) {
                           return 0.3 * test::cover(1.0 - length(p - Vec2{30.2, 30.1}));
                         })));
  EXPECT_LE(chains.size(), 1u);
  EXPECT_TRUE(chains_of(EdgeMap{10, 10, std::vector<EdgePixel>(100)}).empty());
}

}  // namespace
}  // namespace sfumato::tracing
