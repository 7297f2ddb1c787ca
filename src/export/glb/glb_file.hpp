#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <map>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "base/charge.hpp"
#include "base/table_memory.hpp"
#include "base/text/json.hpp"
#include "sfumato/base/affine.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::outputs {

/// Triangles as in glTF: y up, counter-clockwise from the front.
struct GlbMesh {
  std::vector<float> position;       ///< x, y, z per vertex
  std::vector<std::uint16_t> color;  ///< linear r, g, b and alpha per vertex; or empty
  std::vector<float> texture;        ///< u, v per vertex; or empty
  std::vector<std::uint32_t> index;  ///< 3 per triangle
  TableMemory memory{"a GLB mesh"};
};

/// Puts a scene together and writes it as one file: https://registry.khronos.org/glTF/specs/2.0.
/// All numbers that it returns count from 0.
class GlbFile {
 public:
  explicit GlbFile(Context& context) : context_(context) {}

  /// Adds the data of a mesh, which several meshes may share. Errors: limit (memory, 4 GiB).
  Result<std::uint32_t> add_geometry(const GlbMesh& mesh);
  /// Adds a PNG. Errors: limit.
  Result<std::uint32_t> add_image(std::span<const std::uint8_t> png);

  /// A material for a geometry: its alpha, whether it is blended, and an image or -1.
  struct Material {
    double opacity = 1;
    bool is_blended = false;
    std::int64_t image = -1;
    friend auto operator<=>(const Material&, const Material&) = default;
  };
  /// Adds a mesh, a geometry with a material. Equal meshes are stored once. Errors: limit.
  Result<std::uint32_t> add_mesh(std::uint32_t geometry, const Material& material);

  /// Adds a mesh at a place in the root's frame: (x, y) → place(x, y), with z. Errors: limit.
  Status add_node(std::uint32_t mesh, const Affine& place, double z);

  /// Returns the file; its root turns units into metres. Nothing more may be added. Errors: limit.
  Result<std::vector<std::uint8_t>> finish(double metres_per_unit);

 private:
  struct View {
    std::size_t offset, bytes;
    int target;  ///< the WebGL target; 0: none
  };
  struct Geometry {
    std::uint32_t first_view = 0, first_accessor = 0;
    std::uint32_t vertices = 0, indices = 0;
    std::array<float, 6> bounds{};
    bool has_color = false, has_texture = false;
  };
  struct Mesh {
    std::uint32_t geometry, material;
  };
  struct Node {
    std::int64_t mesh = -1;  ///< -1: no mesh; the next node is the child
    std::array<double, 16> matrix;
  };

  template <class Map, class Item>
  Result<std::uint32_t> number_of(const typename Map::key_type& key, const Item& item, Map& known,
                                  std::vector<Item>& items);
  Status add_view(const void* data, std::size_t bytes, int target);
  Status write_scene(JsonWriter& json, double metres_per_unit);
  Status write_materials(JsonWriter& json);
  Status write_meshes(JsonWriter& json);
  Status write_buffers(JsonWriter& json);
  Status write_accessors(JsonWriter& json);
  Status write_images(JsonWriter& json);
  Status settle(const JsonWriter& json);
  template <class Item, class Write>
  Status write_each(JsonWriter& json, std::string_view key, const std::vector<Item>& items,
                    const Write& write);
  Result<std::vector<std::uint8_t>> join(std::string_view json);

  Context& context_;
  TableMemory memory_{"the GLB"};
  ScopedCharge map_charge_;                       ///< for the nodes of maps
  std::size_t json_bytes_ = 0;                    ///< part of the charge that is for the JSON
  std::vector<std::vector<std::uint8_t>> parts_;  ///< of the binary chunk, one for each view
  std::size_t part_bytes_ = 0;
  std::vector<View> views_;
  std::vector<Geometry> geometries_;
  std::vector<std::uint32_t> image_view_;
  std::uint32_t accessor_count_ = 0;
  std::vector<Material> materials_;
  std::map<Material, std::uint32_t> known_materials_;
  std::vector<Mesh> meshes_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> known_meshes_;
  std::vector<Node> nodes_;
  std::vector<std::uint32_t> top_nodes_;
};

}  // namespace sfumato::outputs
