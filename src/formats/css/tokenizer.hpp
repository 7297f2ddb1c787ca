#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <string>
#include <string_view>

#include "sfumato/base/context.hpp"

namespace sfumato::css {

/// Counts the bytes of all texts that are read, and checks the cancel flag of its Context once
/// every kBytes of them. Without a Context it never stops the work.
class TextPoll {
 public:
  static constexpr std::size_t kBytes = std::size_t{1} << 16;

  TextPoll() = default;
  explicit TextPoll(const Context& context) : context_(&context) {}

  /// False if work must stop; the rest of the text is then skipped.
  bool go_on(std::size_t bytes) {
    bytes_ += bytes;
    if (bytes_ < kBytes || context_ == nullptr) return !cancelled_;
    bytes_ = 0;
    cancelled_ = cancelled_ || context_->cancelled();
    return !cancelled_;
  }
  /// Ok, or why the work ended. Results read from the texts are then meaningless.
  Status status() const { return cancelled_ ? context_->cancel_status() : ok_status(); }

 private:
  const Context* context_ = nullptr;
  std::size_t bytes_ = 0;
  bool cancelled_ = false;
};

/// The tokens of CSS Syntax 3, section 4, except <unicode-range-token>.
enum class TokenType : std::uint8_t {
  end,
  ident,
  function,    ///< the name and its parenthesis
  at_keyword,  ///< the name after @
  hash,        ///< the name after #
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

/// One token. Its texts are parts of the input, with escapes; see unescaped().
struct Token {
  TokenType type = TokenType::end;
  std::string_view text{};   ///< all of it
  std::string_view value{};  ///< the name, the content of a string or url, or the number
  std::string_view unit{};   ///< of a dimension
  bool is_id = false;        ///< of a hash: the name after # is an identifier

  bool is(TokenType asked) const { return type == asked; }
  bool is_delim(char c) const { return type == TokenType::delim && text.front() == c; }
};

/// Splits a text into tokens in linear time; comments are skipped. After the poll has stopped the
/// work, the next token is the end.
class Tokenizer {
 public:
  Tokenizer(std::string_view text, TextPoll& poll);

  Token next();
  /// Returns the position of the next token, or of a comment before it.
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
  std::size_t told_ = 0;  ///< the position up to which the poll has counted
};

/// Returns a name or a string with its escapes replaced by the characters in UTF-8.
std::string unescaped(std::string_view raw);

/// Returns whether a name equals `lower`, which is in lower case, apart from ASCII case and
/// escapes.
bool is_named(std::string_view raw, std::string_view lower);

/// Returns the first item of a table whose `name` is_named() so; null if there is none.
template <class Table>
auto find_named(const Table& table, std::string_view raw) {
  const auto is_it = [raw](const auto& item) { return is_named(raw, item.name); };
  const auto found = std::ranges::find_if(table, is_it);
  return found == std::end(table) ? nullptr : &*found;
}

/// Consumes the rest of the component that begins with `first`: for a bracket or a function
/// everything up to its end, including nested brackets. Beyond 1,000 nested brackets the rest of
/// the text is consumed.
void skip_component(Tokenizer& tokens, const Token& first);

}  // namespace sfumato::css
