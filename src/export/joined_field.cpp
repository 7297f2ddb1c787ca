#include "export/joined_field.hpp"

#include <numeric>
#include <utility>
#include <vector>

#include "base/poll.hpp"
#include "export/poll_interval.hpp"

namespace sfumato::outputs {
namespace {

/// The node pairs, of colour and of opacity, that the corners and edges of patches use.
struct NodePairs {
  std::vector<std::uint32_t> triangle_node;  ///< kNodesPerTriangle per triangle
  std::vector<std::pair<std::uint32_t, std::uint32_t>> node;
};

/// Their tables are of `memory`.
Result<NodePairs> pair_nodes(Context& context, const PatchField& color, const PatchField& opacity,
                             TableMemory& memory) {
  const std::size_t slots = color.triangle_node.size();
  const auto key = [&](std::uint32_t slot) {
    return std::pair(color.triangle_node[slot], opacity.triangle_node[slot]);
  };
  TableMemory scratch("colours and opacity of a layer");
  std::vector<std::uint32_t> order;
  NodePairs pairs;
  Status status = scratch.resize(context, order, slots);
  if (status) status = memory.resize(context, pairs.triangle_node, slots);
  if (!status) return status;
  std::iota(order.begin(), order.end(), 0u);
  const auto is_before = [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); };
  if (status = TableMemory::sort(context, order, is_before); !status) return status;
  RarePoll<kTurnsPerPoll> poll(context);
  for (const std::uint32_t slot : order) {
    if (poll.cancelled()) return context.cancel_status();
    if (pairs.node.empty() || pairs.node.back() != key(slot)) {
      status = memory.push_back(context, pairs.node, key(slot));
      if (!status) return status;
    }
    pairs.triangle_node[slot] = static_cast<std::uint32_t>(pairs.node.size() - 1);
  }
  return pairs;
}

}  // namespace

Result<PatchField> joined_field(Context& context, const PatchField& color,
                                const PatchField& opacity, TableMemory& memory) {
  const auto channels = static_cast<std::size_t>(color.channel_count);
  PatchField both{4, {}, {}, {}};
  const auto add = [&](std::size_t color_node, float alpha) {
    const float* value = color.node_value.data() + channels * color_node;
    both.node_value.insert(both.node_value.end(), {value[0], value[1], value[2], alpha});
  };
  RarePoll<kTurnsPerPoll> poll(context);
  if (opacity.channel_count == 0) {
    const std::size_t values = color.node_value.size() / channels * 4;
    Status status = memory.append(context, color.triangle_node, both.triangle_node);
    if (status) status = memory.reserve(context, both.node_value, values);
    if (!status) return status;
    for (std::size_t i = 0; i * channels < color.node_value.size(); ++i) {
      if (poll.cancelled()) return context.cancel_status();
      add(i, 1);
    }
    return both;
  }
  Result<NodePairs> pairs = pair_nodes(context, color, opacity, memory);
  if (!pairs) return pairs.status();
  both.triangle_node = std::move(pairs->triangle_node);
  Status status = memory.reserve(context, both.node_value, 4 * pairs->node.size());
  if (!status) return status;
  const auto stride = static_cast<std::size_t>(opacity.channel_count);
  for (const auto& [c, o] : pairs->node) {
    if (poll.cancelled()) return context.cancel_status();
    add(c, opacity.node_value[stride * o]);
  }
  return both;
}

}  // namespace sfumato::outputs
