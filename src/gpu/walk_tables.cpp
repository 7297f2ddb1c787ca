#include "gpu/walk_tables.hpp"

namespace sfumato::gpu {
namespace {

constexpr std::size_t kTexelBytes = 16;

template <class Row>
std::size_t bytes_in(const std::vector<Row>& table) {
  static_assert(sizeof(Row) % kTexelBytes == 0);
  return table.size() * sizeof(Row);
}

}  // namespace

std::size_t WalkTables::bytes_of(const gather::Scene& scene) {
  return bytes_in(scene.edge_beyond) + bytes_in(scene.hit_edge) + bytes_in(scene.blend) +
         bytes_in(scene.triangle);
}

WalkTables::WalkTables(const gather::Scene& scene)
    : scene_identity_(scene.identity),
      bytes_(bytes_of(scene)),
      has_blends_(!scene.blend.empty()),
      buffer_(make_buffer()) {
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, buffer());
  glBufferData(GL_SHADER_STORAGE_BUFFER, static_cast<GLsizeiptr>(bytes_), nullptr, GL_STATIC_DRAW);
  std::size_t at = 0;
  const auto put = [&](const auto& table) {
    const auto begin = static_cast<GLint>(at / kTexelBytes);
    const std::size_t bytes = bytes_in(table);
    glBufferSubData(GL_SHADER_STORAGE_BUFFER, static_cast<GLintptr>(at),
                    static_cast<GLsizeiptr>(bytes), table.data());
    at += bytes;
    return begin;
  };
  put(scene.edge_beyond);
  hit_begin_ = put(scene.hit_edge);
  blend_begin_ = put(scene.blend);
  triangle_begin_ = put(scene.triangle);
}

}  // namespace sfumato::gpu
