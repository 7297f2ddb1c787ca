#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/table_memory.hpp"
#include "import/boundary.hpp"
#include "import/chords.hpp"
#include "sfumato/base/box.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/document/document.hpp"

namespace sfumato::svg_import {

/// A region of one paint, artboard frame.
struct Region {
  std::string id;
  Contours boundary;  ///< inside on the right
  SideShader<Rgb> color;
  SideShader<float> opacity;  ///< opacity of the inside
  bool is_opaque = true;
};

/// The curves of one layer while shapes are painted into it, each over the previous ones.
class PaintedLayer {
 public:
  explicit PaintedLayer(double tolerance) : tolerance_(tolerance) {}

  /// Paints the region if the layer can show it unchanged: it covers no other region, and lies
  /// either wholly on one visible opaque region of the layer or outside of all regions. False:
  /// nothing has changed.
  /// Errors: limit (memory), cancelled.
  Result<bool> try_add(Context& context, const Region& region);
  /// Paints the first region. Errors: as above.
  Status add(Context& context, const Region& region);

  std::vector<Curve> take_curves(TableMemory& memory) {
    memory.take(std::move(memory_));
    return std::move(curves_);
  }
  std::size_t shader_count() const { return shaders_.size(); }

 private:
  struct Shape {
    std::vector<Chord> chords;
    Box box;
    SideShader<Rgb> color;
    bool is_opaque = true;
    TableMemory memory{"the shapes"};
  };

  Result<Shape> shape_of(Context& context, const Region& region) const;
  Result<bool> keeps_apart(Context& context, const Shape& a, const Shape& b);
  const Shape* under(const Shape& shape) const;
  Status append(Context& context, const Region& region, Shape shape, const Shape* under);
  bool is_within(const Shape& shape, Vec2 point) const;
  void note_shader(const SideShader<Rgb>& side);

  double tolerance_;
  TableMemory shape_memory_{"the shapes"}, memory_{"the curves"};
  std::vector<Shape> shapes_;
  std::vector<Curve> curves_;
  std::vector<std::uint32_t> shaders_;
};

}  // namespace sfumato::svg_import
