#include <gtest/gtest.h>

#include "gather/scenes.hpp"

namespace sfumato::gather::test {
namespace {

/// Limits for the changes by single precision and by skipped windows, in code values.
constexpr double kRms = 2e-3;
constexpr double kLargest = 0.02;

class Metamorphic : public testing::Test {
 protected:
  std::vector<float> values(const std::vector<Line>& lines, const std::vector<Vec2>& points,
                            Box frame = {{0, 0}, {512, 512}}) {
    Context context;
    return gather_at(context, draw(lines, frame), points).value;
  }

  void expect_same(const std::vector<float>& a, const std::vector<float>& b) {
    const Difference d = difference(a, b);
    EXPECT_LE(d.rms, kRms);
    EXPECT_LE(d.largest, kLargest);
  }

  const std::vector<Line> lines_ = random_lines(5, 120, 0.15, 0.1);
  const std::vector<Vec2> points_ = random_points(draw(lines_), 5, 1000, 0.1);
};

template <class Map>
std::vector<Line> mapped(std::vector<Line> lines, Map map) {
  for (Line& line : lines) {
    for (Vec2& p : line.points) p = map(p);
  }
  return lines;
}
template <class Map>
std::vector<Vec2> mapped(std::vector<Vec2> points, Map map) {
  for (Vec2& p : points) p = map(p);
  return points;
}

TEST_F(Metamorphic, a_mirrored_drawing_has_the_same_colours_when_sides_are_swapped) {
  const auto mirror = [](Vec2 p) { return Vec2{512 - p.x, p.y}; };
  std::vector<Line> lines = mapped(lines_, mirror);
  for (Line& line : lines) {
    std::swap(line.left, line.right);
    std::swap(line.left_kind, line.right_kind);
  }
  expect_same(values(lines, mapped(points_, mirror)), values(lines_, points_));
}

TEST_F(Metamorphic, a_rotated_drawing_has_the_same_colours) {
  const auto rotate = [](Vec2 p) { return Vec2{512 - p.y, p.x}; };
  expect_same(values(mapped(lines_, rotate), mapped(points_, rotate)), values(lines_, points_));
}

TEST_F(Metamorphic, a_moved_drawing_has_the_same_colours) {
  const auto move = [](Vec2 p) { return p + Vec2{4096, -1024}; };
  expect_same(values(mapped(lines_, move), mapped(points_, move), {{4096, -1024}, {4608, -512}}),
              values(lines_, points_));
}

TEST_F(Metamorphic, a_drawing_of_twice_the_size_has_the_same_colours) {
  const auto grow = [](Vec2 p) { return p * 2; };
  expect_same(values(mapped(lines_, grow), mapped(points_, grow), {{0, 0}, {1024, 1024}}),
              values(lines_, points_));
}

TEST_F(Metamorphic, reversed_lines_with_swapped_sides_are_the_same_drawing) {
  std::vector<Line> lines = lines_;
  for (Line& line : lines) {
    std::swap(line.points[0], line.points[1]);
    std::swap(line.left, line.right);
    std::swap(line.left_kind, line.right_kind);
    std::swap(line.left[0], line.left[1]);
    std::swap(line.right[0], line.right[1]);
  }
  expect_same(values(lines, points_), values(lines_, points_));
}

TEST_F(Metamorphic, the_order_of_lines_that_do_not_touch_does_not_matter) {
  const std::vector<Line> lines(lines_.rbegin(), lines_.rend());
  expect_same(values(lines, points_), values(lines_, points_));
}

TEST_F(Metamorphic, a_line_may_be_split_where_its_colour_is_linear) {
  std::vector<Line> lines = lines_;
  for (Line& line : lines) {
    // At a point that is exactly on the line.
    line.points.insert(line.points.begin() + 1, lerp(line.points[0], line.points[1], 0.5));
    line.left.insert(line.left.begin() + 1, lerp(line.left[0], line.left[1], 0.5f));
    line.right.insert(line.right.begin() + 1, lerp(line.right[0], line.right[1], 0.5f));
  }
  expect_same(values(lines, points_), values(lines_, points_));
}

TEST_F(Metamorphic, weights_count_by_their_ratios) {
  std::vector<Line> lines = lines_;
  for (Line& line : lines) line.weight *= 1e6f;
  expect_same(values(lines, points_), values(lines_, points_));
}

TEST_F(Metamorphic, values_are_linear_in_the_colours) {
  std::vector<Line> halved = lines_;
  for (Line& line : halved) {
    for (auto* side : {&line.left, &line.right}) {
      for (Rgb& c : *side) c = lerp(Rgb{0.5f, 0.5f, 0.5f}, c, 0.5f);
    }
  }
  std::vector<float> expected = values(lines_, points_);
  Context context;
  const std::vector<std::uint8_t> hit = gather_at(context, draw(lines_), points_).hit;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    if (hit[i / 3]) expected[i] = 0.25f + 0.5f * expected[i];
  }
  expect_same(values(halved, points_), expected);
}

TEST_F(Metamorphic, the_order_of_points_changes_rounding_only) {
  std::vector<Vec2> reversed(points_.rbegin(), points_.rend());
  const std::vector<float> backwards = values(lines_, reversed);
  std::vector<float> forwards;
  for (std::size_t i = points_.size(); i-- > 0;) {
    forwards.insert(forwards.end(), backwards.begin() + static_cast<std::ptrdiff_t>(3 * i),
                    backwards.begin() + static_cast<std::ptrdiff_t>(3 * i + 3));
  }
  expect_same(forwards, values(lines_, points_));
}

}  // namespace
}  // namespace sfumato::gather::test
