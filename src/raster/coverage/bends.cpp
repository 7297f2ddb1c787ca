#include "raster/coverage/bends.hpp"

#include <array>
#include <cmath>

#include "base/poll.hpp"
#include "base/try.hpp"
#include "picture/patch.hpp"

namespace sfumato::raster {
namespace {

/// A parabola that deviates this much in the middle of an edge has a mean over a third of it that
/// is wrong by a code value.
constexpr float kStraight = 7.0f / 255;

bool bends(const PatchField& field, std::size_t triangle) {
  const auto channels = static_cast<std::size_t>(field.channel_count);
  std::array<const float*, kNodesPerTriangle> node;
  for (std::size_t i = 0; i < kNodesPerTriangle; ++i)
    node[i] = field.node_value.data() + channels * field.triangle_node[node_slot(triangle, i)];
  for (std::size_t c = 0; c < channels; ++c) {
    for (std::size_t k = 0; k < 3; ++k) {
      const float from = node[k][c], to = node[(k + 1) % 3][c];
      const float near = node[near_node(k)][c], far = node[far_node(k)][c];
      const float step = (to - from) / 3;
      if (std::fabs(near - from - step) > kStraight || std::fabs(to - step - far) > kStraight)
        return true;
    }
    const float mean = (node[0][c] + node[1][c] + node[2][c]) / 3;
    if (std::fabs(node[kCenterNode][c] - mean) > kStraight) return true;
  }
  return false;
}

}  // namespace

Result<std::vector<std::uint8_t>> bent_triangles(Context& context, const PatchLayer& layer,
                                                 TableMemory& memory) {
  std::vector<std::uint8_t> bent;
  SFUMATO_TRY(memory.resize(context, bent, layer.triangle_count()));
  if (layer.exact_points) return bent;
  RarePoll<16384> poll(context);
  for (std::size_t t = 0; t < bent.size(); ++t) {
    if (poll.cancelled()) return context.cancel_status();
    bent[t] = bends(layer.color, t) || (layer.opacity.channel_count > 0 && bends(layer.opacity, t));
  }
  SFUMATO_TRY(context.check());
  return bent;
}

}  // namespace sfumato::raster
