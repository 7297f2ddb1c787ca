#include "export/joined_field.hpp"

#include <numeric>
#include <utility>
#include <vector>

#include "base/poll.hpp"
#include "base/try.hpp"
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
  SFUMATO_TRY(scratch.resize(context, order, slots));
  SFUMATO_TRY(memory.resize(context, pairs.triangle_node, slots));
  std::iota(order.begin(), order.end(), 0u);
  const auto is_before = [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); };
  SFUMATO_TRY(TableMemory::sort(context, order, is_before));
  RarePoll<kTurnsPerPoll> poll(context);
  for (const std::uint32_t slot : order) {
    if (poll.cancelled()) return context.cancel_status();
    if (pairs.node.empty() || pairs.node.back() != key(slot)) {
      SFUMATO_TRY(memory.push_back(context, pairs.node, key(slot)));
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
    SFUMATO_TRY(memory.append(context, color.triangle_node, both.triangle_node));
    SFUMATO_TRY(memory.reserve(context, both.node_value, values));
    for (std::size_t i = 0; i * channels < color.node_value.size(); ++i) {
      if (poll.cancelled()) return context.cancel_status();
      add(i, 1);
    }
    return both;
  }
  SFUMATO_TRY_ASSIGN(auto&& pairs, pair_nodes(context, color, opacity, memory));
  both.triangle_node = std::move(pairs.triangle_node);
  SFUMATO_TRY(memory.reserve(context, both.node_value, 4 * pairs.node.size()));
  const auto stride = static_cast<std::size_t>(opacity.channel_count);
  for (const auto& [c, o] : pairs.node) {
    if (poll.cancelled()) return context.cancel_status();
    add(c, opacity.node_value[stride * o]);
  }
  return both;
}

}  // namespace sfumato::outputs
