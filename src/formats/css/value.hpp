#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "formats/css/tokenizer.hpp"

namespace sfumato::css {

/// The next token that is no whitespace.
Token next_solid(Tokenizer& tokens);

/// The only token of a text beside whitespace and comments; nothing where there are others or none.
std::optional<Token> only_token(std::string_view text, TextPoll& poll);

/// What a token of a number says; nothing where it is too large.
std::optional<double> number_of(const Token& token);

/// A value that is one keyword, in lower case; else nothing.
std::optional<std::string> keyword_of(std::string_view text, TextPoll& poll);

/// A value that is one number or percentage, 100% as 1, clamped to 0 to 1; else nothing.
std::optional<double> share_of(std::string_view text, TextPoll& poll);

/// A value of `paint-order`: whether the stroke is painted below the fill; nothing where it is
/// none.
enum class PaintOrder : std::uint8_t { fill_first, stroke_first };
std::optional<PaintOrder> paint_order_of(std::string_view text, TextPoll& poll);

/// Takes url(…), with quotes or without, whose first token was taken: what it holds. Nothing where
/// it is none, broken, or longer than any reference within a document.
std::optional<std::string> take_url(Tokenizer& tokens, const Token& first);

/// A value that is one url(…): what it holds; else nothing.
std::optional<std::string> url_of(std::string_view text, TextPoll& poll);

}  // namespace sfumato::css
