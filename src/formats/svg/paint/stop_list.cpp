#include "formats/svg/paint/stop_list.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "base/text/number.hpp"
#include "base/text/number_text.hpp"
#include "base/try.hpp"
#include "formats/css/color.hpp"
#include "formats/svg/style/length.hpp"
#include "formats/text/suggestion.hpp"
#include "sfumato/base/limits.hpp"

namespace sfumato::svg {
namespace {

/// The length of a faulty offset that is examined for a hint.
constexpr std::size_t kLongestHint = 64;

Status bad(std::string message) {
  return make_error(StatusCode::bad_input, std::move(message));
}

/// The text between two commas: values with blanks or comments between them.
struct Item {
  std::array<std::string_view, 3> part{};
  std::size_t count = 0;  ///< of parts; the third holds the rest if there are more than three
  bool has_comma = false;
};

Item take_item(css::Tokenizer& tokens) {
  Item item;
  bool is_new = true;
  for (;;) {
    const css::Token token = tokens.next();
    item.has_comma = token.is(css::TokenType::comma);
    if (item.has_comma || token.is(css::TokenType::end)) return item;
    if (token.is(css::TokenType::whitespace)) {
      is_new = true;
      continue;
    }
    skip_component(tokens, token);
    const char* behind = tokens.text().data() + tokens.position();
    std::string_view& last = item.part[std::max<std::size_t>(item.count, 1) - 1];
    // A comment parts values as a blank does.
    is_new |= item.count > 0 && last.data() + last.size() != token.text.data();
    if (is_new && item.count < item.part.size()) {
      item.part[item.count++] = {token.text.data(), behind};
    } else {
      last = {last.data(), behind};
    }
    is_new = false;
  }
}

/// Returns a hint at the offset that was probably meant.
template <class ParseValue>
std::string offset_hint(std::string_view text, std::string_view value, ParseValue is_value) {
  const std::optional<double> number = parse_number(text);
  if (number && *number >= 0 && *number <= 100) {
    const double percent = *number <= 1 ? 100 * *number : *number;
    return "; did you mean " + rounded_number_text(percent, 4) + "%?";
  }
  if (!is_value(text)) return {};
  return "; did you mean " + text::quoted(std::string(value) + ", " + std::string(text)) + "?";
}

template <class Value>
bool parse_offset(std::string_view text, WrittenStop<Value>& stop) {
  std::optional<double> number;
  if (text.starts_with('@')) {
    number = parse_number(text.substr(1));
    stop.unit = OffsetUnit::segment;
    stop.offset = number.value_or(0);
    return number && stop.offset >= 0 && stop.offset <= limits::kCoordinate;
  }
  if (!text.ends_with('%')) return false;
  number = parse_number(text.substr(0, text.size() - 1));
  stop.unit = OffsetUnit::percent;
  stop.offset = number.value_or(0) / 100;
  return number && stop.offset >= 0 && stop.offset <= 1;
}

template <class Value, class ParseValue>
Status parse_item(const Item& item, WrittenStop<Value>& stop, ParseValue parse_value) {
  if (item.count == 0) return bad("a stop is missing beside a comma");
  SFUMATO_TRY(parse_value(item.part[0], stop.value));
  if (item.count == 1) return ok_status();
  const std::string_view offset = item.part[1];
  if (!parse_offset(offset, stop)) {
    const auto is_value = [&](std::string_view text) {
      Value ignored{};
      return text.size() <= kLongestHint && parse_value(text, ignored).ok();
    };
    return bad("the offset " + text::quoted(offset) +
               " is none; use 0% to 100% of the length, or @ and a segment like @2.5" +
               offset_hint(offset.substr(0, kLongestHint), item.part[0], is_value));
  }
  if (item.count == 2) return ok_status();
  return bad(text::quoted(item.part[2]) + " follows the offset " + text::quoted(offset) +
             "; use a comma");
}

template <class Value, class ParseValue>
Status parse_stops(std::string_view text, css::TextPoll& poll, ParseValue parse_value,
                   std::vector<WrittenStop<Value>>& stops) {
  css::Tokenizer tokens(text, poll);
  for (bool goes_on = true; goes_on;) {
    const Item item = take_item(tokens);
    SFUMATO_TRY(poll.status());
    goes_on = item.has_comma;
    if (!goes_on && item.count == 0 && stops.empty()) return bad("is empty; use a list of stops");
    SFUMATO_TRY(parse_item(item, stops.emplace_back(), parse_value));
  }
  return ok_status();
}

/// Returns whether the text is a value that a side can have instead of a list.
bool is_no_list(std::string_view text, css::TextPoll& poll) {
  css::Tokenizer tokens(text, poll);
  const css::Token first = tokens.next();
  if (first.is(css::TokenType::ident)) return css::is_named(first.value, "none");
  return first.is(css::TokenType::url) || first.is(css::TokenType::bad_url) ||
         (first.is(css::TokenType::function) && css::is_named(first.value, "url"));
}

Status parse_opaque(std::string_view text, css::TextPoll& poll, Rgb& color,
                    std::string_view& mapped) {
  const Result<css::Color> parsed = css::parse_color(text, poll);
  if (!parsed && is_no_list(text, poll)) {
    return bad(text::quoted(text) +
               " is not a stop; use it alone, without other stops and offsets");
  }
  SFUMATO_TRY(parsed);
  if (parsed->alpha < 1) {
    return bad("the colour " + text::quoted(text) +
               " is not opaque; use an opaque colour, and sf:left-opacity, sf:right-opacity "
               "or sf:opacity for the opacity");
  }
  color = parsed->color;
  if (parsed->is_mapped && mapped.empty()) mapped = text;
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

std::string share_hint(std::string_view text, double largest) {
  text = text.substr(0, kLongestHint);
  if (!text.ends_with('%')) return {};
  const std::optional<double> percent = parse_number(text.substr(0, text.size() - 1));
  if (!percent || !(*percent >= 0 && *percent / 100 <= largest)) return {};
  return "; did you mean " + rounded_number_text(*percent / 100, 6) + "?";
}

Status parse_color_stops(std::string_view text, css::TextPoll& poll,
                         std::vector<WrittenStop<Rgb>>& stops, std::string_view& mapped) {
  const auto parse_value = [&](std::string_view value, Rgb& color) {
    return parse_opaque(value, poll, color, mapped);
  };
  return parse_stops(text, poll, parse_value, stops);
}

Status parse_scalar_stops(std::string_view text, double largest, std::string_view what,
                          css::TextPoll& poll, std::vector<WrittenStop<float>>& stops) {
  const auto parse_value = [largest, what](std::string_view token, float& value) {
    const std::optional<double> number = parse_number(token);
    if (!number || !(*number >= 0 && *number <= largest)) {
      return bad(text::quoted(token) + " is not a valid " + std::string(what) +
                 "; use a number from 0 to " + std::to_string(static_cast<long>(largest)) +
                 share_hint(token, largest));
    }
    value = static_cast<float>(*number);
    return ok_status();
  };
  return parse_stops(text, poll, parse_value, stops);
}

Status parse_length_stops(std::string_view text, std::string_view what, css::TextPoll& poll,
                          std::vector<WrittenStop<float>>& stops) {
  const auto parse_value = [what](std::string_view token, float& value) {
    static constexpr Box kNone{{0, 0}, {1, 1}};
    const bool is_share = token.ends_with('%');
    const Result<double> length = is_share ? bad({}) : parse_length(token, kNone, Axis::x);
    if (!length || *length < 0) {
      const bool has_unit = is_digit(token.front()) && !is_digit(token.back());
      return bad(text::quoted(token) + " is not a valid " + std::string(what) +
                 "; use a number from 0 to " +
                 std::to_string(static_cast<long>(limits::kCoordinate)) +
                 (has_unit ? ", perhaps with px, pt, pc, mm, cm or in" : ""));
    }
    value = static_cast<float>(*length);
    return ok_status();
  };
  return parse_stops(text, poll, parse_value, stops);
}

std::size_t stop_bound(std::string_view text) {
  return static_cast<std::size_t>(std::ranges::count(text, ',')) + 1;
}

template <class Value>
void place_stops(std::span<const WrittenStop<Value>> written,
                 std::span<const std::uint32_t> segment_begin, StopList<Value>& list,
                 bool& beyond_end) {
  const auto has_segments = [](const WrittenStop<Value>& stop) {
    return stop.unit == OffsetUnit::segment;
  };
  const bool in_parameter = std::ranges::any_of(written, has_segments);
  list.space = in_parameter ? StopSpace::parameter : StopSpace::arc_length;
  const double end = in_parameter ? static_cast<double>(segment_begin.size() - 1) : 1;
  for (const WrittenStop<Value>& stop : written) {
    const double offset = stop.unit == OffsetUnit::percent ? stop.offset * end : stop.offset;
    beyond_end |= stop.unit != OffsetUnit::none && offset > end;
    const bool has_offset = stop.unit != OffsetUnit::none;
    list.stops.push_back({has_offset ? std::min(offset, end) : std::nan(""), stop.value});
  }
  spread(list.stops, end);
  if (!in_parameter) return;
  for (Stop<Value>& stop : list.stops) stop.offset = piece_parameter(stop.offset, segment_begin);
}

template void place_stops(std::span<const WrittenStop<Rgb>>, std::span<const std::uint32_t>,
                          StopList<Rgb>&, bool&);
template void place_stops(std::span<const WrittenStop<float>>, std::span<const std::uint32_t>,
                          StopList<float>&, bool&);

}  // namespace sfumato::svg
