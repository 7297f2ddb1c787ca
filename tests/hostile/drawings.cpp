#include "hostile/drawings.hpp"

#include <array>
#include <cmath>
#include <cstdio>

#include "hostile/documents.hpp"

namespace sfumato::hostile {

std::string decimal(double value) {
  char text[32];
  std::snprintf(text, sizeof(text), "%.9g", value);
  return text;
}

std::string colours(std::size_t count) {
  static constexpr std::array<const char*, 3> kColours{"red", "blue", "lime"};
  std::string all;
  for (std::size_t i = 0; i < count; ++i) {
    all += (i > 0 ? "," : "") + std::string(kColours[i % kColours.size()]);
  }
  return all;
}

std::string open_below(const std::string& data, std::size_t stops) {
  return layer("<path d='" + data + "' sf:left='" + colours(stops) + "'/>");
}

std::string concentric_circles(std::size_t count, const std::string& attributes) {
  std::string circles;
  for (std::size_t i = 1; i <= count; ++i) {
    const double radius = 24.0 * static_cast<double>(i) / static_cast<double>(count);
    circles += "<circle cx='50' cy='25' r='" + decimal(radius) + "' " + attributes + "/>";
  }
  return layer(circles);
}

std::string parallel_lines(std::size_t count, double height, const std::string& attributes) {
  std::string lines;
  for (std::size_t i = 0; i < count; ++i) {
    const double y = 9 + height * static_cast<double>(i) / static_cast<double>(count);
    lines += "<path d='M9 " + decimal(y) + "h80' " + attributes + "/>";
  }
  return layer(lines);
}

std::string dust_curves(std::size_t count, const std::string& attributes) {
  std::string curves;
  for (std::size_t i = 0; i < count; ++i) {
    const double along = static_cast<double>(i);
    curves += "<path " + attributes + " d='M" + decimal(std::fmod(along * 61.8033989, 99)) + " " +
              decimal(std::fmod(along * 75.4877666, 49)) + "l.03 .02'/>";
  }
  return curves;
}

std::string dust(std::size_t count, const std::string& attributes) {
  return layer(dust_curves(count, attributes));
}

}  // namespace sfumato::hostile
