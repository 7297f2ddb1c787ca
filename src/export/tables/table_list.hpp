#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <type_traits>
#include <vector>

#include "base/table_memory.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/export/export_notes.hpp"
#include "sfumato/picture/picture.hpp"

namespace sfumato::outputs {

enum class NumberType : std::uint8_t { u8, u32, f32, f64 };

/// Bytes of a number.
constexpr std::size_t size_of(NumberType type) {
  constexpr std::size_t kSizes[] = {1, 4, 4, 8};
  return kSizes[static_cast<std::size_t>(type)];
}

/// A named table: rows of numbers as they lie in memory.
struct Table {
  std::string_view name;
  NumberType type = NumberType::f64;
  std::size_t columns = 1;
  std::span<const std::uint8_t> bytes;

  std::size_t rows() const { return bytes.size() / (columns * size_of(type)); }
};

/// Returns a vector's numbers as a table; `columns` numbers to a row. Vec2 counts as two doubles.
template <class Item>
Table table_of(std::string_view name, std::size_t columns, const std::vector<Item>& items) {
  constexpr NumberType kType = std::is_same_v<Item, std::uint8_t>    ? NumberType::u8
                               : std::is_same_v<Item, std::uint32_t> ? NumberType::u32
                               : std::is_same_v<Item, float>         ? NumberType::f32
                                                                     : NumberType::f64;
  static_assert(sizeof(Item) % size_of(kType) == 0);
  return {name,
          kType,
          columns,
          {reinterpret_cast<const std::uint8_t*>(items.data()), items.size() * sizeof(Item)}};
}

/// The tables of one layer: views of the layer's data and of data made here. They are valid while
/// both exist.
struct LayerTables {
  std::vector<Vec2> color_position;    ///< of each colour node, layer frame
  std::vector<Vec2> opacity_position;  ///< of each opacity node
  std::vector<std::uint32_t> soft_edge_side;
  std::vector<Vec2> soft_edge_reach;
  std::vector<float> soft_edge_contrast;
  std::vector<Table> tables;
  TableMemory memory{"tables of nodes"};
};

/// Where the nodes of a field of the layer lie, layer frame; NaN for one that no triangle has.
/// `position` is of `memory`. Errors: limit (memory), cancelled.
Status find_node_positions(const Context& context, const PatchLayer& layer, const PatchField& field,
                           TableMemory& memory, std::vector<Vec2>& position);

/// Errors: limit (memory), cancelled.
Result<LayerTables> list_tables(const Context& context, const PatchLayer& layer);

/// The tables of the stack: one row for each instance.
struct InstanceTables {
  std::vector<double> row;              ///< layer, a, b, c, d, e, f, opacity
  std::vector<std::string_view> blend;  ///< CSS's name
  TableMemory memory{"tables of instances"};
};

/// Numbers in a row of InstanceTables.
inline constexpr std::size_t kInstanceColumns = 8;

/// Errors: limit (memory), cancelled.
Result<InstanceTables> list_instances(const Context& context, const Picture& picture);

/// Adds to the notes, unless null, the parts of the picture that tables of meshes leave out.
void note_omissions(const Picture& picture, ExportNotes* notes);

}  // namespace sfumato::outputs
