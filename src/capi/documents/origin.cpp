#include "capi/documents/origin.hpp"

#include <cstdint>
#include <variant>

#include "base/table_memory.hpp"

namespace sfumato::capi {
namespace {

/// Returns the sources of a layer's curves; null if they are not known.
std::vector<CurveSource>* sources_of(Origin& origin, std::uint32_t layer) {
  return layer < origin.curves.size() ? &origin.curves[layer] : nullptr;
}

}  // namespace

std::size_t bytes_of(const Origin& origin) {
  std::size_t bytes = capacity_bytes(origin.name, origin.curves);
  for (const std::vector<CurveSource>& layer : origin.curves) bytes += capacity_bytes(layer);
  return bytes;
}

void make_room(Origin& origin, const Change& change) {
  const auto* insert = std::get_if<InsertCurve>(&change);
  std::vector<CurveSource>* sources = insert ? sources_of(origin, insert->layer) : nullptr;
  if (sources && sources->size() == sources->capacity()) sources->reserve(2 * sources->size() + 1);
}

void follow(Origin& origin, const Change& inverse) {
  if (const auto* inserted = std::get_if<RemoveCurve>(&inverse)) {
    std::vector<CurveSource>* sources = sources_of(origin, inserted->layer);
    if (sources) sources->insert(sources->begin() + inserted->curve, CurveSource{});
  } else if (const auto* removed = std::get_if<InsertCurve>(&inverse)) {
    std::vector<CurveSource>* sources = sources_of(origin, removed->layer);
    if (sources) sources->erase(sources->begin() + removed->curve);
  }
}

}  // namespace sfumato::capi
