#include "formats/css/selector.hpp"

#include <array>
#include <optional>
#include <utility>

#include "base/text/ascii.hpp"
#include "formats/css/value.hpp"

namespace sfumato::css {
namespace {

using enum TokenType;
using PartKind = SelectorPart::Kind;
using Combinator = SelectorPart::Combinator;
using AttributeMatch = SelectorPart::Match;

struct PseudoClass {
  std::string_view name;
  PartKind kind;
};

constexpr std::array<PseudoClass, 11> kPseudoClasses{{{"root", PartKind::root},
                                                      {"first-child", PartKind::first_child},
                                                      {"last-child", PartKind::last_child},
                                                      {"only-child", PartKind::only_child},
                                                      {"hover", PartKind::never},
                                                      {"active", PartKind::never},
                                                      {"focus", PartKind::never},
                                                      {"focus-visible", PartKind::never},
                                                      {"focus-within", PartKind::never},
                                                      {"target", PartKind::never},
                                                      {"visited", PartKind::never}}};

std::optional<SelectorPart> pseudo_class(std::string_view name) {
  const PseudoClass* known = find_named(kPseudoClasses, name);
  return known ? std::optional(SelectorPart{known->kind}) : std::nullopt;
}

/// Returns the relation that the characters before "=" stand for.
std::optional<AttributeMatch> match_of(const Token& sign) {
  constexpr std::string_view kSigns = "=~|^$*";
  constexpr std::array<AttributeMatch, kSigns.size()> kMatches{
      AttributeMatch::equals, AttributeMatch::word,   AttributeMatch::dash,
      AttributeMatch::prefix, AttributeMatch::suffix, AttributeMatch::substring};
  if (!sign.is(delim)) return std::nullopt;
  const std::size_t at = kSigns.find(sign.text.front());
  if (at == std::string_view::npos) return std::nullopt;
  return kMatches[at];
}

/// Reads the text between the brackets of an attribute selector, after the first bracket.
std::optional<SelectorPart> take_attribute(Tokenizer& tokens) {
  SelectorPart part{PartKind::attribute};
  const Token name = next_solid(tokens);
  if (!name.is(ident)) return std::nullopt;
  part.name = name.value;
  Token token = next_solid(tokens);
  if (token.is(close_square) || token.is(end)) return part;
  const std::optional<AttributeMatch> match = match_of(token);
  if (!match || (*match != AttributeMatch::equals && !tokens.next().is_delim('=')))
    return std::nullopt;
  part.match = *match;
  const Token value = next_solid(tokens);
  if (!value.is(string) && !value.is(ident)) return std::nullopt;
  part.value = value.value;
  token = next_solid(tokens);
  if (token.is(ident) && (is_named(token.value, "i") || is_named(token.value, "s"))) {
    part.ignores_case = is_named(token.value, "i");
    token = next_solid(tokens);
  }
  if (!token.is(close_square) && !token.is(end)) return std::nullopt;
  return part;
}

/// A part that `token` begins within :not().
std::optional<SelectorPart> take_negated(Tokenizer& tokens, const Token& token) {
  if (token.is(ident)) return SelectorPart{.kind = PartKind::element, .name = token.value};
  if (token.is(hash) && token.is_id) return SelectorPart{.kind = PartKind::id, .name = token.value};
  if (token.is(open_square)) return take_attribute(tokens);
  if (token.is_delim('*')) return SelectorPart{};
  const Token name = tokens.next();
  if (!name.is(ident)) return std::nullopt;
  if (token.is_delim('.')) return SelectorPart{.kind = PartKind::of_class, .name = name.value};
  return token.is(colon) ? pseudo_class(name.value) : std::nullopt;
}

/// The only part in :not(…), whose name is taken.
std::optional<SelectorPart> take_not(Tokenizer& tokens) {
  std::optional<SelectorPart> part = take_negated(tokens, next_solid(tokens));
  const Token last = next_solid(tokens);
  if (!part || !(last.is(close_paren) || last.is(end))) return std::nullopt;
  part->is_negated = true;
  return part;
}

class SelectorReader {
 public:
  SelectorReader(Tokenizer& tokens, std::vector<SelectorPart>& parts)
      : tokens_(tokens), parts_(parts) {
    parts_.clear();
  }

  Selector read();

 private:
  void take(const Token& token);
  void take_delim(const Token& token);
  void take_pseudo();
  void take_brackets(const Token& token, std::optional<SelectorPart> (*take_part)(Tokenizer&));
  void add(SelectorPart part);
  void add_unsupported();
  void combine(Combinator combinator);
  void fail() { is_valid_ = false; }
  Selector finished() const;

  Tokenizer& tokens_;
  std::vector<SelectorPart>& parts_;
  Combinator combinator_ = Combinator::none;  ///< behind the last part
  std::size_t part_count_ = 0;
  bool is_valid_ = true;
  bool is_supported_ = true;
  bool in_compound_ = false;    ///< something stands before, with nothing between
  bool needs_compound_ = true;  ///< at the beginning and behind > + ~
};

void SelectorReader::add(SelectorPart part) {
  // A name can only begin a compound: "g.a", not ".ag".
  const bool is_name = part.kind == PartKind::element || part.kind == PartKind::any;
  if (is_name && !part.is_negated && in_compound_) fail();
  if (part_count_++ > 0 && !in_compound_) {
    part.combinator = combinator_ == Combinator::none ? Combinator::descendant : combinator_;
  }
  combinator_ = Combinator::none;
  in_compound_ = true;
  needs_compound_ = false;
  if (parts_.size() < kSelectorParts) {
    parts_.push_back(part);
  } else {
    is_supported_ = false;
  }
}

void SelectorReader::add_unsupported() {
  is_supported_ = false;
  add({PartKind::never});
}

void SelectorReader::combine(Combinator combinator) {
  if (needs_compound_) fail();
  combinator_ = combinator;
  in_compound_ = false;
  needs_compound_ = true;
}

/// A part in brackets, or where it is not read whatever stands in them.
void SelectorReader::take_brackets(const Token& token,
                                   std::optional<SelectorPart> (*take_part)(Tokenizer&)) {
  const std::size_t inside = tokens_.position();
  if (const std::optional<SelectorPart> part = take_part(tokens_)) return add(*part);
  tokens_.rewind(inside);
  skip_component(tokens_, token);
  add_unsupported();
}

void SelectorReader::take_pseudo() {
  std::size_t before = tokens_.position();
  Token token = tokens_.next();
  const bool is_class = !token.is(colon);
  if (!is_class) {
    before = tokens_.position();
    token = tokens_.next();
  }
  if (is_class && token.is(function) && is_named(token.value, "not")) {
    return take_brackets(token, take_not);
  }
  if (is_class && token.is(ident)) {
    if (const std::optional<SelectorPart> part = pseudo_class(token.value)) return add(*part);
  }
  if (!token.is(ident) && !token.is(function)) {
    tokens_.rewind(before);  // it may be the comma
    return fail();
  }
  skip_component(tokens_, token);
  add_unsupported();
}

void SelectorReader::take_delim(const Token& token) {
  switch (token.text.front()) {
    case '*':
      return add({});
    case '>':
      return combine(Combinator::child);
    case '+':
      return combine(Combinator::next_sibling);
    case '~':
      return combine(Combinator::later_sibling);
    case '&':
      return add_unsupported();
    case '|':  // behind the prefix of a namespace, which was taken for a name
      is_supported_ = false;
      part_count_ = 1;
      in_compound_ = false;
      needs_compound_ = true;
      return;
    case '.': {
      const std::size_t before = tokens_.position();
      const Token name = tokens_.next();
      if (name.is(ident)) return add({.kind = PartKind::of_class, .name = name.value});
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
      return add({.kind = PartKind::element, .name = token.value});
    case hash:
      return token.is_id ? add({.kind = PartKind::id, .name = token.value}) : fail();
    case delim:
      return take_delim(token);
    case colon:
      return take_pseudo();
    case open_square:
      return take_brackets(token, take_attribute);
    default:
      skip_component(tokens_, token);
      return fail();
  }
}

Selector SelectorReader::finished() const {
  Selector selector;
  if (!is_valid_ || needs_compound_) return selector;
  selector.kind = Selector::Kind::unsupported;
  if (!is_supported_) return selector;
  selector.kind = Selector::Kind::complex;
  for (const SelectorPart& part : parts_) selector.specificity += specificity_of(part.kind);
  const SelectorPart& first = parts_.front();
  if (parts_.size() > 1 || first.kind > PartKind::id || first.is_negated) return selector;
  selector.kind = static_cast<Selector::Kind>(first.kind);
  selector.name = first.name;
  return selector;
}

Selector SelectorReader::read() {
  const std::size_t begin = tokens_.position();
  for (;;) {
    const std::size_t before = tokens_.position();
    const Token token = tokens_.next();
    if (token.is(end) || token.is(comma)) {
      Selector selector = finished();
      selector.text = ascii_trimmed(tokens_.text().substr(begin, before - begin));
      selector.is_last = token.is(end);
      return selector;
    }
    take(token);
  }
}

}  // namespace

std::uint32_t specificity_of(SelectorPart::Kind kind) {
  // At most kSelectorParts of each kind are counted.
  constexpr std::uint32_t kOfClass = 2 * kSelectorParts, kOfId = kOfClass * kOfClass;
  switch (kind) {
    case PartKind::any:
      return 0;
    case PartKind::element:
      return 1;
    case PartKind::id:
      return kOfId;
    default:
      return kOfClass;
  }
}

Selector take_selector(Tokenizer& tokens, std::vector<SelectorPart>& parts) {
  return SelectorReader(tokens, parts).read();
}

}  // namespace sfumato::css
