#include "equal/tool/scene_trace.hpp"

#include <cstring>
#include <string>
#include <utility>

#include "sfumato/api/render_pixels.hpp"
#include "sfumato/codecs/png.hpp"
#include "sfumato/formats/svg/svg_write.hpp"
#include "solve/layers/layer_solver.hpp"
#include "solve/layers/prepare_layer.hpp"

namespace sfumato::test {
namespace {

void add_segments(const std::string& stage, const curves::SegmentAttributes& attributes,
                  const std::vector<curves::SegmentSide>& sides, Trace& trace) {
  std::vector<std::uint32_t> kinds;
  std::vector<float> values;
  for (const curves::SegmentSide& side : sides) {
    kinds.insert(kinds.end(), {static_cast<std::uint32_t>(side.kind), side.shader});
    for (const curves::FieldValue& value : {side.value.start, side.value.end}) {
      values.insert(values.end(), value.channel.begin(), value.channel.end());
    }
    values.insert(values.end(), {side.blur_radius.start, side.blur_radius.end});
  }
  trace.push_back(numbers(stage + " kinds", kinds, 2, attributes.vertex));
  trace.push_back(numbers(stage + " values", values, 10, attributes.vertex));
}

void add_attributes(const std::string& stage, const curves::SegmentAttributes& attributes,
                    Trace& trace) {
  trace.push_back(points(stage + " vertices", attributes.vertex));
  trace.push_back(numbers(stage + " curves", attributes.curve, 1, attributes.vertex));
  trace.push_back(numbers(stage + " weights", attributes.weight, 1, attributes.vertex));
  add_segments(stage + " left", attributes, attributes.left, trace);
  add_segments(stage + " right", attributes, attributes.right, trace);
}

/// Returns the centre of each triangle.
std::vector<Vec2> triangle_centers(const mesh::TriangleMesh& mesh) {
  std::vector<Vec2> centers;
  for (std::size_t i = 0; i < mesh.triangle_vertex.size(); i += 3) {
    Vec2 sum;
    for (std::size_t k = 0; k < 3; ++k) {
      sum = sum + mesh.vertex_position[mesh.triangle_vertex[i + k]];
    }
    centers.push_back(sum * (1.0 / 3));
  }
  return centers;
}

void add_mesh(const std::string& stage, const mesh::TriangleMesh& mesh, Trace& trace) {
  const std::vector<Vec2> centers = triangle_centers(mesh);
  std::vector<std::uint32_t> constraints;
  for (const mesh::Constraint& c : mesh.constraint) {
    constraints.insert(constraints.end(), {c.from, c.to, c.piece_begin, c.piece_end});
  }
  std::vector<std::uint32_t> segments;
  std::vector<float> fractions;
  for (const mesh::SegmentPiece& piece : mesh.piece) {
    segments.push_back(piece.segment);
    fractions.insert(fractions.end(), {piece.u_from, piece.u_to});
  }
  trace.push_back(points(stage + " vertices", mesh.vertex_position));
  trace.push_back(numbers(stage + " triangles", mesh.triangle_vertex, 3, centers));
  trace.push_back(numbers(stage + " twins", mesh.half_edge_twin, 3, centers));
  trace.push_back(numbers(stage + " constrained edges", mesh.half_edge_constraint, 3, centers));
  trace.push_back(numbers(stage + " constraints", constraints, 4));
  trace.push_back(numbers(stage + " pieces", segments, 1));
  trace.push_back(numbers(stage + " fractions of pieces", fractions, 2));
}

void add_field(const std::string& stage, const solve::FieldSolver& field, Trace& trace) {
  const solve::NodeLayout& layout = field.layout();
  trace.push_back(points(stage + " node positions", layout.position));
  trace.push_back(numbers(stage + " fixed nodes", layout.is_fixed, 1, layout.position));
  trace.push_back(numbers(stage + " nodes of triangles", layout.triangle_node, 10));
  trace.push_back(numbers(stage + " node values", layout.value,
                          static_cast<std::uint32_t>(layout.channel_count), layout.position));
}

void add_patch_field(const std::string& stage, const PatchField& field, Trace& trace) {
  if (field.channel_count == 0) return;
  trace.push_back(numbers(stage + " nodes of triangles", field.triangle_node, 10));
  trace.push_back(numbers(stage + " node values", field.node_value,
                          static_cast<std::uint32_t>(field.channel_count)));
  trace.push_back(numbers(stage + " shaders", field.shader, 1));
}

void add_patches(const std::string& stage, const PatchLayer& layer, Trace& trace) {
  trace.push_back(points(stage + " frame", {layer.frame.min, layer.frame.max}));
  trace.push_back(points(stage + " vertices", layer.vertex_position));
  trace.push_back(numbers(stage + " triangles", layer.triangle_vertex, 3));
  trace.push_back(numbers(stage + " edges on curves", layer.edge_is_curve, 3));
  add_patch_field(stage + " color", layer.color, trace);
  add_patch_field(stage + " opacity", layer.opacity, trace);
}

void add_image(const std::string& stage, const Image& image, Trace& trace) {
  std::vector<Vec2> center;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) center.push_back({x + 0.5, y + 0.5});
  }
  const NumberType type = bytes_per_channel(image.format) == 1 ? NumberType::u8 : NumberType::u16;
  trace.push_back({stage, type, static_cast<std::uint32_t>(channel_count(image.format)),
                   image.bytes, std::move(center)});
}

/// Returns the first `count` items of a stack; open groups are closed.
std::vector<PictureItem> first_items(const std::vector<PictureItem>& stack, std::size_t count) {
  std::vector<PictureItem> items(stack.begin(), stack.begin() + static_cast<std::ptrdiff_t>(count));
  std::ptrdiff_t open_groups = 0;
  for (const PictureItem& item : items) {
    if (std::holds_alternative<GroupBegin>(item)) ++open_groups;
    if (std::holds_alternative<GroupEnd>(item)) --open_groups;
  }
  items.insert(items.end(), static_cast<std::size_t>(open_groups), GroupEnd{});
  return items;
}

class Tracer {
 public:
  Tracer(Context& context, const Scene& scene) : context_(context), scene_(scene) {}

  Result<Trace> run() {
    Status status = add_document();
    Picture picture;
    if (status) status = add_picture(picture);
    if (status) status = add_images(std::move(picture));
    if (status && scene_.by_pixels) status = add_pixels();
    if (!status) return status;
    return std::move(trace_);
  }

 private:
  Status add_document();
  Status add_picture(Picture& picture);
  Result<PatchLayer> solve_layer(std::uint32_t index, const Box& viewport);
  Status add_images(Picture picture);
  Status add_pixels();

  Context& context_;
  const Scene& scene_;
  Trace trace_;
};

Status Tracer::add_document() {
  for (std::size_t i = 0; i < scene_.document.layers.size(); ++i) {
    std::vector<Vec2> all;
    for (const Curve& curve : scene_.document.layers[i].curves) {
      all.insert(all.end(), curve.control_points.begin(), curve.control_points.end());
    }
    trace_.push_back(points("document, layer " + std::to_string(i) + ": control points", all));
  }
  const Result<std::string> text = write_svg(context_, scene_.document);
  if (!text) return text.status();
  trace_.push_back(
      numbers("document as SVG", std::vector<std::uint8_t>(text->begin(), text->end()), 1));
  return ok_status();
}

Status Tracer::add_picture(Picture& picture) {
  const Box viewport = scene_.diffuse.viewport.value_or(scene_.document.artboard);
  Result<Picture> frame = picture_frame(context_, scene_.document, viewport);
  if (!frame) return frame.status();
  picture = std::move(*frame);
  for (std::uint32_t i = 0; i < scene_.document.layers.size(); ++i) {
    Result<PatchLayer> layer = solve_layer(i, viewport);
    if (!layer) return layer.status();
    picture.layers.push_back(std::move(*layer));
  }
  return ok_status();
}

/// Solves a layer as diffuse() does, and records every round.
Result<PatchLayer> Tracer::solve_layer(std::uint32_t index, const Box& viewport) {
  const std::string stage = "layer " + std::to_string(index) + ", ";
  const solve::LayerSight sight = solve::sight_of_layer(scene_.document, index, viewport);
  if (sight.viewport.empty() || scene_.document.layers[index].curves.empty()) return PatchLayer{};
  Result<solve::PreparedLayer> scene = solve::prepare_layer(
      context_, scene_.document, index, sight, scene_.diffuse, nullptr, solve::LayerUse::patches);
  if (!scene) return scene.status();
  add_attributes(stage + "flatten: color", scene->color.attributes, trace_);
  if (scene->opacity)
    add_attributes(stage + "flatten: opacity", scene->opacity->attributes, trace_);
  add_mesh(stage + "mesh:", *scene->mesher.visibility_mesh({}), trace_);
  int round = 0;
  const auto watch = [&](const mesh::TriangleMesh& mesh, const solve::FieldSolver& color,
                         const solve::FieldSolver* opacity) {
    const std::string name = stage + "round " + std::to_string(round++) + ": ";
    add_mesh(name + "mesh", mesh, trace_);
    add_field(name + "color", color, trace_);
    if (opacity) add_field(name + "opacity", *opacity, trace_);
  };
  Result<PatchLayer> layer =
      solve::LayerSolver(context_, std::move(*scene), scene_.diffuse, nullptr, watch).solve();
  if (layer) add_patches(stage + "patches:", *layer, trace_);
  return layer;
}

Status Tracer::add_images(Picture picture) {
  const std::vector<PictureItem> stack = std::move(picture.stack);
  for (std::size_t count = 1; count < stack.size(); ++count) {
    picture.stack = first_items(stack, count);
    const Result<Image> image = rasterize(context_, picture, scene_.raster);
    if (!image) return image.status();
    add_image("pixels of the first " + std::to_string(count) + " items of the stack", *image,
              trace_);
  }
  picture.stack = stack;
  const Result<Image> image = rasterize(context_, picture, scene_.raster);
  if (!image) return image.status();
  add_image("pixels", *image, trace_);
  const auto png = encode_png(context_, *image);
  if (!png) return png.status();
  trace_.push_back(numbers("png", *png, 1));
  return ok_status();
}

Status Tracer::add_pixels() {
  const Result<Image> image =
      render_pixels(context_, scene_.document, scene_.diffuse, scene_.raster);
  if (image) add_image("pixels by the gather", *image, trace_);
  return image.status();
}

}  // namespace

Result<Trace> trace_scene(Context& context, const Scene& scene) {
  return Tracer(context, scene).run();
}

}  // namespace sfumato::test
