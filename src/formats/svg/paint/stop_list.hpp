#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "formats/css/tokenizer.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/document/stops.hpp"

namespace sfumato::svg {

/// How the offset of a stop was written.
enum class OffsetUnit : std::uint8_t {
  none,     ///< left out
  percent,  ///< 40%: `offset` is 0.4
  segment   ///< @2.5: `offset` is 2.5
};

/// A stop before it is applied to a subpath.
template <class Value>
struct WrittenStop {
  Value value{};
  double offset = 0;
  OffsetUnit unit = OffsetUnit::none;
};

/// Reads `value [offset]? (, value [offset]?)*` with CSS colours into `stops`, which must be empty
/// and have room for stop_bound(text). Colours that are not opaque are errors. Errors: bad_input,
/// without a place; as the poll.
///
/// mapped    becomes the text of the first colour outside sRGB, if there is one
Status parse_color_stops(std::string_view text, css::TextPoll& poll,
                         std::vector<WrittenStop<Rgb>>& stops, std::string_view& mapped);

/// Reads a list of numbers from 0 to `largest` in the same way. `what` names them in messages:
/// "opacity".
Status parse_scalar_stops(std::string_view text, double largest, std::string_view what,
                          css::TextPoll& poll, std::vector<WrittenStop<float>>& stops);

/// The same with lengths of 0 or more, in user units.
Status parse_length_stops(std::string_view text, std::string_view what, css::TextPoll& poll,
                          std::vector<WrittenStop<float>>& stops);

/// "; did you mean 0.4?" for 40% if a number up to `largest` is expected; else empty.
std::string share_hint(std::string_view text, double largest);

/// Returns an upper bound of the number of stops in the text.
std::size_t stop_bound(std::string_view text);

/// Applies the list to a subpath and stores it in `list`, which must be empty and have room for all
/// stops. Offsets are spread and ordered as in CSS; they are curve parameters if any is written
/// with @, else arc lengths. Offsets beyond the end are moved to it, and `beyond_end` becomes true.
template <class Value>
void place_stops(std::span<const WrittenStop<Value>> written,
                 std::span<const std::uint32_t> segment_begin, StopList<Value>& list,
                 bool& beyond_end);

}  // namespace sfumato::svg
