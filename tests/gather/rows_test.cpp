#include "gather/rows/rows.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "curves/flatten.hpp"
#include "gather/ends/free_ends.hpp"
#include "gather/gather_reference.hpp"
#include "gather/rows_reference.hpp"
#include "gather/scenes.hpp"
#include "mesh/mesher.hpp"
#include "sfumato/base/native/thread_pool.hpp"
#include "sfumato/formats/svg/svg.hpp"
#include "support/cancel_at.hpp"
#include "support/folder_files.hpp"
#include "support/places.hpp"
#include "support/scenes.hpp"

namespace sfumato::gather::test {
namespace {

using curves::FieldValue;
using curves::SegmentAttributes;

/// A layer, the places of its segments among its stops, and the values of the stops.
struct Mapped {
  mesh::TriangleMesh mesh;
  SegmentAttributes attributes;
  SegmentAttributes places;
  std::vector<FieldValue> stop;  ///< per column
};

/// Makes a separate stop for each end of each segment's sides.
Mapped mapped(const Drawing& drawing) {
  Mapped m{drawing.mesh, drawing.attributes, drawing.attributes, {}};
  for (std::size_t s = 0; s < m.places.left.size(); ++s) {
    for (auto* side : {&m.places.left[s], &m.places.right[s]}) {
      const auto column = static_cast<float>(m.stop.size());
      const auto curve = static_cast<float>(drawing.attributes.curve[s]);
      m.stop.push_back(side->value.start);
      m.stop.push_back(side->value.end);
      side->value = {FieldValue(Rgb{0, column, curve}), FieldValue(Rgb{1, column, curve})};
    }
  }
  return m;
}

/// Uses a document's first layer.
Mapped mapped(const Document& document) {
  Context context;
  const std::vector<Curve>& curves = document.layers[0].curves;
  const double side = std::max(document.artboard.width(), document.artboard.height());
  const Result<curves::FlatCurves> flat =
      curves::flatten(context, curves, {.tolerance = side * 0.2 / 512});
  mesh::MeshOptions options;
  options.frame = document.artboard;
  options.unit_size = side / 1024;
  Result<mesh::Mesher> mesher = mesh::Mesher::build(context, *flat, options);
  EXPECT_TRUE(flat.ok() && mesher.ok());
  Mapped m;
  TableMemory memory("a test");
  m.mesh = *mesher->visibility_mesh({});
  m.attributes = *curves::sample_colors(context, *flat, curves, InterpolationSpace::srgb, memory);
  m.places = *curves::sample_stop_places(context, *flat, curves, StopAttribute::color, memory);
  for (const Curve& curve : curves) {
    for (const Side* s : {&curve.left, &curve.right}) {
      if (s->color.kind != ShaderKind::curve_domain) continue;
      for (const Stop<Rgb>& stop : s->color.stops.stops) m.stop.emplace_back(stop.value);
    }
  }
  EXPECT_EQ(m.stop.size(), curves::stop_count(curves, StopAttribute::color));
  return m;
}

Rows rows_of(Context& context, const Mapped& m, std::span<const Vec2> points,
             const RowOptions& options = {}) {
  Result<Rows> rows = gather_rows(context, m.mesh, m.places, points, options);
  EXPECT_TRUE(rows.ok()) << rows.status().message;
  return rows ? std::move(*rows) : Rows{};
}

Rows reference_rows_of(Context& context, const Mapped& m, std::span<const Vec2> points) {
  Result<Rows> rows = rows_reference(context, m.mesh, m.places, points);
  EXPECT_TRUE(rows.ok()) << rows.status().message;
  return rows ? std::move(*rows) : Rows{};
}

std::span<const RowTerm> terms(const Rows& rows, std::size_t point) {
  return std::span(rows.term).subspan(rows.begin[point], rows.begin[point + 1] - rows.begin[point]);
}

/// Returns the product of a row and the stops: channels of the colour, then the shares of shaders.
std::vector<double> value_of(const Rows& rows, std::size_t point, const Mapped& m) {
  std::vector<double> value(3 + m.attributes.shader.size());
  for (const RowTerm& term : terms(rows, point)) {
    const RowSource& source = rows.source[term.source];
    const double radius = radius_at(source, term.moment);
    for_each_entry(source, term, radius, [&](std::uint32_t column, double weight) {
      for (std::size_t c = 0; c < 3; ++c) value[c] += weight * m.stop.at(column).channel[c];
    });
    for_each_side(source, term, radius, [&](const RowSide& side, double weight) {
      if (side.shader >= 0) value[3 + static_cast<std::size_t>(side.shader)] += weight;
    });
  }
  return value;
}

double sum_of(const Rows& rows, std::size_t point) {
  double sum = 0;
  for (const RowTerm& term : terms(rows, point)) {
    const RowSource& source = rows.source[term.source];
    for_each_side(source, term, radius_at(source, term.moment),
                  [&](const RowSide&, double weight) { sum += weight; });
  }
  return sum;
}

/// Returns the free ends at the places, with the values of their stops.
std::vector<FreeEnd> ends_of(const Mapped& m) {
  Context context;
  TableMemory memory("a test");
  std::vector<FreeEnd> ends = *find_free_ends(context, m.mesh, m.places, memory);
  for (FreeEnd& end : ends) {
    for (FieldValue* value : {&end.positive, &end.negative}) {
      const auto column = static_cast<std::size_t>(value->channel[1]);
      const float fraction = value->channel[0];
      *value = fraction > 0 ? lerp(m.stop[column], m.stop[column + 1], fraction) : m.stop[column];
    }
  }
  return ends;
}

std::vector<double> reference_of(const Mapped& m, Vec2 p, std::span<const FreeEnd> ends) {
  const auto triangle = static_cast<std::uint32_t>(find_triangle(m.mesh, p));
  const ReferenceSums sums = gather_reference(m.mesh, m.attributes, p, triangle, ends);
  std::vector<double> value;
  for (const double v : sums.value()) value.push_back(v);
  for (const double v : sums.shares()) value.push_back(v);
  return value;
}

/// Returns the largest difference of a channel at any of the points.
double difference_of_rows(const Mapped& m, const Rows& rows, std::span<const Vec2> points) {
  const std::vector<FreeEnd> ends = ends_of(m);
  double largest = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::vector<double> expected = reference_of(m, points[i], ends);
    const std::vector<double> value = value_of(rows, i, m);
    for (std::size_t c = 0; c < expected.size(); ++c) {
      const double d = std::fabs(value[c] - expected[c]);
      if (!(d <= largest)) largest = d;
    }
  }
  return largest;
}

/// Returns points anywhere, near lines, and around the free ends.
std::vector<Vec2> points_of(const Drawing& drawing, std::uint32_t seed) {
  std::vector<Vec2> points = random_points(drawing, seed, 300, 1e-3);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> beside(-6, 6);
  for (const Line& line : drawing.lines) {
    for (const Vec2 end : {line.points.front(), lerp(line.points[0], line.points[1], 0.3)}) {
      const Vec2 p = end + Vec2{beside(random), beside(random)};
      if (p.x > 1 && p.x < 511 && p.y > 1 && p.y < 511) points.push_back(p);
    }
  }
  return points;
}

/// Returns the weights of all stops, then of all shaders.
std::vector<double> row_of(const Rows& rows, std::size_t point, const Mapped& m) {
  std::vector<double> row(m.stop.size() + m.attributes.shader.size());
  for (const RowTerm& term : terms(rows, point)) {
    const RowSource& source = rows.source[term.source];
    const double radius = radius_at(source, term.moment);
    for_each_entry(source, term, radius,
                   [&](std::uint32_t column, double weight) { row.at(column) += weight; });
    for_each_side(source, term, radius, [&](const RowSide& side, double weight) {
      if (side.shader >= 0) row.at(m.stop.size() + static_cast<std::size_t>(side.shader)) += weight;
    });
  }
  return row;
}

/// The summed difference of two rows: the largest of any point, and the mean.
struct RowDifference {
  double largest = 0;
  double mean = 0;
};
RowDifference difference_of_rows(const Mapped& m, const Rows& rows, const Rows& expected) {
  EXPECT_EQ(rows.source, expected.source);
  RowDifference result;
  const std::size_t points = expected.begin.size() - 1;
  for (std::size_t i = 0; i < points; ++i) {
    const std::vector<double> a = row_of(rows, i, m), b = row_of(expected, i, m);
    double sum = 0;
    for (std::size_t c = 0; c < a.size(); ++c) sum += std::fabs(a[c] - b[c]);
    if (!(sum <= result.largest)) result.largest = sum;
    result.mean += sum / static_cast<double>(points);
  }
  return result;
}

/// The tolerance covers single precision near curves closer than a hundredth of a unit, which weigh
/// most.
void expect_about_the_same(const Mapped& m, std::span<const Vec2> points, const Rows& expected) {
  Context context;
  const RowDifference d = difference_of_rows(m, rows_of(context, m, points), expected);
  EXPECT_LE(d.largest, 5e-5);
  EXPECT_LE(d.mean, 2e-6);
}

std::vector<Line> two_kinds_of_radius(std::vector<Line> lines) {
  for (std::size_t i = 0; i < lines.size(); i += 2)
    lines[i].blur_radius.end = lines[i].blur_radius.start;
  return lines;
}

TEST(Rows, times_colours_are_the_gather) {
  for (std::uint32_t seed = 1; seed < 6; ++seed) {
    const Drawing drawing = draw(random_lines(seed, 80, 0.1, 0.1));
    const Mapped m = mapped(drawing);
    const std::vector<Vec2> points = points_of(drawing, seed);
    Context context;
    const Rows expected = reference_rows_of(context, m, points);
    EXPECT_LE(difference_of_rows(m, expected, points), 1e-6);
    expect_about_the_same(m, points, expected);
  }
}

TEST(Rows, take_blur_of_any_radius_and_shaders_as_the_gather_does) {
  for (std::uint32_t seed = 10; seed < 13; ++seed) {
    const Drawing drawing =
        draw(two_kinds_of_radius(with_blends(random_lines(seed, 60, 0.1, 0.1), seed, 25, 4)));
    const Mapped m = mapped(drawing);
    const std::vector<Vec2> points = points_of(drawing, seed);
    Context context;
    const Rows expected = reference_rows_of(context, m, points);
    EXPECT_LE(difference_of_rows(m, expected, points), 1e-6);
    expect_about_the_same(m, points, expected);
  }
}

std::optional<Document> example(const std::string& name) {
  const auto text = sfumato::test::file_bytes(sfumato::test::source_path("examples/") + name);
  if (!text) return std::nullopt;
  Context context;
  const sfumato::test::FolderFiles files(sfumato::test::source_path("examples/"));
  Result<ReadDocument> read = read_svg(context, *text, name, &files);
  if (!read) return std::nullopt;
  return std::move(read->document);
}

std::vector<Vec2> grid_of(const Mapped& m, int side) {
  Box box;
  for (const Vec2 p : m.mesh.vertex_position) box.extend(p);
  std::vector<Vec2> points;
  for (int i = 0; i < side * side; ++i) {
    const Vec2 fraction{(i % side + 0.377) / side, (i / side + 0.619) / side};
    points.push_back(box.min + Vec2{fraction.x * box.width(), fraction.y * box.height()});
  }
  return points;
}

TEST(Rows, of_the_examples_times_their_stops_are_the_gather) {
  for (const char* name : {"fish.svg", "flower.svg", "portrait.svg", "sunset.svg", "blur.svg"}) {
    const std::optional<Document> document = example(name);
    ASSERT_TRUE(document) << name;
    const Mapped m = mapped(*document);
    const std::vector<Vec2> points = grid_of(m, 20);
    Context context;
    const Rows expected = reference_rows_of(context, m, points);
    EXPECT_LE(difference_of_rows(m, expected, points), 1e-6) << name;
    expect_about_the_same(m, points, expected);
  }
}

TEST(Rows, add_up_to_one_wherever_anything_is_seen) {
  const Drawing drawing = draw(with_blends(random_lines(20, 60, 0.3, 0.2), 20, 20, 2));
  const Mapped m = mapped(drawing);
  const std::vector<Vec2> points = points_of(drawing, 20);
  for (const float negligible : {0.0f, 2e-4f, 0.5f}) {
    Context context;
    const Rows rows = rows_of(context, m, points, {.negligible = negligible});
    ASSERT_EQ(rows.begin.size(), points.size() + 1);
    for (std::size_t i = 0; i < points.size(); ++i) {
      EXPECT_NEAR(sum_of(rows, i), terms(rows, i).empty() ? 0 : 1, 1e-6);
      EXPECT_FALSE(terms(rows, i).empty());
      for (const RowTerm& term : terms(rows, i)) EXPECT_GT(term.weight, 0);
    }
  }
}

TEST(Rows, without_what_is_negligible_are_shorter_and_differ_little) {
  const Drawing drawing = draw(random_lines(21, 120, 0.1, 0));
  const Mapped m = mapped(drawing);
  const std::vector<Vec2> points = points_of(drawing, 21);
  Context context;
  const Rows all = rows_of(context, m, points);
  const Rows some = rows_of(context, m, points, {.negligible = 1e-3f});
  EXPECT_LT(some.term.size(), 0.9 * static_cast<double>(all.term.size()));
  EXPECT_LE(difference_of_rows(m, some, points), 0.02);
}

Curve line_of_stops(double y, std::vector<Stop<Rgb>> stops) {
  Curve curve{.control_points = {{10, y}, {200, y}, {300, y}, {500, y}}};
  curve.left.color = {ShaderKind::curve_domain, {StopSpace::parameter, std::move(stops)}, 0};
  return curve;
}

/// A line of one colour on both sides inside a ring of another colour: its ends have no effect.
TEST(Rows, with_values_leave_out_ends_whose_sides_are_alike) {
  Document document;
  document.artboard = {{0, 0}, {512, 512}};
  document.layers.resize(1);
  const Rgb grey{0.5f, 0.5f, 0.5f}, red{1, 0, 0};
  Curve line{.control_points = {{200, 250}, {240, 250}, {280, 250}, {320, 250}}};
  line.left.color =
      line.right.color = {ShaderKind::curve_domain, {StopSpace::parameter, {{0, grey}}}, 0};
  document.layers[0].curves = {line, line_of_stops(20, {{0, red}}), line_of_stops(490, {{0, red}})};
  document.layers[0].curves[1].right = document.layers[0].curves[1].left;
  const Mapped m = mapped(document);
  const std::vector<Vec2> points{{190, 251}, {330, 249}, {195, 244}, {326, 255}};
  Context context;
  const Rows all = rows_of(context, m, points);
  const Rows some = rows_of(context, m, points, {.values = &m.attributes});
  TableMemory memory("a test");
  const std::vector<FreeEnd> ends = *find_free_ends(context, m.mesh, m.attributes, memory);
  bool some_differ = false;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::vector<double> expected = reference_of(m, points[i], ends);
    const std::vector<double> value = value_of(some, i, m), with_all = value_of(all, i, m);
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_NEAR(value[c], expected[c], 1e-5);
      some_differ = some_differ || std::fabs(with_all[c] - expected[c]) > 0.01;
    }
  }
  EXPECT_TRUE(some_differ);
}

TEST(Rows, name_the_columns_of_the_stops_beside_which_a_point_lies) {
  Document document;
  document.artboard = {{0, 0}, {512, 512}};
  document.layers.resize(1);
  const Rgb grey{0.5f, 0.5f, 0.5f};
  Curve first = line_of_stops(400, {{0, grey}, {1, grey}});
  first.right.color = {ShaderKind::curve_domain, {StopSpace::parameter, {{0.5, grey}}}, 0};
  document.layers[0].curves = {first,
                               line_of_stops(100, {{0.25, grey}, {0.5, grey}, {0.75, grey}})};
  const Mapped m = mapped(document);
  ASSERT_EQ(m.stop.size(), 6u);
  // The left of a curve that runs to the right is above it. Columns 0 and 1 are the first curve's
  // left, 2 its right, 3 to 5 the second's left, whose right is open.
  const std::vector<Vec2> points{{12, 99.9}, {245, 99.9}, {498, 99.9}, {200, 400.1}, {200, 399.9}};
  const std::vector<std::vector<std::uint32_t>> expected{{3}, {3, 4}, {5}, {2}, {0, 1}};
  Context context;
  const Rows rows = rows_of(context, m, points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    std::vector<double> weight(m.stop.size());
    for (const RowTerm& term : terms(rows, i)) {
      const RowSource& source = rows.source[term.source];
      EXPECT_EQ(source.curve, source.front.column < 3 ? 0u : 1u);
      for_each_entry(source, term, 0,
                     [&](std::uint32_t column, double w) { weight.at(column) += w; });
    }
    double sum = 0;
    for (const std::uint32_t column : expected[i]) sum += weight[column];
    EXPECT_GT(sum, 0.97) << i;
  }
}

TEST(Rows, of_curves_that_cross_and_lie_on_each_other_are_the_gather) {
  Line first = plain_line({{64, 256}, {448, 256}}, {1, 0, 0});
  first.right = {{0, 1, 0}, {0, 0, 1}};
  Line on_it = plain_line({{400, 256}, {128, 256}}, {0, 1, 1});
  on_it.right_kind = ShaderKind::open;
  Line across = plain_line({{250, 100}, {262, 400}}, {1, 1, 0});
  across.left = {{0, 0, 0}, {1, 0, 1}};
  Line wall = plain_line({{100, 100}, {100, 220}}, {0, 0, 0});
  wall.left_kind = wall.right_kind = ShaderKind::barrier;
  const Drawing drawing = draw({first, on_it, across, wall});
  const Mapped m = mapped(drawing);
  const std::vector<Vec2> points = random_points(drawing, 30, 500, 1e-3);
  Context context;
  const Rows expected = reference_rows_of(context, m, points);
  EXPECT_LE(difference_of_rows(m, expected, points), 1e-6);
  expect_about_the_same(m, points, expected);
}

/// A newly given radius replaces the one that the rows were made with.
TEST(Rows, take_another_radius_later) {
  std::vector<Line> lines = random_lines(31, 40, 0, 0);
  const Drawing sharp = draw(lines);
  for (Line& line : lines) line.blur_radius = {12, 12};
  const Drawing blurred = draw(lines);
  const Mapped m = mapped(sharp), expected = mapped(blurred);
  const std::vector<Vec2> points = points_of(sharp, 31);
  Context context;
  const Rows rows = rows_of(context, m, points);
  const std::vector<FreeEnd> ends = ends_of(expected);
  for (std::size_t i = 0; i < points.size(); ++i) {
    double red = 0;
    for (const RowTerm& term : terms(rows, i)) {
      for_each_entry(rows.source[term.source], term, 12, [&](std::uint32_t column, double weight) {
        red += weight * m.stop.at(column).channel[0];
      });
    }
    EXPECT_NEAR(red, reference_of(expected, points[i], ends)[0], 5e-5);
  }
}

bool are_the_same(const Rows& a, const Rows& b) {
  return a.source == b.source && a.term == b.term && a.begin == b.begin;
}

TEST(Rows, have_the_same_bytes_for_any_number_of_threads_and_every_width) {
  const Drawing drawing = draw(with_blends(random_lines(22, 80, 0.1, 0.1), 22, 20, 2));
  const Mapped m = mapped(drawing);
  const std::vector<Vec2> points = random_points(drawing, 22, 20'000, 1e-3);
  const RowOptions options{.negligible = 2e-4f};
  Context plain;
  plain.simd = SimdLevel::sse2;
  const Rows expected = rows_of(plain, m, points, options);
  EXPECT_GT(expected.term.size(), points.size());
  for (const int threads : {1, 2, 3, 8}) {
    for (const SimdLevel level : {SimdLevel::sse2, SimdLevel::avx2, SimdLevel::avx512}) {
      if (level > detected_simd_level()) continue;
      ThreadPool pool(threads);
      Context context;
      context.executor = &pool;
      context.simd = level;
      EXPECT_TRUE(are_the_same(rows_of(context, m, points, options), expected)) << threads;
    }
  }
}

/// So many windows wait that the kernel must start again with a larger stack.
TEST(Rows, among_thousands_of_specks_are_the_same) {
  const Drawing drawing = draw(specks(26, 3000));
  const Mapped m = mapped(drawing);
  const std::vector<Vec2> points = random_points(drawing, 26, 40, 0.05);
  Context context;
  expect_about_the_same(m, points, reference_rows_of(context, m, points));
}

TEST(Rows, are_empty_outside_the_mesh_and_where_nothing_is_seen) {
  const Drawing drawing = draw(random_lines(23, 20, 0, 0));
  const Mapped m = mapped(drawing);
  const std::vector<Vec2> outside{{-1e4, 100}, {1e5, 1e5}, {256, -3000}};
  Context context;
  EXPECT_TRUE(rows_of(context, m, outside).term.empty());
  EXPECT_EQ(rows_of(context, m, {}).begin, std::vector<std::uint32_t>{0});
  const Drawing nothing = draw({});
  const std::vector<Vec2> points{{100, 100}, {200, 300}};
  EXPECT_EQ(rows_of(context, mapped(nothing), points).begin, (std::vector<std::uint32_t>{0, 0, 0}));
}

TEST(Rows, on_a_curve_or_a_vertex_are_those_of_a_point_beside_it) {
  Line line = plain_line({{64, 256}, {448, 256}}, {1, 0, 0});
  line.right = {{0, 1, 0}, {0, 0, 1}};
  const Drawing drawing = draw({line, plain_line({{64, 300}, {448, 300}}, {1, 1, 1})});
  const Mapped m = mapped(drawing);
  const std::vector<Vec2> points{{256, 256}, {64, 256}, {448, 300}};
  Context context;
  const Rows rows = rows_of(context, m, points);
  for (std::size_t i = 0; i < points.size(); ++i) EXPECT_NEAR(sum_of(rows, i), 1, 1e-6);
  for (const RowTerm& term : terms(rows, 0)) {
    const std::uint32_t column = rows.source[term.source].front.column;
    EXPECT_TRUE(column < 4 || term.weight < 1e-3);
  }
}

TEST(Rows, end_when_they_are_cancelled) {
  const Drawing drawing = draw(random_lines(24, 40, 0, 0));
  const Mapped m = mapped(drawing);
  const std::vector<Vec2> points = random_points(drawing, 24, 200, 0.1);
  std::uint64_t poll = 1;
  for (;; poll += 41) {
    Context context;
    sfumato::test::CancelAt watch(poll, context.cancel);
    context.poll_watch = &watch;
    const Result<Rows> rows = gather_rows(context, m.mesh, m.places, points);
    if (!context.cancelled()) break;
    ASSERT_TRUE(rows.ok() || rows.status().code == StatusCode::cancelled);
  }
  EXPECT_GT(poll, 1000u);
}

TEST(Rows, are_charged_and_given_back) {
  const Drawing drawing = draw(random_lines(25, 40, 0, 0));
  const Mapped m = mapped(drawing);
  const std::vector<Vec2> points = random_points(drawing, 25, 20'000, 0.1);
  Context context;
  {
    const Rows rows = rows_of(context, m, points);
    EXPECT_EQ(context.budget.used(), capacity_bytes(rows.source, rows.term, rows.begin));
    EXPECT_LT(rows.term.capacity() - rows.term.size(), rows.term.size() / 4);
  }
  EXPECT_EQ(context.budget.used(), 0u);
}

TEST(Rows, beyond_a_budget_are_a_limit_error) {
  const Drawing drawing = draw(random_lines(25, 40, 0, 0));
  const Mapped m = mapped(drawing);
  const std::vector<Vec2> points = random_points(drawing, 25, 5'000, 0.1);
  int failures = 0;
  for (std::size_t room = 1000; room < (std::size_t{1} << 26); room *= 2) {
    Context poor;
    ASSERT_TRUE(poor.budget.charge(poor.budget.limit() - room, "the rest").ok());
    const Result<Rows> rows = gather_rows(poor, m.mesh, m.places, points);
    failures += !rows.ok();
    EXPECT_TRUE(rows.ok() || rows.status().code == StatusCode::limit);
  }
  EXPECT_GT(failures, 5);
  EXPECT_LT(failures, 16);
  Context context;
  context.limits.nodes = 10;
  EXPECT_EQ(gather_rows(context, m.mesh, m.places, points).status().code, StatusCode::limit);
}

}  // namespace
}  // namespace sfumato::gather::test
