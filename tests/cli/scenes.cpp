#include "cli/scenes.hpp"

#include <cmath>

#include "sfumato/codecs/png.hpp"

namespace sfumato::test {
namespace {

std::string color_set(const std::string& side, const std::string& color) {
  return "<" + side + "_colors_set><" + side + "_color " + color + " globalID=\"0\"/></" + side +
         "_colors_set>";
}

std::string point(double x, double y) {
  return point_xml(std::to_string(x), std::to_string(y));
}

// The files swap red and blue.
constexpr const char* kOrange = R"(B="255" G="128" R="0")";
constexpr const char* kBlue = R"(B="20" G="40" R="200")";
constexpr const char* kGreen = R"(B="30" G="180" R="60")";
constexpr const char* kViolet = R"(B="140" G="20" R="160")";

}  // namespace

std::string curve_xml(const std::string& points, const std::string& left,
                      const std::string& right) {
  return "<curve>\n<control_points_set>\n" + points + "</control_points_set>\n" +
         color_set("left", left) + "\n" + color_set("right", right) +
         "\n<blur_points_set><best_scale value=\"0\" globalID=\"0\"/></blur_points_set>\n"
         "</curve>\n";
}

std::string point_xml(const std::string& x, const std::string& y) {
  return "<control_point x=\"" + y + "\" y=\"" + x + "\"/>\n";
}

std::string scene_xml(int width, int height, const std::string& curves) {
  return "<!DOCTYPE CurveSetXML>\n<curve_set image_width=\"" + std::to_string(width) +
         "\" image_height=\"" + std::to_string(height) + "\">\n" + curves + "</curve_set>\n";
}

std::string two_curve_scene() {
  const std::string closed = point(20, 10) + point(34, 10) + point(34, 38) + point(20, 38) +
                             point(6, 38) + point(6, 10) + point(20, 10);
  const std::string open = point(44, 6) + point(60, 12) + point(36, 18) + point(50, 24) +
                           point(64, 30) + point(40, 36) + point(52, 42);
  return scene_xml(64, 48, curve_xml(closed, kBlue, kOrange) + curve_xml(open, kGreen, kViolet));
}

std::string busy_scene(int count) {
  std::string curves;
  for (int i = 0; i < count; ++i) {
    const double x = 20 + std::fmod(i * 61.803, 460);
    const double y = 20 + std::fmod(i * 38.197, 460);
    curves +=
        curve_xml(point(x, y) + point(x + 9, y - 12) + point(x + 15, y + 14) + point(x + 21, y + 3),
                  i % 2 ? kOrange : kGreen, i % 3 ? kBlue : kViolet);
  }
  return scene_xml(512, 512, curves);
}

std::string repeated(const std::string& text, std::size_t count) {
  std::string result;
  result.reserve(text.size() * count);
  for (std::size_t i = 0; i < count; ++i) result += text;
  return result;
}

std::string text_of(const std::vector<std::uint8_t>& bytes) {
  return {bytes.begin(), bytes.end()};
}

std::string png_of(const Image& image) {
  Context context;
  const auto bytes = encode_png(context, image);
  return bytes ? std::string(bytes->begin(), bytes->end()) : std::string();
}

Image image_of(const std::string& png) {
  Context context;
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(png.data());
  const Result<Image> image = decode_png(context, {bytes, png.size()}, "picture");
  return image ? *image : Image();
}

}  // namespace sfumato::test
