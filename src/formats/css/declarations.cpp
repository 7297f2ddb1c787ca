#include "formats/css/declarations.hpp"

#include <cstdint>

#include "base/text/ascii.hpp"
#include "formats/css/value.hpp"

namespace sfumato::css {
namespace {

using enum TokenType;

/// The end of a value where "!important" may stand.
struct Tail {
  std::size_t value_end = 0;  ///< of the text before the '!'
  std::uint8_t seen = 0;      ///< 1: '!', 2: "! important" and nothing behind
};

class DeclarationReader {
 public:
  DeclarationReader(Tokenizer& tokens, bool in_block) : tokens_(tokens), in_block_(in_block) {}

  bool read(FunctionRef<void(const Declaration&)> sink);

 private:
  bool ends(const Token& token) const {
    return token.is(end) || (in_block_ && token.is(close_curly));
  }
  bool take_declaration(const Token& name, Declaration& declaration);
  bool take_value(Declaration& declaration, bool is_custom);
  bool breaks(std::size_t position, bool is_custom);
  void skip_rule();

  Tokenizer& tokens_;
  bool in_block_;
  /// The end of an invalid value of a custom property. Such a value may hold blocks, and text after
  /// a block that looks like a declaration ends there too, so it is not read again.
  std::size_t broken_ = 0;
};

/// Skips a rule in the block: up to the end of its braces or, without braces, to the semicolon. The
/// end of the block is not consumed.
void DeclarationReader::skip_rule() {
  for (;;) {
    const std::size_t before = tokens_.position();
    const Token token = tokens_.next();
    if (ends(token)) return tokens_.rewind(before);
    skip_component(tokens_, token);
    if (token.is(semicolon) || token.is(open_curly)) return;
  }
}

/// Returns false and records the place of an invalid value.
bool DeclarationReader::breaks(std::size_t position, bool is_custom) {
  if (is_custom) broken_ = position;
  return false;
}

/// The value up to its semicolon, which is taken, or to the end of the block. False where CSS has
/// none here, and then somewhere in it.
bool DeclarationReader::take_value(Declaration& declaration, bool is_custom) {
  const std::size_t begin = tokens_.position();
  std::size_t declaration_end = begin;
  Tail tail;
  bool has_block = false, has_other = false;
  for (;;) {
    const std::size_t before = tokens_.position();
    const Token token = tokens_.next();
    if (ends(token) || token.is(semicolon)) {
      if (!token.is(semicolon)) tokens_.rewind(before);
      break;
    }
    declaration_end = before;
    if (token.is(whitespace)) continue;
    const bool is_broken = token.is(bad_string) || token.is(bad_url) || token.is(close_paren) ||
                           token.is(close_square) || token.is(close_curly);
    if (is_broken) return breaks(before, is_custom);
    // A brace begins a rule's block, if the value is not just that.
    if (token.is(open_curly) && !is_custom && has_other) return false;
    if (has_block && !is_custom && !token.is_delim('!') && tail.seen == 0) return false;
    skip_component(tokens_, token);
    declaration_end = tokens_.position();
    if (token.is_delim('!')) {
      if (tail.seen > 0) return breaks(before, is_custom);
      tail = {before, 1};
    } else if (tail.seen == 1 && token.is(ident) && is_named(token.value, "important")) {
      tail.seen = 2;
    } else if (tail.seen > 0) {
      return breaks(before, is_custom);
    } else {
      has_block |= token.is(open_curly);
      has_other |= !token.is(open_curly);
    }
  }
  if (tail.seen == 1) return breaks(tokens_.position(), is_custom);
  declaration.is_important = tail.seen == 2;
  const std::size_t value_end = declaration.is_important ? tail.value_end : declaration_end;
  declaration.value = ascii_trimmed(tokens_.text().substr(begin, value_end - begin));
  return true;
}

bool DeclarationReader::take_declaration(const Token& name, Declaration& declaration) {
  if (!name.is(ident) || !next_solid(tokens_).is(colon)) return false;
  declaration.name = name.value;
  const bool is_custom = name.value.starts_with("--");
  const auto begin = static_cast<std::size_t>(name.text.data() - tokens_.text().data());
  if (is_custom && begin < broken_) return false;
  return take_value(declaration, is_custom);
}

bool DeclarationReader::read(FunctionRef<void(const Declaration&)> sink) {
  bool passed_over = false;
  for (;;) {
    const std::size_t before = tokens_.position();
    const Token token = next_solid(tokens_);
    if (ends(token)) return passed_over;
    if (token.is(semicolon)) continue;
    Declaration declaration;
    if (take_declaration(token, declaration)) {
      sink(declaration);
      continue;
    }
    passed_over = true;
    tokens_.rewind(before);
    skip_rule();
  }
}

}  // namespace

bool read_declarations(Tokenizer& tokens, bool in_block,
                       FunctionRef<void(const Declaration&)> sink) {
  return DeclarationReader(tokens, in_block).read(sink);
}

}  // namespace sfumato::css
