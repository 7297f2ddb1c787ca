#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "base/output_buffer.hpp"
#include "base/poll.hpp"
#include "base/public_verb.hpp"
#include "base/try.hpp"
#include "document/names.hpp"
#include "export/joined_field.hpp"
#include "export/page.hpp"
#include "export/poll_interval.hpp"
#include "export/tables/table_list.hpp"
#include "picture/check_picture.hpp"
#include "picture/patch.hpp"
#include "sfumato/base/color_space.hpp"
#include "sfumato/export/tables/tables.hpp"

namespace sfumato {
namespace outputs {
namespace {

constexpr std::uint64_t kMost = 0xffffffff;

/// The nine small triangles between the ten nodes of a patch: at corner 0, around the middle, at
/// corners 1 and 2. All turn as the patch does.
constexpr std::array<std::array<std::uint8_t, 3>, 9> kFaces{{{0, 3, 8},
                                                             {3, 9, 8},
                                                             {3, 4, 9},
                                                             {4, 5, 9},
                                                             {4, 1, 5},
                                                             {8, 9, 7},
                                                             {9, 6, 7},
                                                             {9, 5, 6},
                                                             {7, 6, 2}}};

/// A layer as vertices, made once for all its instances.
struct LayerMesh {
  PatchField field;            ///< colour and alpha
  std::vector<Vec2> position;  ///< of its nodes, layer frame
  std::vector<std::array<std::uint8_t, 3>> srgb;
};

struct PlacedInstance {
  const PatchInstance* instance;
  float opacity;  ///< with that of its groups
};

class PlyWriter {
 public:
  PlyWriter(const Context& context, const Picture& picture)
      : context_(context), picture_(picture), layers_(picture.layers.size()) {}

  Result<std::vector<std::uint8_t>> write(Context& context);

 private:
  Status list_placed();
  Status make_layer(Context& context, const PatchLayer& layer, LayerMesh& mesh);
  void write_header(OutputBuffer& file) const;
  Status write_vertices(const PlacedInstance& placed, double z, OutputBuffer& file) const;
  Status write_faces(const PlacedInstance& placed, std::uint32_t first, OutputBuffer& file) const;

  const Context& context_;
  const Picture& picture_;
  TableMemory memory_{"the vertices of a PLY"};
  std::vector<std::optional<LayerMesh>> layers_;
  std::vector<PlacedInstance> placed_;
  std::uint64_t vertices_ = 0, faces_ = 0;
};

std::uint8_t code_value(double value) {
  return static_cast<std::uint8_t>(std::lround(255 * std::clamp(value, 0.0, 1.0)));
}

/// std::clamp lets NaN through, and lround would not know where to.
std::uint8_t safe_code(float value) {
  return code_value(std::isnan(value) ? 0 : value);
}

template <class Number>
std::uint8_t* put(std::uint8_t* at, Number value) {
  std::memcpy(at, &value, sizeof(value));
  return at + sizeof(value);
}

/// The instances that show triangles.
Status PlyWriter::list_placed() {
  std::vector<float> opacity{1};
  RarePoll<kWritesPerPoll> poll(context_);
  for (const PictureItem& item : picture_.stack) {
    if (poll.cancelled()) return context_.cancel_status();
    if (const auto* group = std::get_if<GroupBegin>(&item)) {
      opacity.push_back(opacity.back() * group->opacity);
    } else if (std::holds_alternative<GroupEnd>(item)) {
      opacity.pop_back();
    } else if (const auto* instance = std::get_if<PatchInstance>(&item)) {
      if (picture_.layers[instance->layer].triangle_count() == 0) continue;
      const PlacedInstance placed{instance, opacity.back() * instance->opacity};
      SFUMATO_TRY(memory_.push_back(context_, placed_, placed));
    }
  }
  return ok_status();
}

/// Removes the nodes that no triangle uses: nodes of triangles that showed nothing.
Status drop_unused(const Context& context, PatchField& field, std::vector<Vec2>& position) {
  TableMemory scratch("the vertices of a PLY");
  std::vector<std::uint32_t> place;
  SFUMATO_TRY(scratch.resize(context, place, position.size()));
  RarePoll<kWritesPerPoll> poll(context);
  std::uint32_t kept = 0;
  for (std::size_t i = 0; i < position.size(); ++i) {
    if (poll.cancelled()) return context.cancel_status();
    place[i] = kept;
    if (std::isnan(position[i].x)) continue;
    position[kept] = position[i];
    std::copy_n(field.node_value.begin() + static_cast<std::ptrdiff_t>(4 * i), 4,
                field.node_value.begin() + std::ptrdiff_t{4} * kept);
    ++kept;
  }
  position.resize(kept);
  field.node_value.resize(std::size_t{4} * kept);
  for (std::uint32_t& node : field.triangle_node) {
    if (poll.cancelled()) return context.cancel_status();
    node = place[node];
  }
  return ok_status();
}

Status PlyWriter::make_layer(Context& context, const PatchLayer& layer, LayerMesh& mesh) {
  SFUMATO_TRY_ASSIGN(mesh.field, joined_field(context, layer.color, layer.opacity, memory_));
  SFUMATO_TRY(find_node_positions(context, layer, mesh.field, memory_, mesh.position));
  SFUMATO_TRY(drop_unused(context, mesh.field, mesh.position));
  const std::size_t nodes = mesh.position.size();
  SFUMATO_TRY(memory_.reserve(context, mesh.srgb, nodes));
  RarePoll<kWritesPerPoll> poll(context);
  for (std::size_t i = 0; i < nodes; ++i) {
    if (poll.cancelled()) return context.cancel_status();
    const float* value = mesh.field.node_value.data() + 4 * i;
    const Rgb color = to_srgb(picture_.interpolation, {value[0], value[1], value[2]});
    mesh.srgb.push_back({safe_code(color.r), safe_code(color.g), safe_code(color.b)});
  }
  return ok_status();
}

void PlyWriter::write_header(OutputBuffer& file) const {
  file += "ply\nformat ";
  file += std::endian::native == std::endian::little ? "binary_little_endian" : "binary_big_endian";
  file +=
      " 1.0\n"
      "comment Sfumato: nodes of the patches; artboard frame, y up; nine faces a patch\n"
      "comment value_0 to value_2: in the interpolation space ";
  file += space_name(picture_.interpolation);
  file += "\nelement vertex " + std::to_string(vertices_) +
          "\nproperty float x\nproperty float y\nproperty float z\n"
          "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty uchar alpha\n"
          "property float value_0\nproperty float value_1\nproperty float value_2\n"
          "element face " +
          std::to_string(faces_) + "\nproperty list uchar uint vertex_indices\nend_header\n";
}

Status PlyWriter::write_vertices(const PlacedInstance& placed, double z, OutputBuffer& file) const {
  constexpr std::size_t kBytes = 28;
  const LayerMesh& mesh = *layers_[placed.instance->layer];
  RarePoll<kWritesPerPoll> poll(context_);
  for (std::size_t i = 0; i < mesh.position.size(); ++i) {
    if (poll.cancelled()) return context_.cancel_status();
    const Vec2 p = placed.instance->artboard_from_layer(mesh.position[i]);
    const float* value = mesh.field.node_value.data() + 4 * i;
    std::array<std::uint8_t, kBytes> bytes;
    std::uint8_t* at = bytes.data();
    for (const double coordinate : {p.x, -p.y, z}) at = put(at, static_cast<float>(coordinate));
    at = std::copy(mesh.srgb[i].begin(), mesh.srgb[i].end(), at);
    at = put(at, safe_code(value[3] * placed.opacity));
    for (int channel = 0; channel < 3; ++channel) at = put(at, value[channel]);
    file.append(bytes);
  }
  return file.status();
}

Status PlyWriter::write_faces(const PlacedInstance& placed, std::uint32_t first,
                              OutputBuffer& file) const {
  constexpr std::size_t kBytes = 13;
  const std::vector<std::uint32_t>& node = layers_[placed.instance->layer]->field.triangle_node;
  // Turned over with the y axis, they run the other way; a mirrored instance turns them once more.
  const bool is_mirrored = placed.instance->artboard_from_layer.determinant() < 0;
  RarePoll<kWritesPerPoll> poll(context_);
  for (std::size_t slot = 0; slot < node.size(); slot += kNodesPerTriangle) {
    if (poll.cancelled()) return context_.cancel_status();
    for (const auto& face : kFaces) {
      std::array<std::uint8_t, kBytes> bytes;
      std::uint8_t* at = put(bytes.data(), std::uint8_t{3});
      for (const std::size_t k : {0, is_mirrored ? 1 : 2, is_mirrored ? 2 : 1}) {
        at = put(at, first + node[slot + face[k]]);
      }
      file.append(bytes);
    }
  }
  return file.status();
}

Result<std::vector<std::uint8_t>> PlyWriter::write(Context& context) {
  SFUMATO_TRY(list_placed());
  for (const PlacedInstance& placed : placed_) {
    const PatchLayer& layer = picture_.layers[placed.instance->layer];
    std::optional<LayerMesh>& mesh = layers_[placed.instance->layer];
    if (!mesh) {
      SFUMATO_TRY(make_layer(context, layer, mesh.emplace()));
    }
    vertices_ += mesh->position.size();
    faces_ += std::uint64_t{kFaces.size()} * layer.triangle_count();
  }
  if (vertices_ > kMost || faces_ > kMost) {
    return make_error(StatusCode::limit, "more than a PLY holds: 2^32 vertices and faces");
  }
  OutputBuffer file(context, "the PLY");
  write_header(file);
  const Box& viewport = picture_.viewport;
  const double side = std::max(viewport.width(), viewport.height());
  const double step = depth_step(side, placed_.size() + 1);
  for (std::size_t i = 0; i < placed_.size(); ++i) {
    SFUMATO_TRY(write_vertices(placed_[i], step * static_cast<double>(i), file));
  }
  std::uint32_t first = 0;
  for (const PlacedInstance& placed : placed_) {
    SFUMATO_TRY(write_faces(placed, first, file));
    first += static_cast<std::uint32_t>(layers_[placed.instance->layer]->position.size());
  }
  return file.finish();
}

Result<std::vector<std::uint8_t>> write_ply(Context& context, const Picture& picture,
                                            ExportNotes* notes) {
  SFUMATO_TRY(check_viewport(picture.viewport));
  SFUMATO_TRY(picture::check_picture(context, picture));
  Result<std::vector<std::uint8_t>> file = PlyWriter(context, picture).write(context);
  if (file) note_omissions(picture, notes);
  return file;
}

}  // namespace
}  // namespace outputs

Result<std::vector<std::uint8_t>> export_ply(Context& context, const Picture& picture,
                                             ExportNotes* notes) {
  return public_verb(context, [&] { return outputs::write_ply(context, picture, notes); });
}

}  // namespace sfumato
