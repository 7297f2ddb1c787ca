#pragma once

#include <map>
#include <string_view>
#include <tuple>
#include <unordered_set>
#include <utility>
#include <vector>

#include "formats/svg/input.hpp"
#include "formats/svg/texture_files.hpp"
#include "formats/svg/totals.hpp"
#include "sfumato/base/affine.hpp"
#include "sfumato/base/box.hpp"
#include "sfumato/document/shader.hpp"
#include "sfumato/formats/text/reading.hpp"

namespace sfumato::svg {

/// The shape that a paint is for.
struct PaintedShape {
  Element element;  ///< named in errors of the paint that concern the shape
  Affine layer_from_user;
  Box bounds;  ///< user space; used for objectBoundingBox
};

/// The stops of the gradient that was read last, kept because one gradient becomes many for the
/// bounding boxes of many shapes.
struct GradientStops {
  Element parent;  ///< null: none yet
  TableMemory memory{"stops"};
  std::vector<GradientStop> stops{};
};

/// Turns paint servers into shaders of the document. All shapes that use the same paint in the same
/// place share one shader.
class Paints {
 public:
  /// The paint, its frame and the period of its texture.
  using Key =
      std::tuple<const void*, double, double, double, double, double, double, double, double>;

  Paints(Input& input, Totals& totals, const Box& viewport, const ResourceLoader* loader)
      : input_(input), totals_(totals), viewport_(viewport), files_(input, loader) {}

  /// The index of the shader for url(#id). Errors: bad_input, limit.
  Result<std::uint32_t> shader(const PaintedShape& shape, std::string_view id);

  /// Whether a curve refers to the paint, directly or through another paint's href.
  bool is_used(Element paint) const { return used_.contains(paint.internal_object()); }

  std::vector<Shader> take() { return std::move(shaders_); }

 private:
  void note_use(Element paint);
  Result<std::uint32_t> gradient(const PaintedShape& shape, Element paint);
  Result<std::uint32_t> pattern(const PaintedShape& shape, Element paint);
  Result<std::uint32_t> add(const Key& key, Element paint, Shader shader);

  Input& input_;
  Totals& totals_;
  const Box& viewport_;
  TextureFiles files_;
  std::vector<Shader> shaders_;
  std::map<Key, std::uint32_t> known_;
  std::unordered_set<const void*> used_;
  GradientStops last_stops_;
};

}  // namespace sfumato::svg
