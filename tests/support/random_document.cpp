#include "support/random_document.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "support/drawing.hpp"

namespace sfumato::test {
namespace {

constexpr int kBlendModeCount = static_cast<int>(BlendMode::luminosity) + 1;
constexpr int kDeepestGroup = 3;

class DocumentGenerator {
 public:
  explicit DocumentGenerator(std::uint64_t seed) : bits_(seed) {}

  Document generate() {
    document_.artboard.min = chance(0.5) ? Vec2{} : Vec2{real(-50, 50), real(-50, 50)};
    // A place where single precision has at most seven bits below a unit.
    if (chance(0.04)) document_.artboard.min = {real(-1e5, 1e5), real(-1e5, 1e5)};
    document_.artboard.max =
        document_.artboard.min + Vec2{1.0 * whole(96, 160), 1.0 * whole(96, 160)};
    document_.interpolation = static_cast<InterpolationSpace>(whole(0, 2));
    if (chance(0.6)) document_.background = color();
    for (int i = whole(0, 4); i > 0; --i) add_shader();
    for (int i = whole(1, 3); i > 0; --i) add_layer();
    add_items(0);
    if (document_.stack.empty()) add_instance();
    return std::move(document_);
  }

 private:
  double real(double from, double to) {
    return from + (to - from) * static_cast<double>(bits_() >> 11) * 0x1p-53;
  }
  float number(double from, double to) { return static_cast<float>(real(from, to)); }
  bool chance(double share) { return real(0, 1) < share; }
  /// Returns a number between from and to, both included.
  int whole(int from, int to) {
    return from + static_cast<int>(bits_() % static_cast<std::uint64_t>(to - from + 1));
  }

  Rgb color() {
    const float r = number(0, 1), g = number(0, 1), b = number(0, 1);
    return {r, g, b};
  }

  /// Returns a share that is often 0 or 1.
  float share() {
    const int kind = whole(0, 3);
    return kind < 2 ? static_cast<float>(kind) : number(0, 1);
  }

  Vec2 place() {
    const Box& box = document_.artboard;
    const double x = real(-0.15, 1.15), y = real(-0.15, 1.15);
    return box.min + on_grid({x * box.width(), y * box.height()});
  }

  /// Layers whose points lie on a grid have curves that meet, overlap and cross at whole numbers,
  /// and more than three vertices on one circle.
  Vec2 on_grid(Vec2 p) const {
    if (grid_ == 0) return p;
    return {grid_ * std::round(p.x / grid_), grid_ * std::round(p.y / grid_)};
  }

  /// Returns a map around the artboard's centre: rotation, mirroring, scale, shear, translation.
  Affine transform(double smallest, double largest) {
    const double angle = real(0, 2 * std::numbers::pi), scale = real(smallest, largest);
    const double stretch = chance(0.3) ? real(0.5, 2) : 1,
                 shear = chance(0.2) ? real(-0.5, 0.5) : 0;
    const double mirror = chance(0.3) ? -1 : 1;
    const Affine turned{scale * std::cos(angle),
                        scale * std::sin(angle),
                        -scale * std::sin(angle),
                        scale * std::cos(angle),
                        0,
                        0};
    const Vec2 center = document_.artboard.center(), moved{real(-50, 50), real(-50, 50)};
    return Affine{1, 0, 0, 1, center.x + moved.x, center.y + moved.y} * turned *
           Affine{mirror * stretch, 0, shear, 1, 0, 0} * Affine{1, 0, 0, 1, -center.x, -center.y};
  }

  template <class Value, class Make>
  StopList<Value> stops(std::size_t piece_count, Make make) {
    StopList<Value> list;
    list.space = chance(0.5) ? StopSpace::arc_length : StopSpace::parameter;
    // SVG has percentages, which not every fraction is.
    const double steps = list.space == StopSpace::parameter ? 1 : 100;
    const double end = list.space == StopSpace::parameter ? static_cast<double>(piece_count) : 1;
    for (int i = chance(0.03) ? whole(5, 40) : whole(1, 4); i > 0; --i) {
      const double offset = real(0, end * steps) / steps;
      list.stops.push_back({offset, make()});
    }
    std::ranges::sort(list.stops, {}, &Stop<Value>::offset);
    if (list.stops.size() > 2 && chance(0.3)) list.stops[1].offset = list.stops[2].offset;
    if (list.stops.size() > 1 && chance(0.6)) {
      list.stops.front().offset = 0;
      list.stops.back().offset = end;
    }
    return list;
  }

  void add_shader() {
    Shader shader{"paint " + std::to_string(document_.shaders.size()), {}};
    if (chance(0.4)) {
      shader.paint = texture();
    } else {
      shader.paint = gradient();
    }
    document_.shaders.push_back(std::move(shader));
  }

  GradientFill gradient() {
    GradientFill fill;
    const Vec2 start = place();
    if (chance(0.5)) {
      fill.shape = LinearGradient{start, place()};
    } else {
      const double radius = real(10, 80), angle = real(0, 6.28), reach = real(0, 0.9) * radius;
      fill.shape =
          RadialGradient{start, start + Vec2{std::cos(angle), std::sin(angle)} * reach, radius};
    }
    fill.spread = static_cast<SpreadMethod>(whole(0, 2));
    if (chance(0.5)) fill.layer_from_gradient = transform(0.4, 2);
    for (int i = whole(1, 4); i > 0; --i) {
      fill.stops.push_back({real(0, 1), color(), chance(0.5) ? 1 : number(0, 1)});
    }
    std::ranges::sort(fill.stops, {}, &GradientStop::offset);
    if (fill.stops.size() > 1 && chance(0.2)) fill.stops[0].offset = fill.stops[1].offset;
    return fill;
  }

  /// Returns waves of a few texels, so that close samples are similar.
  Texture texture() {
    Texture texture;
    texture.width = whole(1, 24);
    texture.height = whole(1, 24);
    const bool is_opaque = chance(0.5);
    const double wave[4] = {real(-1, 1), real(-1, 1), real(-1, 1), real(-1, 1)};
    for (int y = 0; y < texture.height; ++y) {
      for (int x = 0; x < texture.width; ++x) {
        for (int c = 0; c < 4; ++c) {
          const double value = 127.5 + 127 * std::sin(wave[c] * x + wave[3 - c] * y + c);
          texture.rgba.push_back(
              c == 3 && is_opaque ? 255 : static_cast<std::uint8_t>(std::lround(value)));
        }
      }
    }
    texture.layer_from_texture = transform(0.3, 6);
    if (chance(0.3)) {
      texture.period = {texture.width * real(0.5, 2), texture.height * real(0.5, 2)};
    }
    return texture;
  }

  Curve shape() {
    const int kind = chance(0.08) ? 5 : whole(0, 4);
    const Vec2 first = place();
    if (kind == 0) return straight_curve(first, place());
    if (kind == 1) return circle_curve(first, grid_ > 0 ? grid_ * whole(1, 6) : real(5, 60));
    if (kind == 2) return blob(first);
    if (kind == 5) return degenerate(first);
    Curve curve{.control_points = {first}};
    for (int piece = whole(1, 3); piece > 0; --piece) {
      const Vec2 last = curve.control_points.back();
      const double reach = kind == 3 ? 40 : 100;
      for (int i = 0; i < 3; ++i) {
        const double x = real(-reach, reach), y = real(-reach, reach);
        curve.control_points.push_back(last + on_grid({x, y}));
      }
    }
    return curve;
  }

  /// Returns nearly a point, a line that runs back on itself, or a side of the artboard.
  Curve degenerate(Vec2 first) {
    const int kind = whole(0, 2);
    const Vec2 far = kind == 0 ? first + Vec2{1e-3, 0} : place();
    if (kind < 2) return {.control_points = {first, far, far, first}};
    const Box& box = document_.artboard;
    return straight_curve(box.min,
                          chance(0.5) ? Vec2{box.max.x, box.min.y} : Vec2{box.min.x, box.max.y});
  }

  /// Returns a closed curve with a corner at each of its joints.
  Curve blob(Vec2 center) {
    const int pieces = whole(2, 5);
    const double turn = (chance(0.5) ? 2 : -2) * std::numbers::pi / (3 * pieces);
    Curve curve;
    for (int i = 0; i < 3 * pieces; ++i) {
      const double radius = real(12, 50), angle = i * turn;
      curve.control_points.push_back(center + Vec2{std::cos(angle), std::sin(angle)} * radius);
    }
    curve.control_points.push_back(curve.control_points.front());
    return curve;
  }

  template <class Value, class Make>
  SideShader<Value> side_shader(std::size_t piece_count, Make make) {
    const double kind = real(0, 1);
    if (kind < 0.12) return {};
    if (kind < 0.2) return {ShaderKind::barrier, {}, 0};
    if (kind < 0.4 && !document_.shaders.empty()) {
      const int last = static_cast<int>(document_.shaders.size()) - 1;
      return {ShaderKind::image_domain, {}, static_cast<std::uint32_t>(whole(0, last))};
    }
    return {ShaderKind::curve_domain, stops<Value>(piece_count, make), 0};
  }

  Side side(std::size_t pieces, bool has_color, bool has_opacity, bool is_blurred) {
    Side side;
    if (has_color) side.color = side_shader<Rgb>(pieces, [&] { return color(); });
    if (has_opacity) side.opacity = side_shader<float>(pieces, [&] { return share(); });
    if (is_blurred) {
      side.blur_radius =
          stops<float>(pieces, [&] { return chance(0.2) ? 0 : number(0, chance(0.1) ? 300 : 25); });
      // Writers omit radii that are 0 everywhere.
      side.blur_radius.stops.back().value += 0.01f;
    }
    return side;
  }

  void add_layer() {
    Layer layer{"layer " + std::to_string(document_.layers.size()), {}};
    grid_ = chance(0.2) ? whole(2, 16) : 0;
    const double opacity_share = whole(0, 2) * 0.5, color_share = chance(0.5) ? 1 : 0.7;
    const double blur_share = whole(0, 2) * 0.5;
    for (int i = chance(0.03) ? 0 : whole(1, 6); i > 0; --i) {
      Curve curve = shape();
      curve.id = layer.id + " curve " + std::to_string(i);
      const std::size_t pieces = curve.piece_count();
      const bool has_color = chance(color_share), has_opacity = chance(opacity_share);
      const bool is_blurred = chance(blur_share);
      curve.left = side(pieces, has_color, has_opacity, is_blurred);
      curve.right = side(pieces, has_color, has_opacity, chance(0.1) ? !is_blurred : is_blurred);
      if (chance(0.2)) curve.weight = chance(0.2) ? real(1e-6, 1e6) : real(0.1, 5);
      if (chance(0.2) && !layer.curves.empty()) meet(layer.curves.back(), curve);
      layer.curves.push_back(std::move(curve));
    }
    grid_ = 0;
    document_.layers.push_back(std::move(layer));
  }

  /// Moves a curve to begin where another one ends, or to run along it or back along it.
  void meet(const Curve& other, Curve& curve) {
    const Vec2 end = other.control_points.back();
    if (chance(0.5) || other.piece_count() != curve.piece_count()) {
      const Vec2 offset = end - curve.control_points.front();
      for (Vec2& p : curve.control_points) p = p + offset;
      return;
    }
    curve.control_points = other.control_points;
    if (chance(0.5)) std::ranges::reverse(curve.control_points);
  }

  float opacity() {
    if (chance(0.03)) return 0;
    return chance(0.5) ? 1 : number(0, 1);
  }
  BlendMode blend() {
    return chance(0.5) ? BlendMode::normal : static_cast<BlendMode>(whole(0, kBlendModeCount - 1));
  }

  void add_instance() {
    LayerInstance instance;
    instance.layer =
        static_cast<std::uint32_t>(whole(0, static_cast<int>(document_.layers.size()) - 1));
    if (chance(0.6))
      instance.artboard_from_layer = chance(0.15) ? transform(0.005, 20) : transform(0.2, 2.5);
    instance.opacity = opacity();
    instance.blend = blend();
    document_.stack.push_back(instance);
  }

  void add_stroke() {
    LocalStroke stroke;
    LocalCurve& curve = stroke.curve;
    curve.control_points = shape().control_points;
    const std::size_t pieces = (curve.control_points.size() - 1) / 3;
    curve.left_color = stops<Rgb>(pieces, [&] { return color(); });
    curve.right_color =
        chance(0.5) ? curve.left_color : stops<Rgb>(pieces, [&] { return color(); });
    if (chance(0.5)) curve.blur_radius = stops<float>(pieces, [&] { return number(0, 10); });
    curve.influence_radius =
        stops<float>(pieces, [&] { return chance(0.1) ? 0 : number(0.5, 15); });
    curve.influence_radius.stops.back().value += 0.5f;  // above 0 somewhere
    curve.alpha = real(0, 1.5);
    if (chance(0.4)) stroke.artboard_from_stroke = transform(0.3, 2);
    document_.stack.push_back(std::move(stroke));
  }

  void add_items(int depth) {
    for (int i = whole(1, 3); i > 0; --i) {
      const double kind = real(0, 1);
      if (kind < 0.2 && depth < kDeepestGroup) {
        const int deep = depth == 0 && chance(0.1) ? 8 : 1;
        for (int g = 0; g < deep; ++g) document_.stack.push_back(GroupBegin{opacity(), blend()});
        add_items(depth + 1);
        for (int g = 0; g < deep; ++g) document_.stack.push_back(GroupEnd{});
      } else if (kind < 0.4) {
        add_stroke();
      } else {
        add_instance();
      }
    }
  }

  std::mt19937_64 bits_;
  double grid_ = 0;  ///< of the current layer, units; 0: none
  Document document_;
};

}  // namespace

Document random_document(std::uint64_t seed) {
  return DocumentGenerator(seed).generate();
}

}  // namespace sfumato::test
