#include "formats/svg/shapes/view_box.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "base/text/ascii.hpp"
#include "base/try.hpp"
#include "formats/svg/read/scanner.hpp"
#include "formats/text/suggestion.hpp"

namespace sfumato::svg {
namespace {

constexpr std::array<std::string_view, 3> kAlignments{"min", "mid", "max"};

/// Returns 0, ½ or 1; below 0 if the word is not valid.
double alignment(std::string_view word) {
  const auto found = std::ranges::find(kAlignments, word);
  return found == kAlignments.end() ? -1 : 0.5 * static_cast<double>(found - kAlignments.begin());
}

Status bad_ratio(std::string_view text) {
  return make_error(
      StatusCode::bad_input,
      text::quoted(text) + "; use none, or xMidYMid and the like, then meet or slice");
}

}  // namespace

Result<Box> parse_view_box(std::string_view text) {
  Scanner scanner(text);
  std::array<double, 4> number{};
  scanner.skip_blanks();
  for (double& value : number) {
    SFUMATO_TRY(scanner.take_number(value));
    scanner.skip_separator();
  }
  if (!scanner.at_end()) return scanner.error("the end");
  const auto [x, y, width, height] = number;
  if (!(width > 0 && height > 0)) {
    return make_error(StatusCode::bad_input,
                      "the box has no area; use x, y, width and height "
                      "with a width and height above 0");
  }
  return Box{{x, y}, {x + width, y + height}};
}

Result<AspectRatio> parse_aspect_ratio(std::string_view text) {
  const std::string lower = ascii_lower(ascii_trimmed(text));
  std::string_view rest = lower;
  if (rest.starts_with("defer ")) rest = ascii_trimmed(rest.substr(6));
  const std::string_view align = rest.substr(0, std::min(rest.find(' '), rest.size()));
  const std::string_view how = ascii_trimmed(rest.substr(align.size()));
  if (align == "none") return AspectRatio{AspectRatio::Fit::stretch, 0, 0};
  if (align.size() != 8 || align[0] != 'x' || align[4] != 'y') return bad_ratio(text);
  AspectRatio ratio{AspectRatio::Fit::meet, alignment(align.substr(1, 3)),
                    alignment(align.substr(5, 3))};
  if (how == "slice") ratio.fit = AspectRatio::Fit::slice;
  if (ratio.align_x < 0 || ratio.align_y < 0 || (!how.empty() && how != "meet" && how != "slice")) {
    return bad_ratio(text);
  }
  return ratio;
}

Affine fit(const Box& content, const Box& target, const AspectRatio& ratio) {
  Vec2 scale{target.width() / content.width(), target.height() / content.height()};
  if (ratio.fit == AspectRatio::Fit::meet) scale.x = scale.y = std::min(scale.x, scale.y);
  if (ratio.fit == AspectRatio::Fit::slice) scale.x = scale.y = std::max(scale.x, scale.y);
  const double spare_x = target.width() - scale.x * content.width();
  const double spare_y = target.height() - scale.y * content.height();
  return {scale.x,
          0,
          0,
          scale.y,
          target.min.x + ratio.align_x * spare_x - scale.x * content.min.x,
          target.min.y + ratio.align_y * spare_y - scale.y * content.min.y};
}

}  // namespace sfumato::svg
