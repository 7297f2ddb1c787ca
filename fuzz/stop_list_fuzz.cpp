// Lists of colour stops and of numbers, and where they come to lie on a curve.
#include <cmath>
#include <vector>

#include "formats/svg/stop_list.hpp"
#include "fuzz.hpp"
#include "sfumato/base/limits.hpp"

using namespace sfumato;

namespace {

template <class Value>
void check(const Result<std::vector<svg::WrittenStop<Value>>>& written, std::string_view text) {
  if (!written) return fuzz::require_honest(written.status());
  fuzz::require(!written->empty(), "a list without a stop");
  fuzz::require(written->size() <= svg::stop_bound(text), "more stops than were foreseen");
  // Three segments of one, four and two pieces, as arcs have them.
  static constexpr std::uint32_t kSegmentBegin[] = {0, 1, 5, 7};
  bool beyond_end = false;
  const StopList<Value> placed = svg::place_stops<Value>(*written, kSegmentBegin, beyond_end);
  const double end = placed.space == StopSpace::parameter ? 7 : 1;
  double last = 0;
  for (const Stop<Value>& stop : placed.stops) {
    fuzz::require(stop.offset >= last && stop.offset <= end, "an offset out of order");
    last = stop.offset;
  }
  fuzz::require(placed.stops.size() == written->size(), "a stop is lost");
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text = fuzz::as_text({data, size});
  css::TextPoll poll;
  const auto colors = svg::parse_color_stops(text, poll);
  check(colors, text);
  const auto radii = svg::parse_scalar_stops(text, limits::kCoordinate, "a radius", poll);
  check(radii, text);
  if (radii) {
    for (const auto& stop : *radii) {
      fuzz::require(stop.value >= 0 && stop.value <= limits::kCoordinate, "a radius out of range");
    }
  }
  if (colors) {
    for (const auto& stop : *colors) {
      const auto is_share = [](float x) { return x >= 0 && x <= 1; };
      fuzz::require(is_share(stop.value.r) && is_share(stop.value.g) && is_share(stop.value.b),
                    "a colour out of range");
    }
  }
  return 0;
}
