#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>
#include <utility>
#include <vector>

#include "gather/gather.hpp"
#include "gather/scenes.hpp"
#include "mesh/mesher.hpp"
#include "support/cancel_at.hpp"
#include "support/sanitizers.hpp"

/// Gathering after a curve was inserted gives the same as gathering from a new scene.
namespace sfumato::gather::test {
namespace {

using sfumato::test::CancelAt;

constexpr std::uint32_t kSeeds = SFUMATO_HAS_SANITIZER ? 3 : 20;
constexpr int kExtendedPoints = 600;

/// A gather skips windows too narrow to count; the skipped ones depend on the mesh.
constexpr float kMost = 1.0f / 255;

/// Returns the lines of a drawing without the last.
curves::FlatCurves without_last(const curves::FlatCurves& flat) {
  curves::FlatCurves rest = flat;
  rest.curve_begin.pop_back();
  const std::size_t count = rest.curve_begin.back();
  rest.vertex.resize(count);
  rest.parameter.resize(count);
  rest.arc_length.resize(count);
  rest.vertex_curve.resize(count);
  return rest;
}

/// A drawing, with meshes without its last line and with that line inserted.
class Inserted {
 public:
  Inserted(Context& context, const Drawing& drawing, Ends ends)
      : context_(context), drawing_(drawing), ends_(ends) {
    const curves::FlatCurves rest = without_last(drawing.flat);
    const auto first = static_cast<std::uint32_t>(rest.vertex.size());
    mesh::MeshOptions options;
    options.frame = options.room = drawing.frame;
    options.unit_size = std::max(drawing.frame.width(), drawing.frame.height()) / 1024;
    Result<mesh::Mesher> without = mesh::Mesher::build(context, rest, options);
    Result<Gatherer> made = Gatherer::create(context, *without->visibility_mesh(context),
                                             drawing.attributes, ends, {.will_be_extended = true});
    before.emplace(std::move(*made));
    Result<mesh::Mesher> with = without->copy(context);
    EXPECT_TRUE(with->edit(context, drawing.flat, {{}, first}, false).ok());
    is_same = *with->same_triangles(context, *without, memory_);
    mesh_ = *with->visibility_mesh(context);
    is_inserted_.assign(drawing.flat.vertex.size(), 0);
    std::fill(is_inserted_.begin() + first, is_inserted_.end(), std::uint8_t{1});
  }

  Result<Gatherer> extended(Context& context) const {
    return Gatherer::create(context, mesh_, drawing_.attributes, ends_, {is_inserted_},
                            {&*before, is_same});
  }
  /// The same from another `before` with the same lines, and from used tables.
  Result<Gatherer> extended_from(const Inserted& other, Gatherer* used) const {
    return Gatherer::create(context_, mesh_, drawing_.attributes, ends_, {is_inserted_},
                            {&*other.before, is_same, used});
  }
  Result<Gatherer> built_anew() const {
    return Gatherer::create(context_, mesh_, drawing_.attributes, ends_, {is_inserted_});
  }

  std::optional<Gatherer> before;
  std::vector<std::uint8_t> is_same;

 private:
  Context& context_;
  const Drawing& drawing_;
  Ends ends_;
  TableMemory memory_{"a test"};
  mesh::TriangleMesh mesh_;
  std::vector<std::uint8_t> is_inserted_;
};

/// Returns random lines, and one that crosses some of them, at some place.
Drawing crossed(std::uint32_t seed, float blur, float weight, std::uint32_t place = 0) {
  std::vector<Line> lines = random_lines(seed, 40, 0.2, 0.1);
  if (blur > 0) lines = with_blends(std::move(lines), seed, blur, 2);
  std::mt19937 random(seed + 1000 * place);
  std::vector<Vec2> points;
  for (int i = 0; i < 5; ++i)
    points.push_back({double(random() % 480) + 16, double(random() % 480) + 16});
  Line last = plain_line(points, {0.2f, 1, 0.4f});
  last.right.assign(points.size(), {1, 0, 0.5f});
  last.weight = weight;
  lines.push_back(last);
  return draw(std::move(lines));
}

std::vector<float> gathered(Context& context, const Gatherer& gatherer,
                            const std::vector<Vec2>& points) {
  std::vector<float> value(points.size() * static_cast<std::size_t>(gatherer.channel_count()));
  EXPECT_TRUE(gatherer.gather(context, points, {}, value).ok());
  return value;
}

float difference_at(const std::vector<float>& a, const std::vector<float>& b, std::size_t point,
                    std::size_t count) {
  const std::size_t channels = a.size() / count;
  float largest = 0;
  for (std::size_t c = channels * point; c < channels * (point + 1); ++c)
    largest = std::max(largest, std::fabs(a[c] - b[c]));
  return largest;
}

void expect_as_built_anew(const Drawing& drawing, std::uint32_t seed, Ends ends) {
  Context context;
  const Inserted inserted(context, drawing, ends);
  const Result<Gatherer> extended = inserted.extended(context), anew = inserted.built_anew();
  ASSERT_TRUE(extended.ok() && anew.ok());
  const std::vector<Vec2> points = random_points(drawing, seed, kExtendedPoints, 0.5);
  const std::vector<float> value = gathered(context, *extended, points);
  const std::vector<float> expected = gathered(context, *anew, points);
  const std::vector<float> earlier = gathered(context, *inserted.before, points);
  TableMemory memory("a test");
  const Result<PointPlaces> places = inserted.before->locate(context, points);
  ASSERT_TRUE(places.ok());
  std::vector<std::uint32_t> listed;
  ASSERT_TRUE(extended
                  ->list_changes(context, *inserted.before, points, {*places, inserted.is_same},
                                 memory, listed)
                  .ok());
  std::vector<std::uint8_t> marked(points.size(), 0), marked_anew = marked;
  for (const std::uint32_t i : listed) {
    EXPECT_EQ(marked[i], 0) << "listed twice";
    marked[i] = 1;
  }
  ASSERT_TRUE(anew->find_changes(context, *inserted.before, points, marked_anew).ok());
  int changed = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    ASSERT_LE(difference_at(value, expected, i, points.size()), kMost) << i;
    const bool differs = difference_at(expected, earlier, i, points.size()) > kMost;
    changed += differs;
    ASSERT_TRUE(!differs || marked[i]) << i;
  }
  EXPECT_GT(changed, 0);
  EXPECT_EQ(marked, marked_anew);
}

TEST(ExtendedScene, gathers_what_one_built_anew_does) {
  for (std::uint32_t seed = 0; seed < kSeeds; ++seed) {
    SCOPED_TRACE(seed);
    ASSERT_NO_FATAL_FAILURE(expect_as_built_anew(crossed(seed, 0, 1), seed, Ends::paper));
    ASSERT_NO_FATAL_FAILURE(expect_as_built_anew(crossed(seed, 9, 1), seed, Ends::soft));
  }
}

TEST(ExtendedScene, keeps_the_terms_of_free_ends) {
  for (std::uint32_t seed = 0; seed < kSeeds; ++seed) {
    SCOPED_TRACE(seed);
    ASSERT_NO_FATAL_FAILURE(expect_as_built_anew(crossed(seed, 0, 0.25f), seed, Ends::soft));
  }
}

TEST(ExtendedScene, from_tables_that_were_used_has_the_bits_of_one_from_a_copy) {
  for (std::uint32_t seed = 0; seed < kSeeds; ++seed) {
    SCOPED_TRACE(seed);
    Context context;
    const float blur = seed % 2 == 0 ? 0 : 9;
    const Drawing first = crossed(seed, blur, 1);
    const Inserted base(context, first, Ends::soft);
    Result<Gatherer> used = base.extended(context);
    ASSERT_TRUE(used.ok());
    for (std::uint32_t place = 1; place < 5; ++place) {
      const Drawing drawing = crossed(seed, blur, 1, place);
      const Inserted inserted(context, drawing, Ends::soft);
      Result<Gatherer> again = inserted.extended_from(base, &*used);
      const Result<Gatherer> copied = inserted.extended_from(base, nullptr);
      ASSERT_TRUE(again.ok() && copied.ok());
      const std::vector<Vec2> points = random_points(drawing, seed, kExtendedPoints, 0.5);
      ASSERT_EQ(gathered(context, *again, points), gathered(context, *copied, points)) << place;
      *used = std::move(*again);
    }
  }
}

TEST(ExtendedScene, is_built_anew_for_the_heaviest_curve) {
  ASSERT_NO_FATAL_FAILURE(expect_as_built_anew(crossed(1, 0, 40), 1, Ends::soft));
}

TEST(ExtendedScene, is_built_anew_for_the_first_curve) {
  Context context;
  const Drawing drawing = draw({plain_line({{16, 16}, {200, 300}}, {1, 0, 0})});
  const Inserted inserted(context, drawing, Ends::soft);
  const Result<Gatherer> extended = inserted.extended(context);
  ASSERT_TRUE(extended.ok());
  EXPECT_GT(gathered(context, *extended, {{300, 100}})[0], 0.99f);
}

/// A drawing, with meshes of all lines and with one line removed.
struct Reduced {
  Reduced(Context& context, const Drawing& drawing, std::uint32_t line, Ends ends) {
    mesh::MeshOptions options;
    options.frame = options.room = drawing.frame;
    options.unit_size = std::max(drawing.frame.width(), drawing.frame.height()) / 1024;
    Result<mesh::Mesher> with = mesh::Mesher::build(context, drawing.flat, options);
    const mesh::TriangleMesh all = *with->visibility_mesh(context);
    whole.emplace(std::move(
        *Gatherer::create(context, all, drawing.attributes, ends, {.may_be_changed = true})));
    is_removed.assign(drawing.flat.vertex.size(), 0);
    std::fill(is_removed.begin() + drawing.flat.curve_begin[line],
              is_removed.begin() + drawing.flat.curve_begin[line + 1], std::uint8_t{1});
    Result<mesh::Mesher> without = with->copy(context);
    const auto end = static_cast<std::uint32_t>(drawing.flat.vertex.size());
    EXPECT_TRUE(without->edit(context, drawing.flat, {is_removed, end}, false).ok());
    is_same = *without->same_triangles(context, *with, memory);
    EXPECT_TRUE(whole->watch(context, all, is_removed).ok());
    const mesh::TriangleMesh rest = *without->visibility_mesh(context);
    GatherUse use{.is_watched = is_removed, .will_be_extended = true};
    reduced.emplace(std::move(*Gatherer::create(context, rest, drawing.attributes, ends, use,
                                                {&*whole, is_same, nullptr, &all})));
    anew.emplace(std::move(*Gatherer::create(context, rest, drawing.attributes, ends)));
  }

  std::optional<Gatherer> whole, reduced, anew;
  std::vector<std::uint8_t> is_removed, is_same;
  TableMemory memory{"a test"};
};

/// Returns how many points the line changes.
int expect_reduced(const Drawing& drawing, std::uint32_t line, std::uint32_t seed, Ends ends) {
  Context context;
  Reduced scene(context, drawing, line, ends);
  const std::vector<Vec2> points = random_points(drawing, seed, kExtendedPoints, 0.5);
  const std::vector<float> value = gathered(context, *scene.reduced, points);
  const std::vector<float> expected = gathered(context, *scene.anew, points);
  const std::vector<float> earlier = gathered(context, *scene.whole, points);
  const Result<PointPlaces> places = scene.reduced->locate(context, points);
  std::vector<std::uint32_t> listed;
  EXPECT_TRUE(places.ok() && scene.whole
                                 ->list_changes(context, *scene.reduced, points,
                                                {*places, scene.is_same}, scene.memory, listed)
                                 .ok());
  int changed = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_LE(difference_at(value, expected, i, points.size()), kMost) << i;
    if (difference_at(expected, earlier, i, points.size()) <= kMost) continue;
    ++changed;
    EXPECT_NE(std::ranges::find(listed, i), listed.end()) << i;
  }
  std::vector<std::uint8_t> marked(points.size(), 0), marked_anew = marked;
  for (const std::uint32_t i : listed) marked[i] = 1;
  EXPECT_TRUE(scene.whole->find_changes(context, *scene.anew, points, marked_anew).ok());
  EXPECT_EQ(marked, marked_anew);
  return changed;
}

TEST(ReducedScene, gathers_what_one_built_anew_does) {
  int changed = 0;
  for (std::uint32_t seed = 0; seed < kSeeds; ++seed) {
    SCOPED_TRACE(seed);
    changed += expect_reduced(crossed(seed, 0, 1), 40, seed, Ends::paper);
    changed += expect_reduced(crossed(seed, 9, 1), 40, seed, Ends::soft);
    changed += expect_reduced(crossed(seed, 0, 0.25f), seed, seed, Ends::soft);
  }
  EXPECT_GT(changed, 0);
}

TEST(ReducedScene, knows_where_points_lie_as_one_that_searches_does) {
  Context context;
  const Drawing drawing = crossed(3, 0, 1);
  const Reduced scene(context, drawing, 40, Ends::soft);
  const std::vector<Vec2> points = random_points(drawing, 3, kExtendedPoints, 0.5);
  std::vector<float> value(points.size() * 3);
  std::vector<std::uint32_t> place(points.size(), kUnknownPlace);
  ASSERT_TRUE(scene.whole->gather(context, points, {}, value, {}, false, place).ok());
  for (std::uint32_t& triangle : place)
    if (!scene.is_same[triangle]) triangle = kUnknownPlace;
  const Result<PointPlaces> known = scene.reduced->locate(context, points, place);
  const Result<PointPlaces> found = scene.reduced->locate(context, points);
  ASSERT_TRUE(known.ok() && found.ok());
  EXPECT_EQ(known->begin, found->begin);
  EXPECT_EQ(known->slot, found->slot);
}

TEST(ExtendedScene, ends_when_it_is_cancelled) {
  Context context;
  const Drawing drawing = crossed(2, 9, 1);
  const Inserted inserted(context, drawing, Ends::soft);
  std::uint64_t poll = 1;
  for (;; poll += 5) {
    Context cancelled;
    CancelAt watch(poll, cancelled.cancel);
    cancelled.poll_watch = &watch;
    const Result<Gatherer> extended = inserted.extended(cancelled);
    if (!cancelled.cancelled()) break;
    ASSERT_TRUE(extended.ok() || extended.status().code == StatusCode::cancelled);
  }
  EXPECT_GT(poll, 100u);
}

}  // namespace
}  // namespace sfumato::gather::test
