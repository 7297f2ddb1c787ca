#include "raster/coverage/split_triangle.hpp"

#include <utility>

namespace sfumato::raster {

SplitTriangle split_triangle(const double (&distance)[3]) {
  const bool is_above[3] = {distance[0] > 0, distance[1] > 0, distance[2] > 0};
  const int alone = is_above[0] == is_above[1] ? 2 : is_above[0] == is_above[2] ? 1 : 0;
  const int next = alone < 2 ? alone + 1 : 0;
  const int last = 3 - alone - next;
  // The line cuts the two edges of the corner that is alone on its side, this far along them.
  const double d = distance[alone];
  const double to_next = d / (d - distance[next]), to_last = d / (d - distance[last]);
  double weight[3];
  weight[next] = to_next / 3;
  weight[last] = to_last / 3;
  weight[alone] = 1 - weight[next] - weight[last];
  const SplitPart tip{to_next * to_last, weight[1], weight[2]};
  // Both parts' moments add up to the triangle's.
  SplitPart rest{1 - tip.share, 0, 0};
  if (rest.share > 0) {
    rest.u = (1.0 / 3 - tip.share * tip.u) / rest.share;
    rest.v = (1.0 / 3 - tip.share * tip.v) / rest.share;
  }
  SplitTriangle parts{rest, tip};
  if (!is_above[alone]) std::swap(parts.below, parts.above);
  return parts;
}

}  // namespace sfumato::raster
