#include "sfumato/picture/picture.hpp"

#include "picture/point_fields.hpp"

namespace sfumato {
namespace {

std::size_t bytes_of(const PatchField& field) {
  return field.triangle_node.capacity() * sizeof(std::uint32_t) +
         field.node_value.capacity() * sizeof(float);
}

}  // namespace

PointFieldsRef::PointFieldsRef(const PointFieldsRef& other) : fields_(other.fields_) {
  if (fields_) fields_->add_reference();
}

PointFieldsRef::~PointFieldsRef() {
  if (fields_) fields_->release();
}

std::size_t bytes_of(const ExactLayer& layer) {
  std::size_t bytes = layer.vertex_position.capacity() * sizeof(Vec2) +
                      layer.triangle_vertex.capacity() * sizeof(std::uint32_t) +
                      layer.field.capacity() * sizeof(ExactField);
  for (const ExactField& field : layer.field) {
    bytes += field.edge.capacity() * sizeof(RayEdge) + field.side.capacity() * sizeof(ExactSide) +
             field.end.capacity() * sizeof(ExactEnd);
  }
  return bytes;
}

std::size_t bytes_of(const PatchLayer& layer) {
  return bytes_of(layer.exact) + layer.vertex_position.capacity() * sizeof(Vec2) +
         layer.triangle_vertex.capacity() * sizeof(std::uint32_t) + layer.edge_is_curve.capacity() +
         layer.soft_edge.capacity() * sizeof(SoftEdge) + layer.bow.capacity() * sizeof(CurveBow) +
         bytes_of(layer.color) + bytes_of(layer.opacity) +
         (layer.exact_points ? layer.exact_points->bytes() : 0);
}

std::size_t bytes_of(const Picture& picture) {
  std::size_t bytes = bytes_of(picture.shaders) + picture.stack.capacity() * sizeof(PictureItem);
  for (const PatchLayer& layer : picture.layers) bytes += bytes_of(layer);
  for (const PictureItem& item : picture.stack) {
    if (const auto* stroke = std::get_if<LocalStroke>(&item)) bytes += bytes_of(stroke->curve);
  }
  return bytes;
}

}  // namespace sfumato
