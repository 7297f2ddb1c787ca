#include "export/facets/mesh_bytes.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/boxes.hpp"
#include "base/poll.hpp"
#include "base/try.hpp"

namespace sfumato::outputs {
namespace {

constexpr double kMostCoordinate = (1 << 24) - 1;

using Facet = std::array<std::uint32_t, 3>;

/// A shading's data while it is written.
class MeshWriter {
 public:
  MeshWriter(const FacetMesh& mesh, const Box& box, std::vector<std::uint8_t>* bytes)
      : mesh_(mesh), box_(box), bytes_(bytes) {}

  Status write(Context& context);

 private:
  void add_vertex(std::uint8_t flag, std::uint32_t vertex);
  void add_coordinate(double fraction);
  bool continue_strip(const Facet& next);
  void begin_strip(const Facet& facet, const Facet* next);
  Facet facet(std::size_t index) const {
    const std::uint32_t* vertex = mesh_.facet_vertex.data() + 3 * index;
    return {vertex[0], vertex[1], vertex[2]};
  }

  const FacetMesh& mesh_;
  const Box& box_;
  std::vector<std::uint8_t>* bytes_;
  Facet last_{};  ///< the last facet, in the order in which its vertices were written
};

bool has(const Facet& facet, std::uint32_t vertex) {
  return facet[0] == vertex || facet[1] == vertex || facet[2] == vertex;
}

void MeshWriter::add_coordinate(double fraction) {
  const auto value =
      static_cast<std::uint32_t>(std::lround(std::clamp(fraction, 0.0, 1.0) * kMostCoordinate));
  for (int shift = 16; shift >= 0; shift -= 8)
    bytes_->push_back(static_cast<std::uint8_t>(value >> shift));
}

void MeshWriter::add_vertex(std::uint8_t flag, std::uint32_t vertex) {
  bytes_->push_back(flag);
  const Vec2 p = mesh_.vertex_position[vertex] - box_.min;
  add_coordinate(p.x / box_.width());
  add_coordinate(p.y / box_.height());
  const auto channels = static_cast<std::size_t>(mesh_.channel_count);
  for (std::size_t c = 0; c < channels; ++c) {
    const float value = mesh_.vertex_value[channels * vertex + c];
    bytes_->push_back(static_cast<std::uint8_t>(255 * value + 0.5f));
  }
}

/// Adds a facet by one vertex where it shares the last one's newest vertex and another.
bool MeshWriter::continue_strip(const Facet& next) {
  const auto [a, b, c] = last_;
  if (!has(next, c) || has(next, a) == has(next, b)) return false;
  const bool keeps_b = has(next, b);
  const std::uint32_t kept = keeps_b ? b : a;
  for (std::uint32_t vertex : next) {
    if (vertex == c || vertex == kept) continue;
    add_vertex(keeps_b ? 1 : 2, vertex);
    last_ = {kept, c, vertex};
    return true;
  }
  return false;
}

/// Writes three vertices; the first of them does not belong to the next facet.
void MeshWriter::begin_strip(const Facet& facet, const Facet* next) {
  std::size_t first = 0;
  for (std::size_t k = 0; next && k < 3; ++k)
    if (!has(*next, facet[k])) first = k;
  last_ = {facet[first], facet[(first + 1) % 3], facet[(first + 2) % 3]};
  for (std::uint32_t vertex : last_) add_vertex(0, vertex);
}

Status MeshWriter::write(Context& context) {
  RarePoll<65536> poll(context);
  const std::size_t count = mesh_.facet_vertex.size() / 3;
  for (std::size_t i = 0; i < count; ++i) {
    if (poll.cancelled()) return context.cancel_status();
    const Facet here = facet(i);
    if (i > 0 && continue_strip(here)) continue;
    const Facet next = i + 1 < count ? facet(i + 1) : here;
    begin_strip(here, i + 1 < count ? &next : nullptr);
  }
  return ok_status();
}

}  // namespace

Box triangles_box(const PatchLayer& layer) {
  Box box;
  for (const std::uint32_t vertex : layer.triangle_vertex)
    box.extend(layer.vertex_position[vertex]);
  return box;
}

Box decode_box(const std::vector<Vec2>& positions) {
  return decode_box(box_of_points(positions));
}

Box decode_box(Box box) {
  // A side of no length would be divided by.
  const double least = 1e-9 * std::max({std::fabs(box.min.x), std::fabs(box.min.y), 1.0});
  if (!(box.width() > least)) box.max.x = box.min.x + least;
  if (!(box.height() > least)) box.max.y = box.min.y + least;
  return box;
}

Result<std::vector<std::uint8_t>> mesh_bytes(Context& context, const FacetMesh& mesh,
                                             const Box& box, TableMemory& memory) {
  const std::size_t record = 7 + static_cast<std::size_t>(mesh.channel_count);
  const std::size_t most = mesh.facet_vertex.size() * record;
  std::vector<std::uint8_t> bytes;
  SFUMATO_TRY(memory.reserve(context, bytes, most));
  SFUMATO_TRY(MeshWriter(mesh, box, &bytes).write(context));
  return bytes;
}

}  // namespace sfumato::outputs
