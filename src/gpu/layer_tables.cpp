#include "gpu/layer_tables.hpp"

#include <algorithm>
#include <bit>
#include <utility>

#include "base/table_memory.hpp"
#include "base/try.hpp"
#include "raster/coverage/bends.hpp"

namespace sfumato::gpu {
namespace {

constexpr std::string_view kPurpose = "a layer on the GPU";

class Uploader {
 public:
  Uploader(Context& context, const Device& device) : context_(context), device_(device) {}

  Status make(const TableFormat& format, std::size_t texels, Table* table) {
    SFUMATO_TRY_ASSIGN(*table, Table::create(context_, device_, format, texels, kPurpose));
    return ok_status();
  }

  template <class Index>
  Status indices(const TableFormat& format, const std::vector<Index>& source, Table* table) {
    SFUMATO_TRY(make(format, source.size(), table));
    table->upload(0, source.size(), source.data());
    return ok_status();
  }

  Status positions(const std::vector<Vec2>& source, Vec2 origin, Table* table) {
    SFUMATO_TRY(make(kPairTable, source.size(), table));
    table->fill<float>([&](std::size_t first, std::size_t count, float* out) {
      for (std::size_t i = 0; i < count; ++i) {
        const Vec2 p = source[first + i] - origin;
        out[2 * i] = static_cast<float>(p.x);
        out[2 * i + 1] = static_cast<float>(p.y);
      }
    });
    return ok_status();
  }

  /// Uploads the slots where `is_curve` is not 0.
  Status slots(const std::vector<std::uint8_t>& is_curve, Table* table, std::uint32_t* count) {
    const auto marked = std::count_if(is_curve.begin(), is_curve.end(),
                                      [](std::uint8_t flag) { return flag != 0; });
    *count = static_cast<std::uint32_t>(marked);
    TableMemory memory(kPurpose);
    std::vector<std::uint32_t> slot;
    SFUMATO_TRY(memory.reserve(context_, slot, *count));
    for (std::size_t i = 0; i < is_curve.size(); ++i)
      if (is_curve[i] != 0) slot.push_back(static_cast<std::uint32_t>(i));
    return indices(kIndexTable, slot, table);
  }

  Status soft_edges(const std::vector<SoftEdge>& edges, LayerTables* tables) {
    if (edges.empty()) return ok_status();
    tables->soft_edge_count = static_cast<std::uint32_t>(edges.size());
    SFUMATO_TRY(make(kIndexTable, 3 * edges.size(), &tables->soft_edge.emplace()));
    SFUMATO_TRY(make(kColorTable, edges.size(), &tables->soft_reach.emplace()));
    tables->soft_edge->fill<std::uint32_t>(
        [&](std::size_t first, std::size_t count, std::uint32_t* out) {
          for (std::size_t i = first; i < first + count; ++i) {
            const SoftEdge& edge = edges[i / 3];
            const std::uint32_t number[3] = {edge.front, edge.back,
                                             std::bit_cast<std::uint32_t>(edge.contrast)};
            *out++ = number[i % 3];
          }
        });
    tables->soft_reach->fill<float>([&](std::size_t first, std::size_t count, float* out) {
      for (std::size_t i = first; i < first + count; ++i)
        for (const Vec2& reach : edges[i].reach)
          for (double x : {reach.x, reach.y}) *out++ = static_cast<float>(x);
    });
    return ok_status();
  }

  /// `own`: the number of channels that are not weights, 3 or 1.
  Status field(const PatchField& field, std::size_t own, FieldTables* tables) {
    const auto channels = static_cast<std::size_t>(field.channel_count);
    Status status = indices(kIndexTable, field.triangle_node, &tables->node);
    if (status) status = values(field, own, &tables->value);
    if (!status || channels == own) return status;
    tables->weight.emplace();
    return weights(field, own, &*tables->weight);
  }

 private:
  Status values(const PatchField& field, std::size_t own, Table* table) {
    const auto channels = static_cast<std::size_t>(field.channel_count);
    const TableFormat& format = own == 3 ? kColorTable : kScalarTable;
    SFUMATO_TRY(make(format, field.node_value.size() / channels, table));
    table->fill<float>([&](std::size_t first, std::size_t count, float* out) {
      for (std::size_t i = 0; i < count; ++i)
        for (std::size_t c = 0; c < own; ++c)
          out[format.channels * i + c] = field.node_value[channels * (first + i) + c];
    });
    return ok_status();
  }

  Status weights(const PatchField& field, std::size_t own, Table* table) {
    const auto channels = static_cast<std::size_t>(field.channel_count);
    const std::size_t groups = (channels - own + 3) / 4;
    SFUMATO_TRY(make(kColorTable, groups * (field.node_value.size() / channels), table));
    table->fill<float>([&](std::size_t first, std::size_t count, float* out) {
      for (std::size_t i = 0; i < 4 * count; ++i) {
        const std::size_t node = (first + i / 4) / groups, group = (first + i / 4) % groups;
        const std::size_t channel = own + 4 * group + i % 4;
        out[i] = channel < channels ? field.node_value[channels * node + channel] : 0;
      }
    });
    return ok_status();
  }

  Context& context_;
  const Device& device_;
};

}  // namespace

Result<LayerTables> upload_layer(Context& context, const Device& device, const PatchLayer& layer,
                                 Vec2 origin, bool with_overlay) {
  LayerTables tables;
  tables.origin = origin;
  Uploader uploader(context, device);
  SFUMATO_TRY(uploader.indices(kIndexTable, layer.triangle_vertex, &tables.triangle_vertex));
  SFUMATO_TRY(uploader.positions(layer.vertex_position, origin, &tables.vertex_position));
  SFUMATO_TRY(uploader.field(layer.color, 3, &tables.color));
  if (layer.opacity.channel_count > 0)
    SFUMATO_TRY(uploader.field(layer.opacity, 1, &tables.opacity.emplace()));
  SFUMATO_TRY(uploader.slots(layer.edge_is_curve, &tables.edge_slot, &tables.curve_edge_count));
  {
    TableMemory memory(kPurpose);
    SFUMATO_TRY_ASSIGN(const std::vector<std::uint8_t>& bent,
                       raster::bent_triangles(context, layer, memory));
    SFUMATO_TRY(uploader.indices(kFlagTable, bent, &tables.is_bent));
  }
  SFUMATO_TRY(uploader.soft_edges(layer.soft_edge, &tables));
  if (with_overlay)
    SFUMATO_TRY(uploader.indices(kFlagTable, layer.edge_is_curve, &tables.edge_is_curve.emplace()));
  return tables;
}

}  // namespace sfumato::gpu
