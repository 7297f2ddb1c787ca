#include "export/glb/glb_file.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "base/output_buffer.hpp"
#include "base/try.hpp"

namespace sfumato::outputs {
namespace {

static_assert(std::endian::native == std::endian::little, "glTF's buffers are little-endian");

// Numbers of WebGL.
constexpr int kArrayBuffer = 34962, kElementArrayBuffer = 34963;
constexpr int kUnsignedShort = 5123, kUnsignedInt = 5125, kFloat = 5126;
constexpr int kLinear = 9729, kLinearMipmapLinear = 9987, kClampToEdge = 33071;

constexpr std::uint32_t kGlbMagic = 0x46546C67, kJsonChunk = 0x4E4F534A, kBinaryChunk = 0x004E4942;
constexpr std::size_t kMostBytes = std::numeric_limits<std::uint32_t>::max();
/// The memory of a std::map node besides its value: three pointers and a colour.
constexpr std::size_t kMapNodeBytes = 4 * sizeof(void*);

using Matrix = std::array<double, 16>;

/// Column by column.
Matrix matrix_of(const Affine& place, double z) {
  return {place.a, place.b, 0, 0, place.c, place.d, 0, 0, 0, 0, 1, 0, place.e, place.f, z, 1};
}

bool is_scaled_rotation(const Affine& m) {
  const double across = m.a * m.c + m.b * m.d;
  return std::fabs(across) <= 1e-9 * std::hypot(m.a, m.b) * std::hypot(m.c, m.d);
}

/// Returns the rotation that turns the columns of a matrix into two that are at right angles
/// (Jacobi).
Affine aligning_rotation(const Affine& m) {
  const double p = m.a * m.a + m.b * m.b, q = m.c * m.c + m.d * m.d;
  const double angle = 0.5 * std::atan2(2 * (m.a * m.c + m.b * m.d), p - q);
  return {std::cos(angle), std::sin(angle), -std::sin(angle), std::cos(angle), 0, 0};
}

void append_word(OutputBuffer& bytes, std::size_t value) {
  for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(value >> shift & 255);
}

std::size_t padded(std::size_t bytes) {
  return (bytes + 3) / 4 * 4;
}

}  // namespace

Status GlbFile::add_view(const void* data, std::size_t bytes, int target) {
  const std::size_t size = padded(bytes);
  if (part_bytes_ + size > kMostBytes / 2) {
    return make_error(StatusCode::limit, "a GLB of more than 2 GiB: allow a larger error");
  }
  SFUMATO_TRY(memory_.push_back(context_, views_, {part_bytes_, bytes, target}));
  std::vector<std::uint8_t> part;
  SFUMATO_TRY(memory_.reserve(context_, part, size));
  {
    const std::span whole(static_cast<const std::uint8_t*>(data), bytes);
    SFUMATO_TRY(memory_.append(context_, whole, part));
  }
  part.resize(size);
  part_bytes_ += size;
  return memory_.push_back(context_, parts_, std::move(part));
}

Result<std::uint32_t> GlbFile::add_geometry(const GlbMesh& mesh) {
  Geometry geometry;
  geometry.first_view = static_cast<std::uint32_t>(views_.size());
  geometry.first_accessor = accessor_count_;
  geometry.vertices = static_cast<std::uint32_t>(mesh.position.size() / 3);
  geometry.indices = static_cast<std::uint32_t>(mesh.index.size());
  geometry.has_color = !mesh.color.empty();
  geometry.has_texture = !mesh.texture.empty();
  for (std::size_t k = 0; k < 3; ++k) {
    float low = mesh.position[k], high = low;
    for (std::size_t i = k; i < mesh.position.size(); i += 3) {
      low = std::min(low, mesh.position[i]);
      high = std::max(high, mesh.position[i]);
    }
    geometry.bounds[k] = low;
    geometry.bounds[3 + k] = high;
  }
  SFUMATO_TRY(add_view(mesh.index.data(), 4 * mesh.index.size(), kElementArrayBuffer));
  SFUMATO_TRY(add_view(mesh.position.data(), 4 * mesh.position.size(), kArrayBuffer));
  if (geometry.has_color) {
    SFUMATO_TRY(add_view(mesh.color.data(), 2 * mesh.color.size(), kArrayBuffer));
  }
  if (geometry.has_texture) {
    SFUMATO_TRY(add_view(mesh.texture.data(), 4 * mesh.texture.size(), kArrayBuffer));
  }
  accessor_count_ += 2u + geometry.has_color + geometry.has_texture;
  SFUMATO_TRY(memory_.push_back(context_, geometries_, geometry));
  return static_cast<std::uint32_t>(geometries_.size() - 1);
}

Result<std::uint32_t> GlbFile::add_image(std::span<const std::uint8_t> png) {
  SFUMATO_TRY(add_view(png.data(), png.size(), 0));
  const auto view = static_cast<std::uint32_t>(views_.size() - 1);
  SFUMATO_TRY(memory_.push_back(context_, image_view_, view));
  return static_cast<std::uint32_t>(image_view_.size() - 1);
}

template <class Map, class Item>
Result<std::uint32_t> GlbFile::number_of(const typename Map::key_type& key, const Item& item,
                                         Map& known, std::vector<Item>& items) {
  if (const auto found = known.find(key); found != known.end()) return found->second;
  constexpr std::size_t kNodeBytes = sizeof(typename Map::value_type) + kMapNodeBytes;
  SFUMATO_TRY(map_charge_.add(context_, kNodeBytes, "the GLB"));
  SFUMATO_TRY(memory_.push_back(context_, items, item));
  const auto number = static_cast<std::uint32_t>(items.size() - 1);
  known.emplace(key, number);
  return number;
}

Result<std::uint32_t> GlbFile::add_mesh(std::uint32_t geometry, const Material& material) {
  SFUMATO_TRY_ASSIGN(const std::uint32_t of_material,
                     number_of(material, material, known_materials_, materials_));
  return number_of({geometry, of_material}, Mesh{geometry, of_material}, known_meshes_, meshes_);
}

Status GlbFile::add_node(std::uint32_t mesh, const Affine& place, double z) {
  SFUMATO_TRY(memory_.push_back(context_, top_nodes_, static_cast<std::uint32_t>(nodes_.size())));
  SFUMATO_TRY(memory_.make_room(context_, nodes_, 2));
  if (is_scaled_rotation(place)) {
    nodes_.push_back({mesh, matrix_of(place, z)});
    return ok_status();
  }
  // A node's matrix must not shear: a rotation within a stretched node does.
  const Affine rotation = aligning_rotation(place);
  nodes_.push_back({-1, matrix_of(place * rotation, z)});
  nodes_.push_back({mesh, matrix_of(inverse(rotation), 0)});
  return ok_status();
}

/// Charges the growth of the text.
Status GlbFile::settle(const JsonWriter& json) {
  return memory_.settle(context_, capacity_bytes(json.text()), json_bytes_);
}

/// Writes a member: an array with an element for each item.
template <class Item, class Write>
Status GlbFile::write_each(JsonWriter& json, std::string_view key, const std::vector<Item>& items,
                           const Write& write) {
  json.key(key).begin_array();
  for (const Item& item : items) {
    write(item);
    SFUMATO_TRY(settle(json));
  }
  json.end_array();
  return settle(json);
}

/// Root: node 0; node i of ours is i + 1.
Status GlbFile::write_scene(JsonWriter& json, double metres_per_unit) {
  json.member("scene", 0).key("scenes").begin_array().begin_object();
  json.key("nodes").begin_array().value(0).end_array().end_object().end_array();
  json.key("nodes").begin_array().begin_object().member("name", "picture");
  if (!top_nodes_.empty()) {
    json.key("children").begin_array();
    for (const std::uint32_t node : top_nodes_) {
      json.value(node + 1);
      SFUMATO_TRY(settle(json));
    }
    json.end_array();
  }
  json.array("scale", std::array{metres_per_unit, metres_per_unit, metres_per_unit}).end_object();
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    json.begin_object();
    if (nodes_[i].mesh >= 0) {
      json.member("mesh", nodes_[i].mesh);
    } else {
      json.key("children").begin_array().value(i + 2).end_array();
    }
    if (nodes_[i].matrix != matrix_of({}, 0)) json.array("matrix", nodes_[i].matrix);
    json.end_object();
    SFUMATO_TRY(settle(json));
  }
  json.end_array();
  return settle(json);
}

Status GlbFile::write_materials(JsonWriter& json) {
  return write_each(json, "materials", materials_, [&](const Material& material) {
    json.begin_object().key("pbrMetallicRoughness").begin_object();
    if (material.opacity != 1)
      json.array("baseColorFactor", std::array<double, 4>{1, 1, 1, material.opacity});
    if (material.image >= 0) {
      json.key("baseColorTexture").begin_object().member("index", material.image).end_object();
    }
    json.member("metallicFactor", 0).member("roughnessFactor", 1).end_object();
    if (material.is_blended) json.member("alphaMode", "BLEND");
    json.key("doubleSided").truth(true);
    json.key("extensions").begin_object().key("KHR_materials_unlit").begin_object().end_object();
    json.end_object().end_object();
  });
}

Status GlbFile::write_meshes(JsonWriter& json) {
  return write_each(json, "meshes", meshes_, [&](const Mesh& mesh) {
    const Geometry& geometry = geometries_[mesh.geometry];
    const std::uint32_t first = geometry.first_accessor;
    json.begin_object().key("primitives").begin_array().begin_object();
    json.key("attributes").begin_object().member("POSITION", first + 1);
    if (geometry.has_color) json.member("COLOR_0", first + 2);
    if (geometry.has_texture) json.member("TEXCOORD_0", first + (geometry.has_color ? 3 : 2));
    json.end_object().member("indices", first).member("material", mesh.material);
    json.end_object().end_array().end_object();
  });
}

Status GlbFile::write_accessors(JsonWriter& json) {
  return write_each(json, "accessors", geometries_, [&](const Geometry& geometry) {
    std::uint32_t view = geometry.first_view;
    const auto begin = [&](int component, const char* type, std::uint32_t count) {
      json.begin_object().member("bufferView", view++).member("componentType", component);
      json.member("count", count).member("type", type);
    };
    begin(kUnsignedInt, "SCALAR", geometry.indices);
    json.end_object();
    begin(kFloat, "VEC3", geometry.vertices);
    const std::span bounds(geometry.bounds);
    json.array("min", bounds.first<3>()).array("max", bounds.last<3>()).end_object();
    if (geometry.has_color) {
      begin(kUnsignedShort, "VEC4", geometry.vertices);
      json.key("normalized").truth(true).end_object();
    }
    if (geometry.has_texture) {
      begin(kFloat, "VEC2", geometry.vertices);
      json.end_object();
    }
  });
}

Status GlbFile::write_buffers(JsonWriter& json) {
  json.key("buffers").begin_array().begin_object();
  json.member("byteLength", part_bytes_).end_object().end_array();
  return write_each(json, "bufferViews", views_, [&](const View& view) {
    json.begin_object().member("buffer", 0).member("byteOffset", view.offset);
    json.member("byteLength", view.bytes);
    if (view.target != 0) json.member("target", view.target);
    json.end_object();
  });
}

Status GlbFile::write_images(JsonWriter& json) {
  json.key("samplers").begin_array().begin_object();
  json.member("magFilter", kLinear).member("minFilter", kLinearMipmapLinear);
  json.member("wrapS", kClampToEdge).member("wrapT", kClampToEdge).end_object().end_array();
  SFUMATO_TRY(write_each(json, "images", image_view_, [&](std::uint32_t view) {
    json.begin_object().member("bufferView", view).member("mimeType", "image/png").end_object();
  }));
  std::size_t image = 0;
  return write_each(json, "textures", image_view_, [&](std::uint32_t) {
    json.begin_object().member("sampler", 0).member("source", image++).end_object();
  });
}

Result<std::vector<std::uint8_t>> GlbFile::finish(double metres_per_unit) {
  JsonWriter json;
  json.begin_object().key("asset").begin_object();
  json.member("version", "2.0").member("generator", "Sfumato").end_object();
  SFUMATO_TRY(write_scene(json, metres_per_unit));
  if (!meshes_.empty()) {
    json.key("extensionsUsed").begin_array().value("KHR_materials_unlit").end_array();
    SFUMATO_TRY(write_meshes(json));
    SFUMATO_TRY(write_materials(json));
    SFUMATO_TRY(write_accessors(json));
    SFUMATO_TRY(write_buffers(json));
  }
  if (!image_view_.empty()) SFUMATO_TRY(write_images(json));
  return join(json.end_object().text());
}

/// Returns the file: a header, the JSON, the binary chunk.
Result<std::vector<std::uint8_t>> GlbFile::join(std::string_view json) {
  const std::size_t text_bytes = padded(json.size());
  const std::size_t binary_bytes = part_bytes_ == 0 ? 0 : 8 + part_bytes_;
  OutputBuffer file(context_, "the GLB");
  file.reserve(20 + text_bytes + binary_bytes);
  for (const std::size_t word :
       {std::size_t{kGlbMagic}, std::size_t{2}, 20 + text_bytes + binary_bytes, text_bytes,
        std::size_t{kJsonChunk}}) {
    append_word(file, word);
  }
  (file += json) += std::string(text_bytes - json.size(), ' ');
  if (binary_bytes == 0) return file.finish();
  append_word(file, part_bytes_);
  append_word(file, kBinaryChunk);
  for (std::vector<std::uint8_t>& part : parts_) {
    file.append(part);
    memory_.free(part);
  }
  return file.finish();
}

}  // namespace sfumato::outputs
