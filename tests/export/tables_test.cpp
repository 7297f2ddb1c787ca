#include "sfumato/export/tables/tables.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "export/support.hpp"

/// The solution as tables. The tests of the Python package check that NumPy and Python's json read
/// them (bindings/python/tests/test_tables.py).
namespace sfumato {
namespace {

using test::Bytes;

template <class Number>
Number number_at(const Bytes& bytes, std::size_t at) {
  Number value{};
  EXPECT_LE(at + sizeof(value), bytes.size());
  if (at + sizeof(value) <= bytes.size()) std::memcpy(&value, bytes.data() + at, sizeof(value));
  return value;
}

/// The arrays of an NPZ by name: the data after each header.
struct Array {
  std::string header;
  Bytes data;
};

std::map<std::string, Array> arrays_of(const Bytes& file) {
  std::map<std::string, Array> arrays;
  std::size_t at = 0;
  while (number_at<std::uint32_t>(file, at) == 0x04034b50) {
    const auto size = number_at<std::uint32_t>(file, at + 18);
    const auto name_size = number_at<std::uint16_t>(file, at + 26);
    const auto* name = reinterpret_cast<const char*>(file.data() + at + 30);
    const std::size_t data = at + 30 + name_size;
    const std::size_t header_size = 10 + number_at<std::uint16_t>(file, data + 8);
    Array& array = arrays[std::string(name, name_size)];
    array.header.assign(file.begin() + static_cast<std::ptrdiff_t>(data + 10),
                        file.begin() + static_cast<std::ptrdiff_t>(data + header_size));
    array.data.assign(file.begin() + static_cast<std::ptrdiff_t>(data + header_size),
                      file.begin() + static_cast<std::ptrdiff_t>(data + size));
    EXPECT_EQ(header_size % 64, 0u);
    at = data + size;
  }
  return arrays;
}

template <class Item>
void expect_holds(const Array& array, const std::vector<Item>& items, const std::string& header) {
  ASSERT_EQ(array.data.size(), items.size() * sizeof(Item)) << header;
  if (!items.empty()) {
    EXPECT_EQ(std::memcmp(array.data.data(), items.data(), array.data.size()), 0) << header;
  }
  EXPECT_NE(array.header.find(header), std::string::npos) << array.header;
}

std::string shape_text(const char* type, std::size_t rows, int columns) {
  return std::string("'descr': '") + type + "', 'fortran_order': False, 'shape': (" +
         std::to_string(rows) + ", " + std::to_string(columns) + ")";
}

TEST(Npz, holds_the_tables_of_every_layer_to_the_bit) {
  for (const char* name : {"apple.svg", "strokes.svg", "textures.svg"}) {
    const auto document = test::example(name);
    ASSERT_TRUE(document);
    const Picture picture = test::solved(*document);
    Context context;
    const auto file = export_npz(context, picture);
    ASSERT_TRUE(file.ok()) << to_string(file.status());
    const auto arrays = arrays_of(*file);
    for (std::size_t i = 0; i < picture.layers.size(); ++i) {
      const PatchLayer& layer = picture.layers[i];
      const auto array = [&](const std::string& table) {
        const auto found = arrays.find("layer" + std::to_string(i) + "/" + table + ".npy");
        EXPECT_TRUE(found != arrays.end()) << table;
        return found == arrays.end() ? Array{} : found->second;
      };
      const auto channels = static_cast<std::size_t>(layer.color.channel_count);
      expect_holds(array("vertices"), layer.vertex_position,
                   shape_text("<f8", layer.vertex_position.size(), 2));
      expect_holds(array("triangles"), layer.triangle_vertex,
                   shape_text("<u4", layer.triangle_count(), 3));
      expect_holds(array("curve_edges"), layer.edge_is_curve,
                   shape_text("|u1", layer.triangle_count(), 3));
      expect_holds(array("color_nodes"), layer.color.triangle_node,
                   shape_text("<u4", layer.triangle_count(), 10));
      expect_holds(
          array("color_values"), layer.color.node_value,
          shape_text("<f4", layer.color.node_value.size() / channels, static_cast<int>(channels)));
      EXPECT_EQ(arrays.count("layer" + std::to_string(i) + "/opacity_nodes.npy"),
                layer.opacity.channel_count > 0 ? 1u : 0u);
    }
  }
}

TEST(Npz, nodes_lie_where_the_patches_have_them) {
  const Picture picture = test::picture_of_one_triangle();
  Context context;
  const auto file = export_npz(context, picture);
  ASSERT_TRUE(file.ok());
  const Bytes position = arrays_of(*file)["layer0/color_positions.npy"].data;
  const PatchLayer& layer = picture.layers[0];
  for (std::size_t place = 0; place < kNodesPerTriangle; ++place) {
    const std::size_t node = layer.color.triangle_node[place];
    const Vec2 p{number_at<double>(position, 16 * node),
                 number_at<double>(position, 16 * node + 8)};
    const float* value = layer.color.node_value.data() + 3 * node;
    EXPECT_NEAR(p.x, 64.0 * static_cast<double>(value[0]), 1e-4) << place;
    EXPECT_NEAR(p.y, 64.0 * static_cast<double>(value[2]), 1e-4) << place;
  }
}

TEST(TableJson, is_exact_and_names_what_it_holds) {
  Picture picture = test::picture_of_one_triangle();
  picture.background = Rgb{0, 0.5f, 1};
  picture.layers[0].color.node_value[0] = 0.1f;
  Context context;
  const auto file = export_json(context, picture);
  ASSERT_TRUE(file.ok());
  const std::string text(file->begin(), file->end());
  for (const char* part : {"\"artboard\":[0,0,64,64]", "\"background\":[0,0.5,1]",
                           "\"vertices\":[[3,4],\n[60,20],\n[11,44]]", "\"triangles\":[[0,1,2]]",
                           "\"order\":\"cubic\"", "\"color_values\":[[0.1,",
                           "\"stack\":[{\"layer\":0,\"matrix\":[1,0,0,1,0,0],\"opacity\":1,"
                           "\"blend\":\"normal\"}]}\n"}) {
    EXPECT_NE(text.find(part), std::string::npos) << part << " in\n" << text;
  }
}

struct PlyVertex {
  float x, y, z;
  std::uint8_t code[4];
  float value[3];
};
static_assert(sizeof(PlyVertex) == 28);

struct Ply {
  std::string header;
  std::vector<PlyVertex> vertex;
  std::vector<std::uint32_t> face;  ///< 3 per face
};

Ply parse_ply(const Bytes& file) {
  Ply ply;
  const std::string text(file.begin(), file.end());
  std::size_t at = text.find("end_header\n") + 11;
  ply.header = text.substr(0, at);
  const auto count = [&](const std::string& element) {
    const std::size_t place = ply.header.find(element) + element.size();
    return std::stoul(ply.header.substr(place));
  };
  ply.vertex.resize(count("element vertex "));
  for (PlyVertex& vertex : ply.vertex) {
    vertex = number_at<PlyVertex>(file, at);
    at += sizeof(PlyVertex);
  }
  const std::size_t faces = count("element face ");
  for (std::size_t i = 0; i < faces; ++i, at += 13) {
    EXPECT_EQ(file[at], 3);
    for (std::size_t k = 0; k < 3; ++k) {
      ply.face.push_back(number_at<std::uint32_t>(file, at + 1 + 4 * k));
      EXPECT_LT(ply.face.back(), ply.vertex.size());
    }
  }
  EXPECT_EQ(at, file.size());
  return ply;
}

double signed_area(const Ply& ply, std::size_t face) {
  const PlyVertex& a = ply.vertex[ply.face[3 * face]];
  const PlyVertex& b = ply.vertex[ply.face[3 * face + 1]];
  const PlyVertex& c = ply.vertex[ply.face[3 * face + 2]];
  return 0.5 * (double{b.x - a.x} * double{c.y - a.y} - double{b.y - a.y} * double{c.x - a.x});
}

TEST(Ply, nine_faces_of_a_patch_cover_it_and_turn_the_right_way) {
  Picture picture = test::picture_of_one_triangle();
  auto& instance = std::get<PatchInstance>(picture.stack[0]);
  for (const Affine& place :
       {Affine{}, Affine{-1, 0, 0, 1, 64, 0}, Affine{0.5, 0.1, -0.2, 0.5, 9, 8}}) {
    instance.artboard_from_layer = place;
    Context context;
    const auto file = export_ply(context, picture);
    ASSERT_TRUE(file.ok());
    const Ply ply = parse_ply(*file);
    ASSERT_EQ(ply.face.size(), 27u);
    const double whole = 0.5 * cross(Vec2{57, 16}, Vec2{8, 40}) * std::fabs(place.determinant());
    for (std::size_t face = 0; face < 9; ++face) {
      EXPECT_NEAR(signed_area(ply, face), whole / 9, 1e-3 * whole) << face;
    }
    EXPECT_FLOAT_EQ(ply.vertex[0].y, static_cast<float>(-place(Vec2{3, 4}).y));
  }
}

TEST(Ply, colours_are_srgb_and_alpha_is_that_of_layer_instance_and_group) {
  Picture picture = test::picture_of_one_triangle();
  picture.interpolation = InterpolationSpace::linear;
  std::get<PatchInstance>(picture.stack[0]).opacity = 0.5f;
  picture.stack.insert(picture.stack.begin(), GroupBegin{.opacity = 0.5f});
  picture.stack.push_back(GroupEnd{});
  picture.stack.push_back(PatchInstance{});
  Context context;
  ExportNotes notes;
  const auto file = export_ply(context, picture, &notes);
  ASSERT_TRUE(file.ok());
  const Ply ply = parse_ply(*file);
  ASSERT_EQ(ply.vertex.size(), 20u);
  EXPECT_EQ(ply.vertex[0].code[3], 64);
  EXPECT_EQ(ply.vertex[10].code[3], 255);
  EXPECT_EQ(ply.vertex[0].code[1], 188);  // of 0.5 in linear light
  EXPECT_EQ(ply.vertex[0].value[1], 0.5f);
  EXPECT_GT(ply.vertex[10].z, ply.vertex[0].z);
  ASSERT_EQ(notes.lost.size(), 1u);
  EXPECT_EQ(notes.lost[0], "groups are left out, their items are not");
}

TEST(Ply, nodes_that_differ_in_opacity_are_vertices_of_their_own) {
  const auto document = test::example("apple.svg");
  ASSERT_TRUE(document);
  const Picture picture = test::solved(*document);
  Context context;
  const auto file = export_ply(context, picture);
  ASSERT_TRUE(file.ok());
  const Ply ply = parse_ply(*file);
  for (const PlyVertex& vertex : ply.vertex) ASSERT_TRUE(std::isfinite(vertex.x));
  std::size_t faces = 0, nodes = 0;
  for (const PictureItem& item : picture.stack) {
    const auto* instance = std::get_if<PatchInstance>(&item);
    if (!instance) continue;
    const PatchLayer& layer = picture.layers[instance->layer];
    faces += 9 * layer.triangle_count();
    const auto& used = layer.color.triangle_node;
    nodes += std::set<std::uint32_t>(used.begin(), used.end()).size();
  }
  EXPECT_EQ(ply.face.size(), 3 * faces);
  EXPECT_GE(ply.vertex.size(), nodes);
  EXPECT_LE(ply.vertex.size(), 2 * nodes);
}

}  // namespace
}  // namespace sfumato
