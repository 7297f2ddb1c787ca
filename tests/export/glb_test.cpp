// GLB by its own rules, and as an engine shows it (export/glb_scene.hpp).
#include "sfumato/export/glb/glb.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>

#include "export/facets/facet_patch.hpp"
#include "export/glb_scene.hpp"
#include "export/support.hpp"
#include "raster/pictures.hpp"
#include "sfumato/raster/rasterize.hpp"
#include "support/drawing.hpp"
#include "support/scenes.hpp"

namespace sfumato {
namespace {

const Vec2 kHalfBox{0.5, 0.3};

test::Glb exported_glb(const Picture& picture, const GlbOptions& options = {},
                       ExportNotes* notes = nullptr) {
  Context context;
  const auto bytes = export_glb(context, picture, options, notes);
  EXPECT_TRUE(bytes) << to_string(bytes.status());
  EXPECT_EQ(context.budget.used(), 0u);
  return bytes ? test::read_glb(*bytes) : test::Glb{};
}

/// Away from antialiased edges, differences come only from the facets' error and two roundings.
void expect_scene_shown(const Picture& picture, double mean, int p99,
                        const GlbOptions& options = {}) {
  const Box& box = picture.viewport;
  const int width = static_cast<int>(box.width()), height = static_cast<int>(box.height());
  const double longer = std::max(box.width(), box.height());
  const Vec2 half{box.width() / longer / 2, box.height() / longer / 2};
  const Image shown = test::show(exported_glb(picture, options), width, height, half);
  RasterOptions raster;
  raster.width = width;
  raster.height = height;
  raster.antialias = false;
  Context context;
  const auto image = rasterize(context, picture, raster);
  ASSERT_TRUE(image) << to_string(image.status());
  const auto found = test::difference(shown, *image);
  EXPECT_LE(found.mean, mean);
  EXPECT_LE(found.p99, p99);
}

Picture gradient_picture() {
  return test::make_picture(
      test::make_layer(test::jittered_grid(test::kWideBox, 4, 7), [](int, Vec2 p) {
        const auto x = static_cast<float>(p.x / 100), y = static_cast<float>(p.y / 60);
        return Rgb{x, y * y, 0.2f * (1 - x)};
      }));
}

TEST(Glb, a_layer_is_one_mesh_that_all_its_nodes_show) {
  Picture picture = gradient_picture();
  picture.stack.push_back(PatchInstance{0, {0.5, 0, 0, 0.5, 10, 10}, 1, BlendMode::normal});
  const test::Glb glb = exported_glb(picture);
  EXPECT_EQ(glb.json["asset"]["generator"].text(), "Sfumato");
  EXPECT_EQ(glb.json["meshes"].size(), 1u);
  EXPECT_EQ(glb.json["nodes"].size(), 3u);
  EXPECT_EQ(glb.json["materials"].size(), 1u);
  EXPECT_FALSE(glb.json["materials"][0]["alphaMode"].is_there());
  // The later one is closer.
  EXPECT_GT(glb.json["nodes"][2]["matrix"][14].number(),
            glb.json["nodes"][1]["matrix"][14].number());
}

TEST(Glb, shows_colours_where_they_are) {
  expect_scene_shown(gradient_picture(), 0.5, 2);
}

TEST(Glb, turned_mirrored_and_sheared_layers_stand_in_their_places) {
  Picture picture = gradient_picture();
  picture.background = Rgb{0.1f, 0.9f, 0.5f};
  const Affine places[] = {{0.3, 0.1, -0.2, 0.3, 20, 4},
                           {-0.3, 0, 0, 0.3, 80, 2},
                           {0.3, 0, 0.25, 0.4, 20, 30},
                           {0.2, 0.1, 0.3, -0.2, 60, 40}};
  picture.stack.clear();
  for (const Affine& place : places)
    picture.stack.push_back(PatchInstance{0, place, 1, BlendMode::normal});
  // Centres on an edge may belong to either side.
  expect_scene_shown(picture, 1, 2);
  // No node's matrix shears.
  const test::Glb glb = exported_glb(picture);
  for (std::size_t i = 0; i < glb.json["nodes"].size(); ++i) {
    const test::Json& m = glb.json["nodes"][i]["matrix"];
    const double across = m[0].number() * m[4].number() + m[1].number() * m[5].number();
    EXPECT_NEAR(across, 0, 1e-9) << i;
  }
}

TEST(Glb, opacity_of_layers_instances_and_groups_blends) {
  Picture picture = test::make_picture(test::flat_layer(test::kWideBox, {0.8f, 0.4f, 0.2f}, 0.5f));
  picture.background = test::kBlue;
  picture.stack = {GroupBegin{0.5f, BlendMode::normal}, PatchInstance{0, {}, 0.75f}, GroupEnd{},
                   PatchInstance{0, {0.5, 0, 0, 0.5, 0, 0}}};
  expect_scene_shown(picture, 0.6, 1);
}

TEST(Glb, textures_are_those_of_the_raster) {
  GlbOptions options;
  options.dpi = 96;
  const auto document = test::example("textures.svg");
  ASSERT_TRUE(document);
  Picture picture = test::solved(*document);
  const Image shown = test::show(exported_glb(picture, options), 800, 500, {0.5, 0.3125});
  const auto found = test::difference(shown, test::reference(picture, 800, 500));
  EXPECT_LE(found.mean, 0.01);
  EXPECT_EQ(found.p99, 0);
}

TEST(Glb, shows_the_apple_as_we_do) {
  const auto document = test::example("apple.svg");
  ASSERT_TRUE(document);
  Picture picture = test::solved(*document);
  // Modes that glTF lacks would be visible.
  for (PictureItem& item : picture.stack) {
    if (auto* instance = std::get_if<PatchInstance>(&item)) instance->blend = BlendMode::normal;
    if (auto* group = std::get_if<GroupBegin>(&item)) *group = {};
  }
  GlbOptions options;
  options.dpi = 96;
  expect_scene_shown(picture, 0.2, 2, options);
}

TEST(Glb, shows_the_lady_bug_as_we_do) {
  const auto document = test::shared_scene("lady_bug.xml");
  if (!document) GTEST_SKIP() << "no public scene lady_bug.xml";
  expect_scene_shown(test::solved(*document), 0.15, 1);
}

TEST(Glb, tells_what_gltf_cannot_hold) {
  Picture picture = gradient_picture();
  ExportNotes notes;
  exported_glb(picture, {}, &notes);
  EXPECT_TRUE(notes.lost.empty());
  EXPECT_GT(notes.triangle_count, 31u);
  picture.stack = {GroupBegin{0.5f, BlendMode::normal},
                   PatchInstance{0, {}, 1, BlendMode::multiply}, GroupEnd{}};
  exported_glb(picture, {}, &notes);
  EXPECT_EQ(notes.lost.size(), 2u);
}

TEST(Glb, nothing_at_all_is_a_file_too) {
  Picture picture;
  picture.artboard = picture.viewport = test::kWideBox;
  const test::Glb glb = exported_glb(picture);
  EXPECT_EQ(glb.json["nodes"].size(), 1u);
  EXPECT_TRUE(glb.binary.empty());
  EXPECT_FALSE(glb.json["meshes"].is_there());
  picture.background = test::kGreen;
  const Image shown = test::show(exported_glb(picture), 10, 6, kHalfBox);
  EXPECT_EQ(shown.bytes[0], 0);
  EXPECT_EQ(shown.bytes[1], 255);
}

TEST(Glb, values_that_are_no_numbers_are_not_written) {
  Picture picture = test::make_picture(test::flat_layer(test::kWideBox, {0.2f, 0.4f, 0.6f}, 0.5f));
  picture.layers[0].color.node_value[4] = std::numeric_limits<float>::quiet_NaN();
  picture.layers[0].color.node_value[7] = std::numeric_limits<float>::infinity();
  picture.layers[0].opacity.node_value[2] = -std::numeric_limits<float>::infinity();
  const test::Glb glb = exported_glb(picture);
  const test::Json& view = glb.json["bufferViews"][1];
  for (std::size_t i = 0; i < view["byteLength"].index(); i += 4) {
    float position;
    std::memcpy(&position, glb.binary.data() + view["byteOffset"].index() + i, 4);
    EXPECT_TRUE(std::isfinite(position));
  }
}

TEST(Glb, options_and_pictures_that_mean_nothing_are_errors) {
  Context context;
  const Picture picture = gradient_picture();
  for (double GlbOptions::*option : {&GlbOptions::dpi, &GlbOptions::max_error, &GlbOptions::size}) {
    for (const double value : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()}) {
      GlbOptions options;
      options.*option = value;
      EXPECT_EQ(export_glb(context, picture, options).status().code, StatusCode::bad_input);
    }
  }
  EXPECT_EQ(export_glb(context, Picture{}, {}).status().code, StatusCode::bad_input);
}

TEST(Glb, stops_when_it_is_cancelled_or_out_of_memory) {
  const Picture picture = gradient_picture();
  Context cancelled;
  cancelled.cancel = true;
  EXPECT_EQ(export_glb(cancelled, picture, {}).status().code, StatusCode::cancelled);
  Context poor{.budget = Budget(1000)};
  EXPECT_EQ(export_glb(poor, picture, {}).status().code, StatusCode::limit);
}

/// Returns the largest difference, in code values of 255, between a patch and its facets, which are
/// linear in light.
double light_error(const PatchLayer& layer, double max_error) {
  using outputs::FacetSource;
  const FacetSource source{FacetSource::Kind::light, 0};
  Context context;
  const auto mesh =
      outputs::make_facets(context, layer, InterpolationSpace::srgb, source, max_error / 255);
  EXPECT_TRUE(mesh) << to_string(mesh.status());
  double largest = 0;
  for (std::uint32_t t = 0; t < layer.triangle_count(); ++t) {
    const outputs::FacetPatch patch(layer, InterpolationSpace::srgb, source, t, max_error / 255);
    const Vec2 corner[3] = {layer.vertex_position[layer.triangle_vertex[3 * t]],
                            layer.vertex_position[layer.triangle_vertex[3 * t + 1]],
                            layer.vertex_position[layer.triangle_vertex[3 * t + 2]]};
    const double area = cross(corner[1] - corner[0], corner[2] - corner[0]);
    for (std::uint32_t f = mesh->patch_first_facet[t]; f < mesh->patch_first_facet[t + 1]; ++f) {
      for (int i = 0; i <= 8; ++i) {
        for (int j = 0; i + j <= 8; ++j) {
          const double weight[3] = {(8 - i - j) / 8.0, i / 8.0, j / 8.0};
          Vec2 p;
          double light[4] = {};
          for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t vertex = mesh->facet_vertex[std::size_t{3} * f + k];
            p = p + mesh->vertex_position[vertex] * weight[k];
            for (std::size_t c = 0; c < 4; ++c) {
              const double value = mesh->vertex_value[4 * vertex + c];
              light[c] += weight[k] * (c < 3 ? linear_from_code(value) : value);
            }
          }
          const auto exact = patch.shown({cross(corner[1] - p, corner[2] - p) / area,
                                          cross(corner[2] - p, corner[0] - p) / area,
                                          cross(corner[0] - p, corner[1] - p) / area});
          for (std::size_t c = 0; c < 4; ++c) {
            const double shown = c < 3 ? code_from_linear(light[c]) : light[c];
            largest = std::max(largest, 255 * std::fabs(shown - exact[c]));
          }
        }
      }
    }
  }
  return largest;
}

TEST(LightFacets, keep_their_error_in_code_values) {
  // From black, where equal steps of light differ most in code values, and around the plane.
  const auto field = [](int, Vec2 p) {
    const double x = p.x / 100, y = p.y / 60;
    return Rgb{static_cast<float>(x * x), static_cast<float>(0.5 + 0.3 * std::sin(4 * x + 5 * y)),
               static_cast<float>(0.2 * y)};
  };
  const test::RegionMesh mesh = test::jittered_grid(test::kWideBox, 4, 11);
  PatchLayer layer = test::make_layer(mesh, field);
  PatchField& color = layer.color;
  std::vector<float> values;
  for (std::size_t i = 0; i < color.node_value.size(); i += 3) {
    values.insert(values.end(), color.node_value.begin() + static_cast<std::ptrdiff_t>(i),
                  color.node_value.begin() + static_cast<std::ptrdiff_t>(i + 3));
    values.push_back(color.node_value[i + 1]);
  }
  color.channel_count = 4;
  color.node_value = values;
  for (const double max_error : {0.5, 1.0, 4.0}) {
    const double found = light_error(layer, max_error);
    EXPECT_LE(found, max_error);
    EXPECT_GE(found, 0.3 * max_error);  // the bound is not too loose
  }
}

}  // namespace
}  // namespace sfumato
