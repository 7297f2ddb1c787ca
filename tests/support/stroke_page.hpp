#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "sfumato/base/image.hpp"
#include "sfumato/base/vec2.hpp"

namespace sfumato::test {

struct PenLine {
  Vec2 from, to;
};

inline double distance_to(const PenLine& line, Vec2 p) {
  const Vec2 way = line.to - line.from;
  const double t = std::clamp(dot(p - line.from, way) / dot(way, way), 0.0, 1.0);
  return length(line.from + t * way - p);
}

/// How far a place of a square of 14 pixels is from the middle of the strokes of a letter: T, o, h
/// or x.
inline double distance_to_letter(int letter, Vec2 p) {
  using Lines = std::array<PenLine, 3>;
  constexpr std::array<Lines, 3> kLines{
      Lines{{{{2, 2}, {12, 2}}, {{7, 2}, {7, 12}}, {{7, 2}, {7, 12}}}},
      Lines{{{{3, 1}, {3, 12}}, {{3, 6}, {10, 6}}, {{10, 6}, {10, 12}}}},
      Lines{{{{3, 3}, {11, 12}}, {{11, 3}, {3, 12}}, {{11, 3}, {3, 12}}}}};
  if (letter % 4 == 1) return std::fabs(length(p - Vec2{7, 7.5}) - 4);
  double least = 14;
  for (const PenLine& line : kLines[static_cast<std::size_t>(letter % 4 * 2 / 3)]) {
    least = std::min(least, distance_to(line, p));
  }
  return least;
}

/// A page of letters, black on white without grey, whose strokes are two pixels wide.
inline Image stroke_page(int columns, int lines) {
  constexpr int kCell = 24;
  Image image{kCell * columns, kCell * lines, PixelFormat::rgb8, {}};
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const Vec2 p{x % kCell + 0.5, y % kCell + 0.5};
      const bool is_ink = distance_to_letter(x / kCell + y / kCell, p) < 1;
      image.bytes.insert(image.bytes.end(), 3, static_cast<std::uint8_t>(is_ink ? 0 : 255));
    }
  }
  return image;
}

}  // namespace sfumato::test
