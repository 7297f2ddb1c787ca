#include "capi/documents/revisions.hpp"

#include <variant>

#include "base/table_memory.hpp"

namespace sfumato::capi {

Revisions revisions_of(const Document& document) {
  Revisions revisions{std::make_shared<const char>('\0'), 1, 1, {}};
  revisions.curves.reserve(document.layers.size());
  for (const Layer& layer : document.layers)
    revisions.curves.emplace_back(layer.curves.size(), revisions.last);
  return revisions;
}

std::size_t bytes_of(const Revisions& revisions) {
  std::size_t bytes = capacity_bytes(revisions.curves);
  for (const std::vector<std::uint64_t>& layer : revisions.curves) bytes += capacity_bytes(layer);
  return bytes;
}

void make_room(const Change& change, Revisions& revisions) {
  const auto* insert = std::get_if<InsertCurve>(&change);
  if (!insert || insert->layer >= revisions.curves.size()) return;
  std::vector<std::uint64_t>& layer = revisions.curves[insert->layer];
  if (layer.size() == layer.capacity()) layer.reserve(2 * layer.size() + 1);
}

void note(const Change& inverse, Revisions& revisions) {
  const auto place_of = [&](const auto& change) {
    return revisions.curves[change.layer].begin() + change.curve;
  };
  ++revisions.last;
  if (const auto* replaced = std::get_if<ReplaceCurve>(&inverse)) {
    *place_of(*replaced) = revisions.last;
    return;
  }
  revisions.frame = revisions.last;
  if (const auto* inserted = std::get_if<RemoveCurve>(&inverse)) {
    revisions.curves[inserted->layer].insert(place_of(*inserted), revisions.last);
  } else if (const auto* removed = std::get_if<InsertCurve>(&inverse)) {
    revisions.curves[removed->layer].erase(place_of(*removed));
  }
}

std::optional<std::vector<LayerCurves>> changed_curves(const Revisions& from, const Revisions& to) {
  if (!from.document || from.document != to.document || from.frame != to.frame) {
    return std::nullopt;
  }
  std::vector<LayerCurves> changed;
  for (std::uint32_t layer = 0; layer < to.curves.size(); ++layer) {
    LayerCurves list{layer, {}};
    for (std::uint32_t curve = 0; curve < to.curves[layer].size(); ++curve) {
      if (from.curves[layer][curve] != to.curves[layer][curve]) list.curves.push_back(curve);
    }
    if (!list.curves.empty()) changed.push_back(std::move(list));
  }
  return changed;
}

}  // namespace sfumato::capi
