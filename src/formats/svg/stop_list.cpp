#include "formats/svg/stop_list.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "base/limits.hpp"
#include "formats/css_color.hpp"
#include "formats/css_text.hpp"
#include "formats/number.hpp"
#include "formats/suggestion.hpp"

namespace sfumato::svg {
namespace {

Status bad(std::string message) {
  return make_error(StatusCode::bad_input, std::move(message));
}

/// Cuts at the first blank that is in no parentheses: what stands before and behind, trimmed.
std::string_view take_token(std::string_view& text) {
  std::size_t open = 0, i = 0;
  for (; i < text.size(); ++i) {
    if (text[i] == '(') ++open;
    if (text[i] == ')') open -= open > 0;
    if (open == 0 && is_css_blank(text[i])) break;
  }
  const std::string_view token = text.substr(0, i);
  text = css_trimmed(text.substr(i));
  return token;
}

template <class Value>
Status parse_offset(std::string_view text, WrittenStop<Value>& stop) {
  std::optional<double> number;
  if (text.starts_with('@')) {
    number = parse_number(text.substr(1));
    stop.unit = OffsetUnit::segment;
    stop.offset = number.value_or(0);
    if (number && stop.offset >= 0 && stop.offset <= limits::kCoordinate) return ok_status();
  } else if (text.ends_with('%')) {
    number = parse_number(text.substr(0, text.size() - 1));
    stop.unit = OffsetUnit::percent;
    stop.offset = number.value_or(0) / 100;
    if (number && stop.offset >= 0 && stop.offset <= 1) return ok_status();
  }
  return bad("the offset " + quoted(text) +
             " is none; expected 0% to 100% of the length, or @ and a segment like @2.5");
}

template <class Value, class ParseValue>
Result<std::vector<WrittenStop<Value>>> parse_stops(std::string_view text, ParseValue parse_value) {
  std::vector<WrittenStop<Value>> stops;
  stops.reserve(stop_bound(text));
  text = css_trimmed(text);
  if (text.empty()) return bad("is empty; expected a list of stops");
  if (text.back() == ',') return bad("a stop is missing beside a comma");
  while (!text.empty()) {
    std::string_view item = css_trimmed(take_until(text, ','));
    if (item.empty()) return bad("a stop is missing beside a comma");
    WrittenStop<Value>& stop = stops.emplace_back();
    if (Status status = parse_value(take_token(item), stop.value); !status) return status;
    if (item.empty()) continue;
    const std::string_view offset = take_token(item);
    if (Status status = parse_offset(offset, stop); !status) return status;
    if (!item.empty()) {
      return bad(quoted(item) + " follows the offset " + quoted(offset) + "; expected a comma");
    }
  }
  return stops;
}

Status parse_opaque(std::string_view text, Rgb& color) {
  if (text == "none" || text.starts_with("url(")) {
    return bad(quoted(text) + " is no stop; expected it alone, without other stops and offsets");
  }
  const Result<CssColor> parsed = parse_css_color(text);
  if (!parsed) return parsed.status();
  if (parsed->alpha < 1) {
    return bad("the colour " + quoted(text) +
               " is not opaque; expected an opaque colour, and sf:left-opacity, sf:right-opacity "
               "or sf:opacity for the opacity");
  }
  color = parsed->color;
  return ok_status();
}

/// CSS Images 3, section 3.4.3, on offsets in one unit from 0 to `end`. Missing ones are NaN.
template <class Value>
void spread(std::vector<Stop<Value>>& stops, double end) {
  if (std::isnan(stops.front().offset)) stops.front().offset = 0;
  if (std::isnan(stops.back().offset)) stops.back().offset = end;
  double largest = 0;
  std::size_t last = 0;  // the last stop with an offset
  for (std::size_t i = 0; i < stops.size(); ++i) {
    if (std::isnan(stops[i].offset)) continue;
    stops[i].offset = largest = std::max(largest, stops[i].offset);
    const double begin = stops[last].offset;
    const double step =
        (stops[i].offset - begin) / static_cast<double>(std::max<std::size_t>(i - last, 1));
    for (std::size_t j = last + 1; j < i; ++j) {
      stops[j].offset = std::min(begin + step * static_cast<double>(j - last), stops[i].offset);
    }
    last = i;
  }
}

/// From segments to pieces: piece i of a subpath at t is i + t.
double piece_parameter(double segments, std::span<const std::uint32_t> segment_begin) {
  const std::size_t segment_count = segment_begin.size() - 1;
  const double whole = std::floor(segments);
  const auto segment = static_cast<std::size_t>(whole);
  if (segment >= segment_count) return segment_begin.back();
  const double pieces = segment_begin[segment + 1] - segment_begin[segment];
  return segment_begin[segment] + (segments - whole) * pieces;
}

}  // namespace

Result<std::vector<WrittenStop<Rgb>>> parse_color_stops(std::string_view text) {
  return parse_stops<Rgb>(text, parse_opaque);
}

Result<std::vector<WrittenStop<float>>> parse_scalar_stops(std::string_view text, double largest,
                                                           std::string_view what) {
  const auto parse_value = [largest, what](std::string_view token, float& value) {
    const std::optional<double> number = parse_number(token);
    if (!number || !(*number >= 0 && *number <= largest)) {
      return bad(quoted(token) + " is no " + std::string(what) + "; expected a number from 0 to " +
                 std::to_string(static_cast<long>(largest)));
    }
    value = static_cast<float>(*number);
    return ok_status();
  };
  return parse_stops<float>(text, parse_value);
}

std::size_t stop_bound(std::string_view text) {
  return static_cast<std::size_t>(std::ranges::count(text, ',')) + 1;
}

template <class Value>
StopList<Value> place_stops(const std::vector<WrittenStop<Value>>& written,
                            std::span<const std::uint32_t> segment_begin, bool& beyond_end) {
  StopList<Value> list;
  const auto has_segments = [](const WrittenStop<Value>& stop) {
    return stop.unit == OffsetUnit::segment;
  };
  const bool in_parameter = std::ranges::any_of(written, has_segments);
  list.space = in_parameter ? StopSpace::parameter : StopSpace::arc_length;
  const double end = in_parameter ? static_cast<double>(segment_begin.size() - 1) : 1;
  list.stops.reserve(written.size());
  for (const WrittenStop<Value>& stop : written) {
    const double offset = stop.unit == OffsetUnit::percent ? stop.offset * end : stop.offset;
    beyond_end |= stop.unit != OffsetUnit::none && offset > end;
    const bool has_offset = stop.unit != OffsetUnit::none;
    list.stops.push_back({has_offset ? std::min(offset, end) : std::nan(""), stop.value});
  }
  spread(list.stops, end);
  if (!in_parameter) return list;
  for (Stop<Value>& stop : list.stops) stop.offset = piece_parameter(stop.offset, segment_begin);
  return list;
}

template StopList<Rgb> place_stops(const std::vector<WrittenStop<Rgb>>&,
                                   std::span<const std::uint32_t>, bool&);
template StopList<float> place_stops(const std::vector<WrittenStop<float>>&,
                                     std::span<const std::uint32_t>, bool&);

}  // namespace sfumato::svg
