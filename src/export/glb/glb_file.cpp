#include "export/glb/glb_file.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

#include "base/large_vector.hpp"

namespace sfumato::outputs {
namespace {

static_assert(std::endian::native == std::endian::little, "glTF's buffers are little-endian");

// Numbers of WebGL.
constexpr int kArrayBuffer = 34962, kElementArrayBuffer = 34963;
constexpr int kUnsignedShort = 5123, kUnsignedInt = 5125, kFloat = 5126;
constexpr int kLinear = 9729, kLinearMipmapLinear = 9987, kClampToEdge = 33071;

constexpr std::uint32_t kMagic = 0x46546C67, kJsonChunk = 0x4E4F534A, kBinaryChunk = 0x004E4942;
constexpr std::size_t kMostBytes = std::numeric_limits<std::uint32_t>::max();
/// JSON of a node, a mesh, a material, a view with its accessor.
constexpr std::size_t kElementBytes = 512;

using Matrix = std::array<double, 16>;

/// Column by column.
Matrix matrix_of(const Affine& place, double z) {
  return {place.a, place.b, 0, 0, place.c, place.d, 0, 0, 0, 0, 1, 0, place.e, place.f, z, 1};
}

bool is_scaled_rotation(const Affine& m) {
  const double across = m.a * m.c + m.b * m.d;
  return std::fabs(across) <= 1e-9 * std::hypot(m.a, m.b) * std::hypot(m.c, m.d);
}

/// The rotation that turns the columns of a matrix into two that are at right angles (Jacobi).
Affine aligning_rotation(const Affine& m) {
  const double p = m.a * m.a + m.b * m.b, q = m.c * m.c + m.d * m.d;
  const double angle = 0.5 * std::atan2(2 * (m.a * m.c + m.b * m.d), p - q);
  return {std::cos(angle), std::sin(angle), -std::sin(angle), std::cos(angle), 0, 0};
}

void write_matrix(JsonWriter& json, const Matrix& matrix) {
  json.key("matrix").begin_array();
  for (const double entry : matrix) json.value(entry);
  json.end_array();
}

void append_word(std::vector<std::uint8_t>& bytes, std::size_t value) {
  for (int shift = 0; shift < 32; shift += 8) {
    bytes.push_back(static_cast<std::uint8_t>(value >> shift & 255));
  }
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
  // Once here, once in the file.
  if (Status status = charge_.add(context_, 2 * size + kElementBytes, "the GLB"); !status) {
    return status;
  }
  views_.push_back({part_bytes_, bytes, target});
  part_bytes_ += size;
  std::vector<std::uint8_t>& part = parts_.emplace_back();
  part.reserve(size);
  Status status =
      append_large(context_, std::span(static_cast<const std::uint8_t*>(data), bytes), part);
  if (status) part.resize(size);
  return status;
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
  Status status = add_view(mesh.index.data(), 4 * mesh.index.size(), kElementArrayBuffer);
  if (status) status = add_view(mesh.position.data(), 4 * mesh.position.size(), kArrayBuffer);
  if (status && geometry.has_color) {
    status = add_view(mesh.color.data(), 2 * mesh.color.size(), kArrayBuffer);
  }
  if (status && geometry.has_texture) {
    status = add_view(mesh.texture.data(), 4 * mesh.texture.size(), kArrayBuffer);
  }
  if (!status) return status;
  accessor_count_ += 2u + geometry.has_color + geometry.has_texture;
  geometries_.push_back(geometry);
  return static_cast<std::uint32_t>(geometries_.size() - 1);
}

Result<std::uint32_t> GlbFile::add_image(std::span<const std::uint8_t> png) {
  if (Status status = add_view(png.data(), png.size(), 0); !status) return status;
  image_view_.push_back(static_cast<std::uint32_t>(views_.size() - 1));
  return static_cast<std::uint32_t>(image_view_.size() - 1);
}

std::uint32_t GlbFile::add_mesh(std::uint32_t geometry, const Material& material) {
  const auto [of_material, is_new] =
      known_materials_.try_emplace(material, static_cast<std::uint32_t>(materials_.size()));
  if (is_new) materials_.push_back(material);
  const auto [of_mesh, is_new_mesh] = known_meshes_.try_emplace(
      {geometry, of_material->second}, static_cast<std::uint32_t>(meshes_.size()));
  if (is_new_mesh) meshes_.push_back({geometry, of_material->second});
  return of_mesh->second;
}

Status GlbFile::add_node(std::uint32_t mesh, const Affine& place, double z) {
  // With a mesh and a material of its own, at most.
  Status status = charge_.add(context_, 4 * kElementBytes, "the GLB");
  if (!status) return status;
  top_nodes_.push_back(static_cast<std::uint32_t>(nodes_.size()));
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

/// Root: node 0; node i of ours is i + 1.
void GlbFile::write_scene(JsonWriter& json, double metres_per_unit) const {
  json.member("scene", 0).key("scenes").begin_array().begin_object();
  json.key("nodes").begin_array().value(0).end_array().end_object().end_array();
  json.key("nodes").begin_array().begin_object().member("name", "picture");
  if (!top_nodes_.empty()) {
    json.key("children").begin_array();
    for (const std::uint32_t node : top_nodes_) json.value(node + 1);
    json.end_array();
  }
  json.key("scale").begin_array();
  for (int k = 0; k < 3; ++k) json.value(metres_per_unit);
  json.end_array().end_object();
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    json.begin_object();
    if (nodes_[i].mesh >= 0) {
      json.member("mesh", nodes_[i].mesh);
    } else {
      json.key("children").begin_array().value(i + 2).end_array();
    }
    if (nodes_[i].matrix != matrix_of({}, 0)) write_matrix(json, nodes_[i].matrix);
    json.end_object();
  }
  json.end_array();
}

void GlbFile::write_materials(JsonWriter& json) const {
  json.key("materials").begin_array();
  for (const Material& material : materials_) {
    json.begin_object().key("pbrMetallicRoughness").begin_object();
    if (material.opacity != 1) {
      json.key("baseColorFactor").begin_array();
      for (const double factor : {1.0, 1.0, 1.0, material.opacity}) json.value(factor);
      json.end_array();
    }
    if (material.image >= 0) {
      json.key("baseColorTexture").begin_object().member("index", material.image).end_object();
    }
    json.member("metallicFactor", 0).member("roughnessFactor", 1).end_object();
    if (material.is_blended) json.member("alphaMode", "BLEND");
    json.key("doubleSided").truth(true);
    json.key("extensions").begin_object().key("KHR_materials_unlit").begin_object().end_object();
    json.end_object().end_object();
  }
  json.end_array();
}

void GlbFile::write_meshes(JsonWriter& json) const {
  json.key("meshes").begin_array();
  for (const Mesh& mesh : meshes_) {
    const Geometry& geometry = geometries_[mesh.geometry];
    const std::uint32_t first = geometry.first_accessor;
    json.begin_object().key("primitives").begin_array().begin_object();
    json.key("attributes").begin_object().member("POSITION", first + 1);
    if (geometry.has_color) json.member("COLOR_0", first + 2);
    if (geometry.has_texture) json.member("TEXCOORD_0", first + (geometry.has_color ? 3 : 2));
    json.end_object().member("indices", first).member("material", mesh.material);
    json.end_object().end_array().end_object();
  }
  json.end_array();
}

void GlbFile::write_accessors(JsonWriter& json) const {
  json.key("accessors").begin_array();
  for (const Geometry& geometry : geometries_) {
    std::uint32_t view = geometry.first_view;
    const auto begin = [&](int component, const char* type, std::uint32_t count) {
      json.begin_object().member("bufferView", view++).member("componentType", component);
      json.member("count", count).member("type", type);
    };
    begin(kUnsignedInt, "SCALAR", geometry.indices);
    json.end_object();
    begin(kFloat, "VEC3", geometry.vertices);
    for (const std::size_t first : {0u, 3u}) {
      json.key(first == 0 ? "min" : "max").begin_array();
      for (std::size_t k = 0; k < 3; ++k) json.value(double{geometry.bounds[first + k]});
      json.end_array();
    }
    json.end_object();
    if (geometry.has_color) {
      begin(kUnsignedShort, "VEC4", geometry.vertices);
      json.key("normalized").truth(true).end_object();
    }
    if (geometry.has_texture) {
      begin(kFloat, "VEC2", geometry.vertices);
      json.end_object();
    }
  }
  json.end_array();
}

void GlbFile::write_buffers(JsonWriter& json) const {
  json.key("buffers").begin_array().begin_object();
  json.member("byteLength", part_bytes_).end_object().end_array();
  json.key("bufferViews").begin_array();
  for (const View& view : views_) {
    json.begin_object().member("buffer", 0).member("byteOffset", view.offset);
    json.member("byteLength", view.bytes);
    if (view.target != 0) json.member("target", view.target);
    json.end_object();
  }
  json.end_array();
}

void GlbFile::write_images(JsonWriter& json) const {
  json.key("samplers").begin_array().begin_object();
  json.member("magFilter", kLinear).member("minFilter", kLinearMipmapLinear);
  json.member("wrapS", kClampToEdge).member("wrapT", kClampToEdge).end_object().end_array();
  json.key("images").begin_array();
  for (const std::uint32_t view : image_view_) {
    json.begin_object().member("bufferView", view).member("mimeType", "image/png").end_object();
  }
  json.end_array().key("textures").begin_array();
  for (std::size_t i = 0; i < image_view_.size(); ++i) {
    json.begin_object().member("sampler", 0).member("source", i).end_object();
  }
  json.end_array();
}

Result<std::vector<std::uint8_t>> GlbFile::finish(double metres_per_unit) {
  JsonWriter json;
  json.begin_object().key("asset").begin_object();
  json.member("version", "2.0").member("generator", "Sfumato").end_object();
  write_scene(json, metres_per_unit);
  if (!meshes_.empty()) {
    json.key("extensionsUsed").begin_array().value("KHR_materials_unlit").end_array();
    write_meshes(json);
    write_materials(json);
    write_accessors(json);
    write_buffers(json);
  }
  if (!image_view_.empty()) write_images(json);
  std::string text = json.end_object().text();
  text.resize(padded(text.size()), ' ');
  Status status = charge_.add(context_, 2 * text.size(), "the GLB");
  if (!status) return status;
  std::vector<std::uint8_t> file;
  const std::size_t binary_bytes = part_bytes_ == 0 ? 0 : 8 + part_bytes_;
  file.reserve(20 + text.size() + binary_bytes);
  append_word(file, kMagic);
  append_word(file, 2);
  append_word(file, 20 + text.size() + binary_bytes);
  append_word(file, text.size());
  append_word(file, kJsonChunk);
  file.insert(file.end(), text.begin(), text.end());
  if (binary_bytes == 0) return file;
  append_word(file, part_bytes_);
  append_word(file, kBinaryChunk);
  for (std::vector<std::uint8_t>& part : parts_) {
    status = append_large(context_, std::span<const std::uint8_t>(part), file);
    if (!status) return status;
    part = std::vector<std::uint8_t>();
  }
  return file;
}

}  // namespace sfumato::outputs
