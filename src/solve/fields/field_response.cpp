#include <algorithm>

#include "base/poll.hpp"
#include "base/try.hpp"
#include "solve/fields/field_solver.hpp"

namespace sfumato::solve {

Status FieldSolver::take_over(Context& context, const RefinedField& known, int first_channel,
                              int base_channels) {
  TableMemory scratch("patches");
  SFUMATO_TRY_ASSIGN(auto&& asks, asked_nodes(context, scratch));
  std::vector<std::uint32_t> carried;
  SFUMATO_TRY(scratch.reserve(context, carried, layout_.node_count()));
  SFUMATO_TRY(copy_known(context, known, first_channel, base_channels, asks, carried));
  if (field_.attributes.has_response) {
    SFUMATO_TRY(field_.gatherer.find_dependents(context, {layout_.position, carried},
                                                field_.attributes.base_channels - 1, asks));
  }
  keep_asked(asks);
  return ok_status();
}

Status FieldSolver::copy_known(const Context& context, const RefinedField& known, int first_channel,
                               int base_channels, std::span<std::uint8_t> asks,
                               std::vector<std::uint32_t>& carried) {
  const NodeLayout& old = known.layout;
  const int own_base = field_.attributes.base_channels - (field_.attributes.has_response ? 1 : 0);
  const int shaders = old.channel_count - base_channels;
  RarePoll<16384> poll(context);
  for (std::size_t slot = 0; slot < old.triangle_node.size(); ++slot) {
    if (poll.cancelled()) return context.cancel_status();
    const std::uint32_t node = layout_.triangle_node[slot], from = old.triangle_node[slot];
    if (!asks[node] || old.is_fixed[from] || !(layout_.position[node] == old.position[from])) {
      continue;
    }
    const float* const value =
        old.value.data() + static_cast<std::size_t>(old.channel_count) * from;
    float* const out =
        layout_.value.data() + static_cast<std::size_t>(layout_.channel_count) * node;
    std::copy_n(value + first_channel, own_base, out);
    std::copy_n(value + base_channels, shaders, out + field_.attributes.base_channels);
    node_hit_[node] = known.node_hit[from];
    asks[node] = 0;
    carried.push_back(node);
  }
  return ok_status();
}

}  // namespace sfumato::solve
