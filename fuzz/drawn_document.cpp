#include "drawn_document.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "sfumato/formats/read_document.hpp"

namespace sfumato::fuzz {
namespace {

constexpr unsigned kBlendModes = static_cast<unsigned>(BlendMode::luminosity) + 1;
constexpr unsigned kMostItems = 8;
constexpr unsigned kMostCurves = 8;

class Drawer {
 public:
  explicit Drawer(Bytes bytes) : reader_(bytes) {}

  Document draw() {
    constexpr double kSides[] = {64, 1, 4096, 96, 4e5, 1e-4};
    constexpr double kShapes[] = {1, 0.5, 2, 0.0625};
    const double width = kSides[reader_.below(6)], height = width * kShapes[reader_.below(4)];
    document_.artboard.min = reader_.below(2) == 0 ? Vec2{} : Vec2{-17, 33};
    document_.artboard.max = document_.artboard.min + Vec2{width, height};
    document_.interpolation = static_cast<InterpolationSpace>(reader_.below(3));
    if (reader_.below(2) == 0) document_.background = value(Rgb{});
    for (unsigned i = reader_.below(4); i > 0; --i) add_shader();
    for (unsigned i = 1 + reader_.below(3); i > 0; --i) add_layer();
    for (unsigned i = 1 + reader_.below(kMostItems); i > 0; --i) add_item();
    for (; open_groups_ > 0; --open_groups_) document_.stack.push_back(GroupEnd{});
    return std::move(document_);
  }

 private:
  float value(float) { return static_cast<float>(reader_.unit()); }
  Rgb value(Rgb) {
    const float r = value(0.f), g = value(0.f), b = value(0.f);
    return {r, g, b};
  }

  /// Returns shares of the artboard: mostly inside, sometimes at its edge, far away or near a known
  /// point.
  Vec2 point() {
    const Vec2 corner = document_.artboard.min;
    const double width = document_.artboard.width(), height = document_.artboard.height();
    const unsigned pick = reader_.below(8);
    if (pick < 2 && !known_.empty()) {
      Vec2 p = known_[reader_.byte() % known_.size()];
      if (pick == 1) p.x += std::ldexp(width, -static_cast<int>(reader_.below(48)));
      return p;
    }
    const double x = reader_.byte(), y = reader_.byte();
    const double spread = pick == 2 ? 16 : pick == 3 ? 1 : 1.5;
    const Vec2 p = corner + Vec2{(x / 255 - (spread - 1) / (2 * spread)) * spread * width,
                                 (y / 255 - (spread - 1) / (2 * spread)) * spread * height};
    known_.push_back(p);
    return p;
  }

  std::vector<Vec2> chain() {
    const unsigned shape = reader_.byte();
    const unsigned pieces = 1 + shape % 3;
    std::vector<Vec2> points{point()};
    for (unsigned i = 0; i < pieces; ++i) {
      const Vec2 from = points.back();
      if ((shape & 4) != 0) {
        const Vec2 to = point();
        points.insert(points.end(), {lerp(from, to, 1.0 / 3), lerp(from, to, 2.0 / 3), to});
      } else {
        for (int k = 0; k < 3; ++k) points.push_back(point());
      }
    }
    if ((shape & 8) != 0) points.back() = points.front();
    return points;
  }

  template <class Value>
  StopList<Value> stops(std::size_t pieces, double scale = 1) {
    const unsigned shape = reader_.byte();
    StopList<Value> list;
    list.space = (shape & 1) != 0 ? StopSpace::parameter : StopSpace::arc_length;
    const double end = list.space == StopSpace::parameter ? static_cast<double>(pieces) : 1;
    for (unsigned i = 0; i <= (shape >> 1) % 4; ++i) {
      Value made = value(Value{});
      if constexpr (std::is_same_v<Value, float>) made *= static_cast<float>(scale);
      list.stops.push_back({end * reader_.byte() / 255, made});
    }
    std::ranges::stable_sort(list.stops, {}, &Stop<Value>::offset);
    return list;
  }

  template <class Value>
  SideShader<Value> side_shader(std::size_t pieces) {
    const unsigned pick = reader_.below(8);
    if (pick == 0) return {};
    if (pick == 1) return {ShaderKind::barrier, {}, 0};
    if (pick == 2 && !document_.shaders.empty()) {
      return {ShaderKind::image_domain, {}, reader_.byte() % shader_count()};
    }
    return {ShaderKind::curve_domain, stops<Value>(pieces), 0};
  }

  std::uint32_t shader_count() const {
    return static_cast<std::uint32_t>(document_.shaders.size());
  }

  double longer_side() const {
    return std::max(document_.artboard.width(), document_.artboard.height());
  }

  Side side(std::size_t pieces, unsigned features) {
    Side made{side_shader<Rgb>(pieces), {}, {}};
    if ((features & 1) != 0) made.opacity = side_shader<float>(pieces);
    if ((features & 2) != 0) made.blur_radius = stops<float>(pieces, longer_side() / 4);
    return made;
  }

  void add_layer() {
    Layer layer{"layer", {}};
    for (unsigned i = reader_.below(kMostCurves + 1); i > 0; --i) {
      Curve curve;
      curve.control_points = chain();
      const unsigned features = reader_.byte();
      curve.left = side(curve.piece_count(), features);
      curve.right = (features & 4) != 0 ? curve.left : side(curve.piece_count(), features);
      if ((features & 8) != 0) curve.weight = std::ldexp(1.0, int(reader_.below(16)) - 8);
      layer.curves.push_back(std::move(curve));
    }
    document_.layers.push_back(std::move(layer));
  }

  Affine map() {
    switch (reader_.below(4)) {
      case 0: {
        const double x = reader_.unit(), y = reader_.unit();
        return {1, 0, 0, 1, x * longer_side(), y * longer_side()};
      }
      case 1: {
        const double angle = 2 * reader_.unit(), scale = std::ldexp(1.0, int(reader_.below(8)) - 5);
        // Nearly a rotation, without libm, so that seeds mean the same on every machine.
        return {scale * (1 - angle * angle / 2),
                scale * angle,
                -scale * angle,
                scale * (1 - angle * angle / 2),
                0,
                0};
      }
      case 2:
        return {-1, 0, reader_.unit(), 1, longer_side(), 0};
      default:
        return {};
    }
  }

  float share() { return reader_.below(2) == 0 ? 1.f : value(0.f); }
  BlendMode blend() {
    return reader_.below(2) == 0 ? BlendMode::normal
                                 : static_cast<BlendMode>(reader_.below(kBlendModes));
  }

  LocalCurve local_curve() {
    LocalCurve curve{.id = "stroke",
                     .control_points = chain(),
                     .left_color = {},
                     .right_color = {},
                     .blur_radius = {},
                     .influence_radius = {}};
    const std::size_t pieces = (curve.control_points.size() - 1) / 3;
    curve.left_color = stops<Rgb>(pieces);
    curve.right_color = stops<Rgb>(pieces);
    if (reader_.below(2) == 0) curve.blur_radius = stops<float>(pieces, longer_side() / 8);
    curve.influence_radius = stops<float>(pieces, longer_side() / 4);
    curve.influence_radius.stops.back().value += static_cast<float>(longer_side() / 100);
    curve.alpha = reader_.unit() * 2;
    return curve;
  }

  void add_item() {
    switch (reader_.below(8)) {
      case 0:
        if (open_groups_ >= 3) return;
        ++open_groups_;
        document_.stack.push_back(GroupBegin{share(), blend()});
        return;
      case 1:
        if (open_groups_ == 0) return;
        --open_groups_;
        document_.stack.push_back(GroupEnd{});
        return;
      case 2:
      case 3:
        document_.stack.push_back(LocalStroke{local_curve(), map()});
        return;
      default: {
        const auto layer = static_cast<std::uint32_t>(reader_.byte() % document_.layers.size());
        document_.stack.push_back(LayerInstance{layer, map(), share(), blend()});
      }
    }
  }

  void add_shader() {
    Shader shader{"paint", {}};
    if (reader_.below(3) == 0) {
      shader.paint = texture();
    } else {
      shader.paint = gradient();
    }
    document_.shaders.push_back(std::move(shader));
  }

  Texture texture() {
    Texture made;
    made.width = 1 + static_cast<int>(reader_.below(4));
    made.height = 1 + static_cast<int>(reader_.below(4));
    for (int i = 0; i < 4 * made.width * made.height; ++i) made.rgba.push_back(reader_.byte());
    made.layer_from_texture = map();
    if (reader_.below(2) == 0) made.period = {1 + 8 * reader_.unit(), 1 + 8 * reader_.unit()};
    return made;
  }

  GradientFill gradient() {
    GradientFill fill;
    if (reader_.below(2) == 0) {
      const Vec2 start = point(), end = point();
      fill.shape = LinearGradient{start, end};
    } else {
      const Vec2 center = point();
      const double radius = longer_side() * (reader_.unit() + 1e-6);
      const double x = reader_.unit() - 0.5, y = reader_.unit() - 0.5;
      fill.shape = RadialGradient{center, center + Vec2{x * radius, y * radius}, radius};
    }
    fill.spread = static_cast<SpreadMethod>(reader_.below(3));
    fill.layer_from_gradient = map();
    double offset = 0;
    for (unsigned i = 1 + reader_.below(4); i > 0; --i) {
      offset = std::min(1.0, offset + reader_.below(4) / 4.0);
      const Rgb color = value(Rgb{});
      fill.stops.push_back({offset, color, share()});
    }
    return fill;
  }

  ByteReader reader_;
  Document document_;
  std::vector<Vec2> known_;
  int open_groups_ = 0;
};

}  // namespace

bool is_file(Bytes bytes) {
  return as_text(bytes).starts_with('<') || as_text(bytes).starts_with("\x1f\x8b");
}

std::optional<Document> drawn_document(Context& context, Bytes bytes) {
  if (!is_file(bytes)) return Drawer(bytes).draw();
  Result<ReadDocument> read = read_document(context, as_text(bytes), "fuzz");
  if (!read) return std::nullopt;
  return std::move(read->document);
}

bool is_small(const Document& document) {
  constexpr std::size_t kCurves = 8, kItems = 12;
  std::size_t curves = 0;
  for (const Layer& layer : document.layers) curves += layer.curves.size();
  return curves <= kCurves && document.stack.size() <= kItems;
}

DiffuseOptions coarse_options(const Document& document) {
  constexpr double kSide = 32;
  constexpr double kMostScale = 1e9;  // an artboard may be so small that a quotient is infinite
  DiffuseOptions options;
  const double side = std::max(document.artboard.width(), document.artboard.height());
  options.pixels_per_unit = std::min(kSide / side, kMostScale);
  options.max_error = 16;
  return options;
}

}  // namespace sfumato::fuzz
