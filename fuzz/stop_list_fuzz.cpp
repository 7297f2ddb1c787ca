// Lists of colour stops and of numbers, and their places on a curve.
#include <cmath>
#include <vector>

#include "formats/svg/paint/stop_list.hpp"
#include "fuzz.hpp"
#include "sfumato/base/limits.hpp"

using namespace sfumato;

namespace {

template <class Value>
void check(const Status& parsed, const std::vector<svg::WrittenStop<Value>>& written,
           std::string_view text) {
  fuzz::require(written.size() <= svg::stop_bound(text), "more stops than were foreseen");
  if (!parsed) return fuzz::require_honest(parsed);
  fuzz::require(!written.empty(), "a list without a stop");
  // Three segments of one, four and two pieces, as arcs make them.
  static constexpr std::uint32_t kSegmentBegin[] = {0, 1, 5, 7};
  bool beyond_end = false;
  StopList<Value> placed;
  svg::place_stops<Value>(written, kSegmentBegin, placed, beyond_end);
  const double end = placed.space == StopSpace::parameter ? 7 : 1;
  double last = 0;
  for (const Stop<Value>& stop : placed.stops) {
    fuzz::require(stop.offset >= last && stop.offset <= end, "an offset out of order");
    last = stop.offset;
  }
  fuzz::require(placed.stops.size() == written.size(), "a stop is lost");
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text = fuzz::as_text({data, size});
  css::TextPoll poll;
  std::vector<svg::WrittenStop<Rgb>> colors;
  std::string_view mapped;
  const Status has_colors = svg::parse_color_stops(text, poll, colors, mapped);
  fuzz::require(mapped.empty() || text.find(mapped) != text.npos, "a colour from nowhere");
  check(has_colors, colors, text);
  std::vector<svg::WrittenStop<float>> radii;
  const Status has_radii =
      svg::parse_scalar_stops(text, limits::kCoordinate, "a radius", poll, radii);
  check(has_radii, radii, text);
  if (has_radii) {
    for (const auto& stop : radii) {
      fuzz::require(stop.value >= 0 && stop.value <= limits::kCoordinate, "a radius out of range");
    }
  }
  if (has_colors) {
    for (const auto& stop : colors) {
      const auto is_share = [](float x) { return x >= 0 && x <= 1; };
      fuzz::require(is_share(stop.value.r) && is_share(stop.value.g) && is_share(stop.value.b),
                    "a colour out of range");
    }
  }
  return 0;
}
