#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>

#include "formats/written.hpp"
#include "sfumato/formats/svg/svg.hpp"
#include "sfumato/formats/svg/svg_write.hpp"
#include "support/drawing.hpp"
#include "support/scenes.hpp"

namespace sfumato {
namespace {

using test::written;

/// Well mixed numbers, the same in every run.
class Mixer {
 public:
  explicit Mixer(std::uint64_t seed) : state_(seed) {}

  std::uint64_t word() {
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }
  std::size_t below(std::size_t n) { return word() % n; }
  bool chance() { return word() % 2 == 0; }
  double unit() { return static_cast<double>(word() >> 11) * 0x1p-53; }
  /// Returns numbers that are short, have all digits, or are tiny.
  double coordinate() {
    switch (below(4)) {
      case 0:
        return static_cast<double>(below(200)) - 50;
      case 1:
        return unit() * 1e-9;
      default:
        return unit() * 300 - 100;
    }
  }
  float share() { return chance() ? static_cast<float>(below(256)) / 255.0f : float(unit()); }

 private:
  std::uint64_t state_;
};

Vec2 point(Mixer& mixer) {
  return {mixer.coordinate(), mixer.coordinate()};
}

Rgb value(Mixer& mixer, Rgb) {
  return {mixer.share(), mixer.share(), mixer.share()};
}
float value(Mixer& mixer, float) {
  return mixer.share();
}

template <class Value>
StopList<Value> stops(Mixer& mixer, std::size_t pieces) {
  StopList<Value> list;
  list.space = mixer.chance() ? StopSpace::parameter : StopSpace::arc_length;
  const double end = list.space == StopSpace::parameter ? static_cast<double>(pieces) : 1;
  const std::size_t count = 1 + mixer.below(4);
  double offset = 0;
  for (std::size_t i = 0; i < count; ++i) {
    // Values that a percentage expresses exactly.
    list.stops.push_back(
        {list.space == StopSpace::parameter ? offset : 100 * offset / 100, value(mixer, Value{})});
    if (mixer.below(3) > 0) offset = std::min(end, offset + end * mixer.unit() / 2);
  }
  if (list.space == StopSpace::arc_length && mixer.chance() && count > 1) {
    list.stops.back().offset = 1;
  }
  return list;
}

template <class Value>
SideShader<Value> shader(Mixer& mixer, std::size_t pieces, std::size_t shaders) {
  switch (mixer.below(shaders > 0 ? 5 : 4)) {
    case 0:
      return {};
    case 1:
      return {ShaderKind::barrier, {}, 0};
    case 4:
      return {ShaderKind::image_domain, {}, static_cast<std::uint32_t>(mixer.below(shaders))};
    default:
      return {ShaderKind::curve_domain, stops<Value>(mixer, pieces), 0};
  }
}

ScalarStops radii(Mixer& mixer, std::size_t pieces) {
  ScalarStops list = stops<float>(mixer, pieces);
  list.stops.back().value = 1.5f;
  return list;
}

Side side(Mixer& mixer, std::size_t pieces, std::size_t shaders) {
  return {shader<Rgb>(mixer, pieces, shaders), shader<float>(mixer, pieces, shaders),
          mixer.chance() ? radii(mixer, pieces) : ScalarStops{}};
}

std::vector<Vec2> chain(Mixer& mixer, std::size_t pieces) {
  std::vector<Vec2> points;
  for (std::size_t i = 0; i < 3 * pieces + 1; ++i) points.push_back(point(mixer));
  if (mixer.chance()) points.back() = points.front();
  return points;
}

Curve curve(Mixer& mixer, std::size_t shaders) {
  Curve made;
  const std::size_t pieces = 1 + mixer.below(4);
  made.control_points = chain(mixer, pieces);
  made.left = side(mixer, pieces, shaders);
  made.right = mixer.chance() ? made.left : side(mixer, pieces, shaders);
  if (mixer.chance()) made.weight = 0.1 + mixer.unit();
  return made;
}

Affine map(Mixer& mixer) {
  switch (mixer.below(3)) {
    case 0:
      return {};
    case 1:
      return {1, 0, 0, 1, mixer.coordinate(), mixer.coordinate()};
    default:
      return {1 + mixer.unit(), mixer.unit() / 2,   mixer.unit() / 3,
              1 + mixer.unit(), mixer.coordinate(), mixer.coordinate()};
  }
}

Shader paint(Mixer& mixer, std::size_t index) {
  const std::string id = "paint-" + std::to_string(index);
  if (mixer.below(3) == 0) {
    Texture texture;
    texture.width = 1 + static_cast<int>(mixer.below(3));
    texture.height = 1 + static_cast<int>(mixer.below(3));
    for (int i = 0; i < 4 * texture.width * texture.height; ++i) {
      texture.rgba.push_back(static_cast<std::uint8_t>(mixer.below(256)));
    }
    texture.layer_from_texture = map(mixer);
    return {id, texture};
  }
  GradientFill fill;
  if (mixer.chance()) {
    fill.shape = LinearGradient{point(mixer), point(mixer)};
  } else {
    const Vec2 center = point(mixer);
    fill.shape = RadialGradient{center, mixer.chance() ? center : center + Vec2{0.5, 0.25},
                                1 + mixer.unit()};
  }
  fill.spread = static_cast<SpreadMethod>(mixer.below(3));
  fill.layer_from_gradient = map(mixer);
  double offset = 0;
  for (std::size_t i = 0; i < 1 + mixer.below(3); ++i) {
    fill.stops.push_back({offset, value(mixer, Rgb{}), mixer.chance() ? 1 : mixer.share()});
    offset = std::min(1.0, offset + mixer.unit());
  }
  return {id, fill};
}

/// Returns a drawing whose layers and shaders are in the order of their first use, as after
/// reading.
Document drawing(std::uint64_t seed) {
  Mixer mixer(seed);
  Document document;
  document.artboard = {{0, 0}, {100 + mixer.unit(), 50}};
  document.interpolation = static_cast<InterpolationSpace>(mixer.below(3));
  if (mixer.chance()) {
    const double scale = 10 * mixer.unit() + 0.1;
    document.size_px = Vec2{scale * document.artboard.width(), scale * document.artboard.height()};
  }
  if (mixer.chance()) document.background = value(mixer, Rgb{});
  for (std::size_t i = mixer.below(4); i > 0; --i) {
    document.shaders.push_back(paint(mixer, document.shaders.size()));
  }
  for (std::uint32_t i = 0; i < 1 + mixer.below(3); ++i) {
    Layer layer{"layer-" + std::to_string(i), {}};
    for (std::size_t k = mixer.below(5); k > 0; --k) {
      layer.curves.push_back(curve(mixer, document.shaders.size()));
      if (mixer.chance()) layer.curves.back().id = "c" + std::to_string(mixer.below(10));
    }
    document.layers.push_back(std::move(layer));
    const bool in_group = mixer.below(3) == 0;
    if (in_group) document.stack.push_back(GroupBegin{0.5f, BlendMode::screen});
    for (std::size_t k = 1 + mixer.below(2); k > 0; --k) {
      document.stack.push_back(LayerInstance{i, map(mixer), mixer.chance() ? 1 : mixer.share(),
                                             static_cast<BlendMode>(mixer.below(16))});
    }
    if (in_group || mixer.chance()) {
      LocalStroke stroke;
      stroke.curve.control_points = chain(mixer, 2);
      stroke.curve.left_color = stops<Rgb>(mixer, 2);
      stroke.curve.right_color = stops<Rgb>(mixer, 2);
      if (mixer.chance()) stroke.curve.blur_radius = radii(mixer, 2);
      stroke.curve.influence_radius = radii(mixer, 2);
      stroke.curve.alpha = mixer.chance() ? 1 : 2 * mixer.unit();
      stroke.artboard_from_stroke = map(mixer);
      document.stack.push_back(stroke);
    }
    if (in_group) document.stack.push_back(GroupEnd{});
  }
  return document;
}

Document read_back(const std::string& text) {
  Context context;
  Result<ReadDocument> read = read_svg(context, text, "written.svg");
  EXPECT_TRUE(read.ok()) << to_string(read.status()) << '\n' << text;
  return read ? std::move(read->document) : Document();
}

/// Compares the drawn curves without ids, which are made unique.
void expect_same_curves(const Document& a, const Document& b) {
  ASSERT_EQ(a.layers.size(), b.layers.size());
  for (std::size_t i = 0; i < a.layers.size(); ++i) {
    EXPECT_EQ(a.layers[i].id, b.layers[i].id);
    ASSERT_EQ(a.layers[i].curves.size(), b.layers[i].curves.size());
    for (std::size_t k = 0; k < a.layers[i].curves.size(); ++k) {
      Curve mine = a.layers[i].curves[k], other = b.layers[i].curves[k];
      // Shaders get new numbers; their ids identify them.
      for (auto [curve, document] : {std::pair(&mine, &a), std::pair(&other, &b)}) {
        curve->id.clear();
        for (Side* side : {&curve->left, &curve->right}) {
          const auto name = [document](auto& shader) {
            if (shader.kind != ShaderKind::image_domain) return;
            shader.shader = static_cast<std::uint32_t>(
                std::stoul(document->shaders[shader.shader].id.substr(6)));
          };
          name(side->color);
          name(side->opacity);
        }
      }
      EXPECT_EQ(mine, other) << "layer " << i << ", curve " << k;
    }
  }
}

void expect_same_stack(const Document& a, const Document& b) {
  ASSERT_EQ(a.stack.size(), b.stack.size());
  for (std::size_t i = 0; i < a.stack.size(); ++i) {
    ASSERT_EQ(a.stack[i].index(), b.stack[i].index()) << i;
    if (const auto* mine = std::get_if<LayerInstance>(&a.stack[i])) {
      const auto& other = std::get<LayerInstance>(b.stack[i]);
      EXPECT_EQ(mine->layer, other.layer);
      EXPECT_EQ(mine->artboard_from_layer, other.artboard_from_layer);
      EXPECT_EQ(mine->opacity, other.opacity);
      EXPECT_EQ(mine->blend, other.blend);
    } else if (const auto* stroke = std::get_if<LocalStroke>(&a.stack[i])) {
      EXPECT_EQ(stroke->curve, std::get<LocalStroke>(b.stack[i]).curve);
      EXPECT_EQ(stroke->artboard_from_stroke,
                std::get<LocalStroke>(b.stack[i]).artboard_from_stroke);
    } else if (const auto* group = std::get_if<GroupBegin>(&a.stack[i])) {
      EXPECT_EQ(group->opacity, std::get<GroupBegin>(b.stack[i]).opacity);
      EXPECT_EQ(group->blend, std::get<GroupBegin>(b.stack[i]).blend);
    }
  }
}

TEST(SvgRoundTrip, gives_back_every_number_of_random_drawings) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    const Document document = drawing(seed);
    ASSERT_TRUE(validate(Context{}, document).ok()) << validate(Context{}, document).message;
    const Document read = read_back(written(document));
    EXPECT_EQ(document.artboard, read.artboard);
    EXPECT_EQ(document.size_px, read.size_px);
    EXPECT_EQ(document.interpolation, read.interpolation);
    EXPECT_EQ(document.background, read.background);
    expect_same_curves(document, read);
    expect_same_stack(document, read);
    if (HasFailure()) return;
  }
}

TEST(SvgRoundTrip, writes_the_same_bytes_again) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    const std::string once = written(read_back(written(drawing(seed))));
    EXPECT_EQ(once, written(read_back(once))) << seed;
  }
}

TEST(SvgRoundTrip, gives_back_textures_and_gradients) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    Mixer mixer(seed);
    Document document = test::one_layer({test::circle_curve({50, 50}, 30)});
    document.shaders.push_back(paint(mixer, 0));
    document.layers[0].curves[0].left.color = {ShaderKind::image_domain, {}, 0};
    const Document read = read_back(written(document));
    ASSERT_EQ(read.shaders.size(), 1u);
    const Shader& mine = document.shaders[0];
    ASSERT_EQ(mine.paint.index(), read.shaders[0].paint.index());
    if (const auto* texture = std::get_if<Texture>(&mine.paint)) {
      const auto& other = std::get<Texture>(read.shaders[0].paint);
      EXPECT_EQ(texture->rgba, other.rgba);
      EXPECT_EQ(texture->layer_from_texture, other.layer_from_texture);
      EXPECT_EQ(other.period, Vec2{});
      EXPECT_TRUE(other.repeats);
      continue;
    }
    const auto& fill = std::get<GradientFill>(mine.paint);
    const auto& other = std::get<GradientFill>(read.shaders[0].paint);
    EXPECT_EQ(fill.shape.index(), other.shape.index());
    EXPECT_EQ(fill.spread, other.spread);
    EXPECT_EQ(fill.layer_from_gradient, other.layer_from_gradient);
    ASSERT_EQ(fill.stops.size(), other.stops.size());
    for (std::size_t i = 0; i < fill.stops.size(); ++i) {
      EXPECT_EQ(fill.stops[i].offset, other.stops[i].offset);
      EXPECT_EQ(fill.stops[i].color, other.stops[i].color);
      EXPECT_EQ(fill.stops[i].alpha, other.stops[i].alpha);
    }
  }
}

TEST(SvgRoundTrip, leaves_a_focus_where_it_was_moved_to) {
  Mixer mixer(7);
  for (int i = 0; i < 2000; ++i) {
    const double reach = mixer.chance() ? 40 : 1e7;
    const auto number = [&] { return std::to_string((2 * mixer.unit() - 1) * reach); };
    const std::string radius = std::to_string(mixer.unit() * (mixer.chance() ? 1 : 30));
    std::string text = R"(<svg xmlns="http://www.w3.org/2000/svg" xmlns:sf="urn:sfumato:1" )"
                       R"(viewBox="0 0 9 9"><radialGradient id="g" gradientUnits=")";
    text += mixer.chance() ? "userSpaceOnUse" : "objectBoundingBox";
    text += "\" cx=\"" + number() + "\" cy=\"" + number() + "\" fx=\"" + number() + "\" fy=\"" +
            number() + "\" r=\"" + radius +
            R"("><stop offset="0" stop-color="red"/><stop offset="1"/></radialGradient>)"
            R"-(<g sf:diffuse="true"><path d="M0 0L9 7" sf:left="url(#g)"/></g></svg>)-";
    Context context;
    const auto first = read_svg(context, text, "a.svg");
    if (!first) continue;  // moved beyond the largest coordinate
    const auto once = write_svg(context, first->document);
    ASSERT_TRUE(once.ok());
    const auto second = read_svg(context, *once, "b.svg");
    ASSERT_TRUE(second.ok()) << to_string(second.status()) << *once;
    const auto twice = write_svg(context, second->document);
    ASSERT_TRUE(twice.ok());
    ASSERT_EQ(*once, *twice);
  }
}

TEST(SvgRoundTrip, gives_back_the_artboard_exactly) {
  for (std::uint64_t seed = 0; seed < 1000; ++seed) {
    Mixer mixer(seed);
    Document document = drawing(0);
    const Vec2 corner = point(mixer);
    // Computed as in a reader, from a corner and a size.
    document.artboard = {corner, corner + Vec2{1 + 300 * mixer.unit(), 1e-3 + mixer.unit()}};
    EXPECT_EQ(read_back(written(document)).artboard, document.artboard) << seed;
  }
}

class SharedScene : public testing::TestWithParam<const char*> {};

TEST_P(SharedScene, converts_to_svg_exactly) {
  const std::optional<Document> document = test::shared_scene(GetParam());
  if (!document) GTEST_SKIP() << "no public scene " << GetParam();
  const std::string text = written(*document);
  const Document read = read_back(text);
  EXPECT_EQ(document->artboard, read.artboard);
  expect_same_curves(*document, read);
  expect_same_stack(*document, read);
  EXPECT_EQ(written(read), text);
}

INSTANTIATE_TEST_SUITE_P(SvgRoundTrip, SharedScene,
                         testing::Values("arch.xml", "circles.xml", "dolphin.xml", "drape.xml",
                                         "endcap.xml", "glass_droplet_blur.xml", "lady_bug.xml",
                                         "roses_spirales.xml", "tomatos.xml", "usvg_ladybug.xml"));

}  // namespace
}  // namespace sfumato
