#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
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
  double blur_radius = 0;
};

/// A region as layers keep it to compare others with it.
struct Outline {
  std::vector<Chord> chords;
  Box box;
  SideShader<Rgb> color;
  bool is_opaque = true;
  TableMemory memory{"the shapes"};
};

/// Errors: limit (memory), cancelled.
Result<Outline> outline_of(Context& context, const Region& region, double tolerance);

/// The relation of a region to the regions of a layer below it.
struct Fit {
  enum class Kind : std::uint8_t {
    apart,   ///< it meets none of them: either may be painted first
    on_one,  ///< it lies wholly on one of them, which is in sight around it and opaque, as it is
    covers   ///< anything else: the region must be painted later, in another layer
  };
  Kind kind = Kind::apart;
  std::size_t ground = 0;  ///< on_one: the index of the region below
};

/// The curves of one layer while regions are painted into it.
class PaintedLayer {
 public:
  explicit PaintedLayer(double tolerance) : tolerance_(tolerance) {}

  /// Compares a region with the regions of the layer.
  /// steps    the comparisons of chords that are left; if they do not suffice, the answer is
  ///          `covers`
  /// Errors   limit (memory), cancelled.
  Result<Fit> look(Context& context, const Outline& outline, std::size_t& steps) const;
  /// Returns whether the layer has room for the region's paint.
  bool has_room() const { return shaders_.size() < kShaders && opacity_shaders_.size() < kShaders; }
  /// Paints a region that is apart or on one. Errors: limit (memory), cancelled.
  Status add(Context& context, const Region& region, Outline outline, const Fit& fit);

  std::vector<Curve> take_curves(TableMemory& memory) {
    memory.take(std::move(memory_));
    return std::move(curves_);
  }

 private:
  /// The most image-domain shaders in one layer; as many again are opacities of gradients and
  /// masks.
  static constexpr std::size_t kShaders = 16;

  Result<bool> keeps_apart(Context& context, const Outline& a, const Outline& b,
                           std::size_t& steps) const;
  Result<Fit> ground_of(const Context& context, const Outline& outline, std::size_t& steps) const;

  double tolerance_;
  TableMemory outline_memory_{"the shapes"}, memory_{"the curves"};
  std::vector<Outline> outlines_;
  std::vector<Curve> curves_;
  std::vector<std::uint32_t> shaders_, opacity_shaders_;
};

}  // namespace sfumato::svg_import
