#include "solve/fields/frame_rows.hpp"

#include <algorithm>
#include <cstddef>
#include <functional>

#include "base/try.hpp"

namespace sfumato::solve {
namespace {

/// Tables get additional room, 1 / kShareOfRoom of their rows, so that they rarely grow.
constexpr std::size_t kShareOfRoom = 16;

/// Sorting a row takes this many times as long as marking it and finding it again.
constexpr std::size_t kMarksPerSort = 16;

/// Returns whether one field of the frame holds colour and opacity.
bool is_joint(const FrameSource& frame, const PatchLayer& layer) {
  return !frame.opacity && layer.opacity.channel_count > 0;
}

template <class Table>
void copy_row(const Table& from, std::size_t row, std::size_t width, Table& to) {
  std::copy_n(from.data() + width * row, width, to.data() + width * row);
}

void write_triangles(const FrameSource& frame, const std::vector<std::uint32_t>& rows,
                     PatchLayer& layer) {
  const NodeLayout& color = frame.color;
  const NodeLayout* const opacity = frame.opacity;
  for (const std::uint32_t t : rows) {
    if (t >= frame.mesh.triangle_count()) return;
    copy_row(frame.mesh.triangle_vertex, t, 3, layer.triangle_vertex);
    copy_row(color.edge_is_curve, t, 3, layer.edge_is_curve);
    copy_row(color.triangle_node, t, kNodesPerTriangle, layer.color.triangle_node);
    if (layer.opacity.channel_count == 0) continue;
    copy_row((opacity ? *opacity : color).triangle_node, t, kNodesPerTriangle,
             layer.opacity.triangle_node);
    for (std::size_t h = 3 * t; opacity && h < 3 * t + 3; ++h)
      layer.edge_is_curve[h] |= opacity->edge_is_curve[h];
  }
}

void write_values(const NodeLayout& from, const std::vector<std::uint32_t>& rows,
                  PatchField& field) {
  const auto channels = static_cast<std::size_t>(from.channel_count);
  for (const std::uint32_t node : rows) {
    if (node >= from.node_count()) return;
    copy_row(from.value, node, channels, field.node_value);
  }
}

/// Writes the values of a joint field as colour and opacity, like split_channel().
void write_joint_values(const NodeLayout& from, const std::vector<std::uint32_t>& rows,
                        PatchLayer& layer) {
  const auto channels = static_cast<std::size_t>(from.channel_count);
  for (const std::uint32_t node : rows) {
    if (node >= from.node_count()) return;
    const float* const value = from.value.data() + channels * node;
    float* color = layer.color.node_value.data() + (channels - 1) * node;
    for (std::size_t c = 0; c < channels; ++c)
      if (c != kOpacityChannel) *color++ = value[c];
    layer.opacity.node_value[node] = value[kOpacityChannel];
  }
}

/// Calls body(table, size) for each table of `layer` and its size in the frame.
template <class Body>
void for_each_table(const FrameSource& frame, PatchLayer& layer, Body body) {
  const auto field = [&](PatchField& to, const NodeLayout& from) {
    body(to.triangle_node, from.triangle_node.size());
    body(to.node_value, static_cast<std::size_t>(to.channel_count) * from.node_count());
  };
  body(layer.vertex_position, frame.mesh.vertex_position.size());
  body(layer.triangle_vertex, frame.mesh.triangle_vertex.size());
  body(layer.edge_is_curve, frame.color.edge_is_curve.size());
  field(layer.color, frame.color);
  if (layer.opacity.channel_count > 0) {
    field(layer.opacity, frame.opacity ? *frame.opacity : frame.color);
  }
}

}  // namespace

Status sort_rows(const Context& context, std::size_t count, std::vector<std::uint32_t>& rows) {
  if (rows.size() < count / kMarksPerSort) {
    Status status = TableMemory::sort(context, rows, std::less<>());
    rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
    return status;
  }
  TableMemory scratch("patches");
  std::vector<std::uint8_t> is_listed;
  SFUMATO_TRY(scratch.resize(context, is_listed, count));
  for (const std::uint32_t row : rows) is_listed[row] = 1;
  rows.clear();  // keeps its capacity, which is enough
  for (std::size_t row = 0; row < count; ++row)
    if (is_listed[row]) rows.push_back(static_cast<std::uint32_t>(row));
  return ok_status();
}

Status make_room(const Context& context, const FrameSource& frame, PatchLayer& layer) {
  TableMemory memory("patches");
  Status status;
  for_each_table(frame, layer, [&](auto& table, std::size_t size) {
    if (status && size > table.capacity()) {
      status = memory.reserve(context, table, size + size / kShareOfRoom);
    }
  });
  return status;
}

Status make_room(const Context& context, PatchLayer& layer) {
  TableMemory memory("patches");
  Status status;
  const auto reserve = [&](auto& table) {
    if (status) status = memory.reserve(context, table, table.size() + table.size() / kShareOfRoom);
  };
  reserve(layer.vertex_position);
  reserve(layer.triangle_vertex);
  reserve(layer.edge_is_curve);
  for (PatchField* field : {&layer.color, &layer.opacity}) {
    reserve(field->triangle_node);
    reserve(field->node_value);
  }
  return status;
}

void write_rows(const FrameSource& frame, const FrameRows& then, const FrameRows& now,
                PatchLayer& layer) {
  for_each_table(frame, layer, [](auto& table, std::size_t size) { table.resize(size); });
  const std::vector<Vec2>& position = frame.mesh.vertex_position;
  const auto first = static_cast<std::ptrdiff_t>(
      std::min({std::size_t{then.first_vertex}, std::size_t{now.first_vertex}, position.size()}));
  std::copy(position.begin() + first, position.end(), layer.vertex_position.begin() + first);
  for (const FrameRows* rows : {&then, &now}) {
    write_triangles(frame, rows->triangles, layer);
    if (is_joint(frame, layer)) {
      write_joint_values(frame.color, rows->nodes, layer);
    } else {
      write_values(frame.color, rows->nodes, layer.color);
      if (frame.opacity) write_values(*frame.opacity, rows->opacity_nodes, layer.opacity);
    }
  }
}

}  // namespace sfumato::solve
