#include "limits/large_inputs.hpp"

#include <utility>

#include "support/drawing.hpp"

namespace sfumato::test {
namespace {

constexpr double kSide = 4096;

/// The same numbers on every machine.
class Noise {
 public:
  std::uint32_t next() {
    state_ = state_ * 6364136223846793005u + 1442695040888963407u;
    return static_cast<std::uint32_t>(state_ >> 33);
  }
  double share() { return next() / 2147483648.0; }

 private:
  std::uint64_t state_ = 1;
};

struct Line {
  Vec2 from, to;
};

std::vector<Line> scattered_lines(std::size_t count) {
  Noise noise;
  std::vector<Line> lines(count);
  for (Line& line : lines) {
    line.from = {kSide * noise.share(), kSide * noise.share()};
    line.to = line.from + Vec2{20 * noise.share() - 10, 20 * noise.share() - 10};
  }
  return lines;
}

std::string number(double value) {
  return std::to_string(value);
}

}  // namespace

const char* name_of(ShapePlaces places) {
  switch (places) {
    case ShapePlaces::apart:
      return "apart";
    case ShapePlaces::on_ground:
      return "on an opaque ground";
    case ShapePlaces::overlapping:
      break;
  }
  return "over each other";
}

std::string many_shapes_svg(int count, ShapePlaces places) {
  std::string svg = "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 1000 1000'>";
  if (places == ShapePlaces::on_ground) {
    svg += "<path d='M1 1H999V999H1z' fill='#eee'/>";
  }
  const int columns = 100;
  const double radius = places == ShapePlaces::overlapping ? 7 : 3;
  for (int i = 0; i < count; ++i) {
    const double x = 10 * (i % columns) + 5;
    const double y = 1000.0 / count * columns * (i / columns + 0.5);
    svg += "<circle cx='" + number(x) + "' cy='" + number(y) + "' r='" + number(radius) +
           "' fill='#" + std::to_string(100 + i % 900) + "'/>";
  }
  return svg + "</svg>";
}

Document curve_of_many_stops(std::size_t stop_count) {
  Curve curve = straight_curve({10, 50}, {90, 50});
  SideShader<Rgb> colors{ShaderKind::curve_domain, {StopSpace::parameter, {}}, 0};
  for (std::size_t i = 0; i < stop_count; ++i) {
    const double offset = static_cast<double>(i) / static_cast<double>(stop_count);
    colors.stops.stops.push_back({offset, i % 2 == 0 ? kRed : kGreen});
  }
  curve.left.color = colors;
  curve.right.color = std::move(colors);
  return one_layer({std::move(curve)});
}

Document many_curves(std::size_t curve_count) {
  std::vector<Curve> curves;
  curves.reserve(curve_count);
  for (const Line& line : scattered_lines(curve_count)) {
    curves.push_back(colored(straight_curve(line.from, line.to), kRed, kGreen));
  }
  return one_layer(std::move(curves), {{0, 0}, {kSide, kSide}});
}

std::string many_curves_svg(std::size_t curve_count) {
  std::string text =
      "<svg xmlns='http://www.w3.org/2000/svg' xmlns:sf='urn:sfumato:1' "
      "viewBox='0 0 4096 4096'><g sf:diffuse='true'>\n";
  for (const Line& line : scattered_lines(curve_count)) {
    text += "<path d='M" + number(line.from.x) + " " + number(line.from.y) + "L" +
            number(line.to.x) + " " + number(line.to.y) + "' sf:left='red' sf:right='lime'/>\n";
  }
  return text + "</g></svg>";
}

std::string many_curves_orzan(std::size_t curve_count) {
  std::string text = "<curve_set image_width='4096' image_height='4096'>\n";
  for (const Line& line : scattered_lines(curve_count)) {
    text += "<curve><control_points_set>";
    for (int i = 0; i < 4; ++i) {
      const Vec2 p = lerp(line.from, line.to, i / 3.0);
      text += "<control_point x='" + number(p.x) + "' y='" + number(p.y) + "'/>";
    }
    text +=
        "</control_points_set><left_colors_set><left_color R='255' G='0' B='0' globalID='0'/>"
        "</left_colors_set><right_colors_set><right_color R='0' G='255' B='0' globalID='0'/>"
        "</right_colors_set></curve>\n";
  }
  return text + "</curve_set>";
}

std::string long_path_svg(std::size_t piece_count) {
  std::string text =
      "<svg xmlns='http://www.w3.org/2000/svg' xmlns:sf='urn:sfumato:1' "
      "viewBox='0 0 4096 4096'><g sf:diffuse='true'><path sf:left='red' d='M0 0";
  for (std::size_t i = 0; i < piece_count; ++i) text += i % 2 == 0 ? "l3 2" : "l-2-3";
  return text + "'/></g></svg>";
}

Document many_strokes(std::size_t count, float radius) {
  Document document = one_layer({}, {{0, 0}, {kSide, kSide}});
  document.stack.clear();
  for (const Line& line : scattered_lines(count)) {
    LocalStroke stroke;
    stroke.curve.control_points = straight_curve(line.from, line.to).control_points;
    stroke.curve.left_color = one_color(kRed).stops;
    stroke.curve.right_color = one_color(kGreen).stops;
    stroke.curve.influence_radius = {StopSpace::parameter, {{0, radius}}};
    document.stack.emplace_back(std::move(stroke));
  }
  return document;
}

Image noise_image(int width, int height, PixelFormat format) {
  Image image{width, height, format, {}};
  image.bytes.resize(image.row_bytes() * static_cast<std::size_t>(height));
  Noise noise;
  for (std::uint8_t& byte : image.bytes) byte = static_cast<std::uint8_t>(noise.next() >> 20);
  return image;
}

Document textured_curve(int side) {
  Curve curve = colored(circle_curve({50, 50}, 30), kRed, kGreen);
  curve.right.color = {ShaderKind::image_domain, {}, 0};
  Document document = one_layer({std::move(curve)});
  Texture texture;
  texture.width = texture.height = side;
  texture.rgba = noise_image(side, side, PixelFormat::rgba8).bytes;
  texture.layer_from_texture = {100.0 / side, 0, 0, 100.0 / side, 0, 0};
  document.shaders.push_back({"texture", std::move(texture)});
  return document;
}

}  // namespace sfumato::test
