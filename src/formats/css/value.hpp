#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "formats/css/tokenizer.hpp"

namespace sfumato::css {

/// Returns the next token that is not whitespace.
Token next_solid(Tokenizer& tokens);

/// Returns the only token of a text besides whitespace and comments; no value if there are several
/// or none.
std::optional<Token> only_token(std::string_view text, TextPoll& poll);

/// Returns the value of a number token; no value if it is too large.
std::optional<double> number_of(const Token& token);

/// Returns an angle in degrees, of a number or a dimension with a unit of angles; else no value.
std::optional<double> degrees_of(const Token& token);

/// Returns a value that is one keyword, in lower case; else nothing.
std::optional<std::string> keyword_of(std::string_view text, TextPoll& poll);

/// Returns a value that is one number or percentage, 100% as 1, clamped to 0 to 1; else nothing.
std::optional<double> share_of(std::string_view text, TextPoll& poll);

enum class PaintPart : std::uint8_t { fill, stroke, markers };
/// The parts of a shape, the lowest first.
using PaintOrder = std::array<PaintPart, 3>;
inline constexpr PaintOrder kNormalPaintOrder{PaintPart::fill, PaintPart::stroke,
                                              PaintPart::markers};

/// A value of `paint-order`; no value if it is invalid.
std::optional<PaintOrder> paint_order_of(std::string_view text, TextPoll& poll);

/// Consumes url(…), with or without quotes, whose first token is `first`, and returns its content.
/// No value if it is not a url, is invalid, or is longer than any reference within a document.
std::optional<std::string> take_url(Tokenizer& tokens, const Token& first);

/// Returns the content of a value that is one url(…); else no value.
std::optional<std::string> url_of(std::string_view text, TextPoll& poll);

}  // namespace sfumato::css
