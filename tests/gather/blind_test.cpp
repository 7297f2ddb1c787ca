#include "gather/scene/blind.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "gather/scenes.hpp"

namespace sfumato::gather::test {
namespace {

/// Returns codes as in build_scene; stops and passages are not numbered.
std::vector<EdgeCode> codes_of(const Drawing& drawing) {
  std::vector<EdgeCode> codes;
  for (std::uint32_t h = 0; h < drawing.mesh.triangle_vertex.size(); ++h) {
    EdgeCode code = drawing.mesh.half_edge_twin[h] == mesh::kNone ? kBorder : 0;
    if (drawing.mesh.half_edge_constraint[h] != mesh::kNone) {
      const Facing facing = facing_side(drawing.mesh, drawing.attributes, h);
      if (facing.kind == ShaderKind::barrier) code = kBorder;
      if (facing.has_value()) code = hit_code(0);
    }
    codes.push_back(code);
  }
  return codes;
}

/// A drawing and its blind parts.
struct Looked {
  explicit Looked(std::vector<Line> lines) : drawing(draw(std::move(lines))) {
    codes = codes_of(drawing);
    Result<std::vector<std::uint8_t>> found = find_blind(context, drawing.mesh, codes, memory);
    EXPECT_TRUE(found.ok()) << found.status().message;
    if (found) blind = std::move(*found);
    EXPECT_EQ(blind.size(), codes.size());
  }

  bool is_open_side(std::uint32_t h) const {
    const std::int32_t c = drawing.mesh.half_edge_constraint[h];
    return codes[h] >= 0 && c != mesh::kNone &&
           !drawing.mesh.pieces(drawing.mesh.constraint[static_cast<std::uint32_t>(c)]).empty();
  }

  /// Returns the blind share of all open sides of curves.
  double blind_share() const {
    double open = 0, found = 0;
    for (std::uint32_t h = 0; h < codes.size(); ++h) {
      open += is_open_side(h);
      found += is_open_side(h) && blind[h];
    }
    return found / open;
  }

  /// Returns whether a ray from p through x on half-edge h meets a stop farther away.
  bool meets_stop(std::uint32_t h, Vec2 p, Vec2 x) const {
    const mesh::TriangleMesh& mesh = drawing.mesh;
    for (std::uint32_t s = 0; s < codes.size(); ++s) {
      if (!is_hit(codes[s]) || s == h) continue;
      const Vec2 a = mesh.vertex_position[mesh.origin(s)], b = mesh.vertex_position[mesh.target(s)];
      const double along = cross(x - p, b - a);
      const double t = cross(a - p, b - a) / along, u = cross(a - p, x - p) / along;
      if (cross(b - a, p - a) > 1e-6 && t > 1 + 1e-6 && u > 1e-6 && u < 1 - 1e-6) return true;
    }
    return false;
  }

  Context context;
  TableMemory memory{"a test"};
  Drawing drawing;
  std::vector<EdgeCode> codes;
  std::vector<std::uint8_t> blind;
};

Line open_right(std::vector<Vec2> points) {
  Line line = plain_line(std::move(points), {1, 0, 0});
  line.right_kind = ShaderKind::open;
  return line;
}

Vec2 on_circle(double radius, int i, int count) {
  const double angle = 6.283185307179586 * i / count;
  const Vec2 p = Vec2{256, 256} + radius * Vec2{std::cos(angle), -std::sin(angle)};
  return {std::round(p.x * 16) / 16, std::round(p.y * 16) / 16};
}

/// Returns a circle; colours_outside: the side with colours.
Line circle(double radius, bool colours_outside) {
  std::vector<Vec2> points;
  for (int i = 0; i <= 48; ++i) points.push_back(on_circle(radius, i % 48, 48));
  if (!colours_outside) return open_right(std::move(points));
  std::reverse(points.begin(), points.end());
  return open_right(std::move(points));
}

TEST(Blind, behind_a_straight_line_with_many_vertices_nothing_is_seen) {
  // Along the fourth, vertices are off the line by the rounding of the lattice.
  for (const double slope : {0.0, 0.25, -1.5, 0.3819660113, 1000.0}) {
    std::vector<Vec2> points;
    for (int i = 0; i < 200; ++i) {
      points.push_back(slope == 1000 ? Vec2{256, 100 + i * 1.0}
                                     : Vec2{100 + i * 1.0, 256 + slope * (i - 100)});
    }
    EXPECT_EQ(Looked({open_right(points)}).blind_share(), 1) << slope;
    std::reverse(points.begin(), points.end());
    EXPECT_EQ(Looked({open_right(points)}).blind_share(), 1) << slope;
  }
}

TEST(Blind, from_within_concentric_circles_with_colours_outside_nothing_is_seen) {
  std::vector<Line> circles;
  for (int i = 1; i <= 20; ++i) circles.push_back(circle(12 * i, true));
  EXPECT_EQ(Looked(circles).blind_share(), 1);
}

TEST(Blind, into_concentric_circles_with_colours_inside_all_is_seen) {
  std::vector<Line> circles;
  for (int i = 1; i <= 20; ++i) circles.push_back(circle(12 * i, false));
  EXPECT_EQ(Looked(circles).blind_share(), 0);
}

TEST(Blind, parallels_that_show_the_same_side_are_blind_from_behind) {
  std::vector<Line> lines;
  for (int i = 0; i < 50; ++i) lines.push_back(open_right({{50, 100.0 + i}, {450, 100.0 + i}}));
  EXPECT_EQ(Looked(lines).blind_share(), 1);
}

TEST(Blind, one_line_that_faces_the_others_is_seen_through_all_of_them) {
  std::vector<Line> lines;
  for (int i = 0; i < 50; ++i) lines.push_back(open_right({{50, 100.0 + i}, {450, 100.0 + i}}));
  lines.push_back(open_right({{450, 50}, {50, 50}}));
  EXPECT_LT(Looked(lines).blind_share(), 0.05);
}

TEST(Blind, without_any_colour_all_is_blind) {
  Line line = open_right({{100, 100}, {400, 200}});
  line.left_kind = ShaderKind::open;
  EXPECT_EQ(Looked({line}).blind_share(), 1);
}

TEST(Blind, no_ray_through_a_blind_edge_meets_a_stop_on_random_scenes) {
  std::mt19937 random(11);
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * (static_cast<double>(random()) / 4294967296.0);
  };
  int looked = 0;
  for (std::uint32_t seed = 0; seed < 12; ++seed) {
    // Without barriers, because a ray behind them would meet edges that nobody sees.
    const Looked scene(random_lines(seed, 20 + 10 * static_cast<int>(seed), 0.6, 0));
    const mesh::TriangleMesh& mesh = scene.drawing.mesh;
    for (std::uint32_t h = 0; h < scene.codes.size(); ++h) {
      if (!scene.blind[h]) continue;
      const Vec2 a = mesh.vertex_position[mesh.origin(h)];
      const Vec2 b = mesh.vertex_position[mesh.target(h)];
      for (int i = 0; i < 20; ++i) {
        const Vec2 p{uniform(0, 512), uniform(0, 512)};
        if (cross(b - a, p - a) < 1e-3) continue;
        ++looked;
        ASSERT_FALSE(scene.meets_stop(h, p, lerp(a, b, uniform(0.01, 0.99)))) << seed << ' ' << h;
      }
    }
  }
  EXPECT_GT(looked, 5000);
}

TEST(Blind, a_mesh_without_a_lattice_has_none) {
  Looked scene({open_right({{100, 100}, {400, 200}})});
  scene.drawing.mesh.lattice_step = 0;
  const Result<std::vector<std::uint8_t>> blind =
      find_blind(scene.context, scene.drawing.mesh, scene.codes, scene.memory);
  ASSERT_TRUE(blind.ok());
  EXPECT_EQ(*blind, std::vector<std::uint8_t>(scene.codes.size(), 0));
}

}  // namespace
}  // namespace sfumato::gather::test
