#include "raster/coverage/painted_edge.hpp"

#include <algorithm>
#include <cmath>
#include <variant>
#include <vector>

namespace sfumato::raster {
namespace {

/// Returns the same in the layer's frame.
double margin_of(const PatchLayer& layer) {
  double margin = 0;
  for (const SoftEdge& edge : layer.soft_edge)
    margin = std::max({margin, length(edge.reach[0]), length(edge.reach[1])});
  for (const CurveBow& bow : layer.bow)
    for (const float height : bow.height) margin = std::max(margin, double{std::fabs(height)});
  return margin;
}

}  // namespace

double edge_margin_px(const Picture& picture, const Affine& image_from_artboard) {
  std::vector<double> margin;
  for (const PatchLayer& layer : picture.layers) margin.push_back(margin_of(layer));
  double most = 0;
  for (const PictureItem& item : picture.stack) {
    const auto* instance = std::get_if<PatchInstance>(&item);
    if (!instance || margin[instance->layer] == 0) continue;
    const Affine m = image_from_artboard * instance->artboard_from_layer;
    const double scale = std::sqrt(m.a * m.a + m.b * m.b + m.c * m.c + m.d * m.d);
    most = std::max(most, std::min(margin[instance->layer] * scale, kMostReachPx));
  }
  return most;
}

}  // namespace sfumato::raster
