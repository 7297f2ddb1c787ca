#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "sfumato/base/context.hpp"

namespace sfumato::css {

/// Counts the bytes of texts that are walked through, and looks at the cancel flag of its Context
/// once in kBytes of them, however many texts these are. Without a Context it never stops.
class TextPoll {
 public:
  static constexpr std::size_t kBytes = std::size_t{1} << 16;

  TextPoll() = default;
  explicit TextPoll(const Context& context) : context_(&context) {}

  /// False where work is to stop: the rest of the text is passed over then.
  bool go_on(std::size_t bytes) {
    bytes_ += bytes;
    if (bytes_ < kBytes || context_ == nullptr) return !cancelled_;
    bytes_ = 0;
    cancelled_ = cancelled_ || context_->cancelled();
    return !cancelled_;
  }
  /// Ok, or why the work ended. What was read from the texts means nothing then.
  Status status() const { return cancelled_ ? context_->cancel_status() : ok_status(); }

 private:
  const Context* context_ = nullptr;
  std::size_t bytes_ = 0;
  bool cancelled_ = false;
};

/// The tokens of CSS Syntax 3, section 4, but for <unicode-range-token>.
enum class TokenType : std::uint8_t {
  end,
  ident,
  function,    ///< the name and its parenthesis
  at_keyword,  ///< the name behind @
  hash,        ///< the name behind #
  string,
  bad_string,
  url,  ///< url(…) without quotes; with quotes it is a function and a string
  bad_url,
  delim,
  number,
  percentage,
  dimension,
  whitespace,
  cdo,  ///< <!--
  cdc,  ///< -->
  colon,
  semicolon,
  comma,
  open_square,
  close_square,
  open_paren,
  close_paren,
  open_curly,
  close_curly
};

/// One token. Its texts lie in the text that was read, escapes and all: unescaped().
struct Token {
  TokenType type = TokenType::end;
  std::string_view text{};   ///< all of it
  std::string_view value{};  ///< the name, what a string or an url holds, the number
  std::string_view unit{};   ///< of a dimension
  bool is_id = false;        ///< of a hash: what is behind # is an identifier

  bool is(TokenType asked) const { return type == asked; }
  bool is_delim(char c) const { return type == TokenType::delim && text.front() == c; }
};

/// Cuts a text into tokens, from the front, in linear time; comments are passed over. Where the
/// poll stops, the next token is the end.
class Tokenizer {
 public:
  Tokenizer(std::string_view text, TextPoll& poll);

  Token next();
  /// Where the next token begins, or a comment before it.
  std::size_t position() const { return at_; }
  /// Goes back to a position.
  void rewind(std::size_t position) { at_ = told_ = position; }
  std::string_view text() const { return text_; }

 private:
  char peek(std::size_t ahead = 0) const {
    return ahead < text_.size() - at_ ? text_[at_ + ahead] : '\0';
  }
  std::string_view since(std::size_t begin) const { return text_.substr(begin, at_ - begin); }
  template <class IsWanted>
  void skip_while(IsWanted is_wanted);
  void skip_to(std::string_view end);
  void pace();
  void skip_comments();
  void skip_name();
  void skip_escape();
  void skip_number();
  bool starts_escape(std::size_t ahead) const;
  bool starts_name(std::size_t ahead) const;
  bool starts_number() const;
  Token simple(TokenType type, std::size_t length);
  Token take_string();
  Token take_hash();
  Token take_at();
  Token take_numeric();
  Token take_ident_like();
  Token take_url(std::size_t begin);
  Token rest_of_bad_url(std::size_t begin);
  Token take_other();

  std::string_view text_;
  TextPoll& poll_;
  std::size_t at_ = 0;
  std::size_t told_ = 0;  ///< to where the poll knows
};

/// A name or a string without its escapes; what they name stands in UTF-8.
std::string unescaped(std::string_view raw);

/// Whether a name is `lower`, which is in lower case, but for ASCII case and escapes.
bool is_named(std::string_view raw, std::string_view lower);

/// Consumes what belongs to a token that was taken: of a bracket or a function all up to its end,
/// brackets in it included. Beyond 1,000 brackets in each other the rest is taken whole.
void skip_component(Tokenizer& tokens, const Token& first);

}  // namespace sfumato::css
