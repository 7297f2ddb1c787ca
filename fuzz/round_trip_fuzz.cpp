// Writes a document that was read, and reads it again: first the document is the same, then the
// text.
#include <algorithm>
#include <string>
#include <utility>
#include <variant>

#include "drawn_document.hpp"
#include "fuzz.hpp"
#include "sfumato/document/document.hpp"
#include "sfumato/formats/svg/svg.hpp"
#include "sfumato/formats/svg/svg_write.hpp"

using namespace sfumato;

namespace {

std::string written(const Document& document) {
  Context context;
  Result<std::string> text = write_svg(context, document);
  fuzz::require_ok(text.status(), "a valid document cannot be written");
  return std::move(*text);
}

Document read_back(const std::string& text) {
  Context context;
  Result<ReadDocument> read = read_svg(context, text, "written.svg");
  fuzz::require_ok(read.status(), "what was written cannot be read");
  return std::move(read->document);
}

/// Removes radii that are 0 everywhere, because they are not written.
ScalarStops without_zeros(const ScalarStops& radii) {
  const bool any =
      std::ranges::any_of(radii.stops, [](const auto& stop) { return stop.value > 0; });
  return any ? radii : ScalarStops{};
}

Curve comparable(Curve curve) {
  // Ids that are not names or not unique are changed.
  curve.id.clear();
  curve.left.blur_radius = without_zeros(curve.left.blur_radius);
  curve.right.blur_radius = without_zeros(curve.right.blur_radius);
  return curve;
}

LocalCurve comparable(LocalCurve curve) {
  curve.id.clear();
  curve.blur_radius = without_zeros(curve.blur_radius);
  return curve;
}

struct SameItem {
  void operator()(const LayerInstance& a, const LayerInstance& b) const {
    fuzz::require(a.layer == b.layer && a.artboard_from_layer == b.artboard_from_layer &&
                      a.opacity == b.opacity && a.blend == b.blend,
                  "an instance changed");
  }
  void operator()(const LocalStroke& a, const LocalStroke& b) const {
    fuzz::require(comparable(a.curve) == comparable(b.curve) &&
                      a.artboard_from_stroke == b.artboard_from_stroke,
                  "a local curve changed");
  }
  void operator()(const GroupBegin& a, const GroupBegin& b) const {
    fuzz::require(a.opacity == b.opacity && a.blend == b.blend, "a group changed");
  }
  template <class A, class B>
  void operator()(const A&, const B&) const {
    fuzz::require(std::is_same_v<A, B>, "the stack changed");
  }
};

/// Layers and shaders of a document from a reader are in the order of their first use.
void require_same(const Document& a, const Document& b) {
  fuzz::require(a.artboard == b.artboard && a.interpolation == b.interpolation &&
                    a.background == b.background,
                "the artboard changed");
  fuzz::require(a.shaders.size() == b.shaders.size() && a.layers.size() == b.layers.size() &&
                    a.stack.size() == b.stack.size(),
                "something was lost or added");
  for (std::size_t i = 0; i < a.layers.size(); ++i) {
    fuzz::require(a.layers[i].curves.size() == b.layers[i].curves.size(), "a curve was lost");
    for (std::size_t k = 0; k < a.layers[i].curves.size(); ++k) {
      fuzz::require(comparable(a.layers[i].curves[k]) == comparable(b.layers[i].curves[k]),
                    "a curve changed");
    }
  }
  for (std::size_t i = 0; i < a.stack.size(); ++i) {
    std::visit(SameItem{}, a.stack[i], b.stack[i]);
  }
}

/// Orzan's reader keeps curves that are a single point and draw nothing; the SVG reader drops them.
bool all_have_length(const Document& document) {
  const auto has_length = [](const Curve& curve) {
    const Vec2 begin = curve.control_points.front();
    return std::ranges::any_of(curve.control_points, [begin](Vec2 p) { return !(p == begin); });
  };
  return std::ranges::all_of(document.layers, [&](const Layer& layer) {
    return std::ranges::all_of(layer.curves, has_length);
  });
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Context context{.budget = Budget(fuzz::kBudgetBytes)};
  const std::optional<Document> document = fuzz::drawn_document(context, {data, size});
  if (!document) return 0;
  // Writing a drawn document puts it into the readers' order, and reading it drops unused parts.
  const Document first = read_back(written(*document));
  if (fuzz::is_file({data, size}) && all_have_length(*document)) require_same(*document, first);
  const std::string text = written(first);
  const Document second = read_back(text);
  require_same(first, second);
  fuzz::require(written(second) == text, "the same document is written in two ways");
  return 0;
}
