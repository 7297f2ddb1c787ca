#include "formats/css/selector.hpp"

#include "base/ascii.hpp"

namespace sfumato::css {
namespace {

using enum TokenType;
using Kind = Selector::Kind;

class SelectorReader {
 public:
  explicit SelectorReader(Tokenizer& tokens) : tokens_(tokens) {}

  Selector read();

 private:
  void take(const Token& token);
  void take_delim(const Token& token);
  void take_pseudo();
  void add(Kind kind, std::string_view name);
  void combine();
  void fail() { is_valid_ = false; }

  Tokenizer& tokens_;
  Kind kind_ = Kind::invalid;
  std::string_view name_;
  std::size_t part_count_ = 0;
  bool is_valid_ = true;
  bool in_compound_ = false;    ///< something stands before, with nothing between
  bool needs_compound_ = true;  ///< at the beginning and behind > + ~
};

void SelectorReader::add(Kind kind, std::string_view name) {
  // A name can only begin a compound: "g.a", not ".ag".
  if ((kind == Kind::element || kind == Kind::any) && in_compound_) fail();
  kind_ = part_count_ == 0 ? kind : Kind::other;
  name_ = name;
  ++part_count_;
  in_compound_ = true;
  needs_compound_ = false;
}

void SelectorReader::combine() {
  if (needs_compound_) fail();
  kind_ = Kind::other;
  in_compound_ = false;
  needs_compound_ = true;
}

void SelectorReader::take_pseudo() {
  std::size_t before = tokens_.position();
  Token token = tokens_.next();
  if (token.is(colon)) {
    before = tokens_.position();
    token = tokens_.next();
  }
  if (!token.is(ident) && !token.is(function)) {
    tokens_.rewind(before);  // it may be the comma
    return fail();
  }
  skip_component(tokens_, token);
  add(Kind::other, {});
}

void SelectorReader::take_delim(const Token& token) {
  switch (token.text.front()) {
    case '*':
      return add(Kind::any, {});
    case '>':
    case '+':
    case '~':
      return combine();
    case '&':
      return add(Kind::other, {});
    case '|':  // behind the prefix of a namespace, which was taken for a name
      kind_ = Kind::other;
      part_count_ = 1;
      in_compound_ = false;
      needs_compound_ = true;
      return;
    case '.': {
      const std::size_t before = tokens_.position();
      const Token name = tokens_.next();
      if (name.is(ident)) return add(Kind::of_class, name.value);
      tokens_.rewind(before);
      return fail();
    }
    default:
      return fail();
  }
}

void SelectorReader::take(const Token& token) {
  switch (token.type) {
    case whitespace:
      in_compound_ = false;
      return;
    case ident:
      return add(Kind::element, token.value);
    case hash:
      return token.is_id ? add(Kind::id, token.value) : fail();
    case delim:
      return take_delim(token);
    case colon:
      return take_pseudo();
    case open_square:
      skip_component(tokens_, token);
      return add(Kind::other, {});
    default:
      skip_component(tokens_, token);
      return fail();
  }
}

Selector SelectorReader::read() {
  const std::size_t begin = tokens_.position();
  for (;;) {
    const std::size_t before = tokens_.position();
    const Token token = tokens_.next();
    if (token.is(end) || token.is(comma)) {
      const bool is_valid = is_valid_ && !needs_compound_;
      return {is_valid ? kind_ : Kind::invalid, name_,
              ascii_trimmed(tokens_.text().substr(begin, before - begin)), token.is(end)};
    }
    take(token);
  }
}

}  // namespace

Selector take_selector(Tokenizer& tokens) {
  return SelectorReader(tokens).read();
}

}  // namespace sfumato::css
