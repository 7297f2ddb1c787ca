#include "formats/css/style_sheet.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

#include "base/text/ascii.hpp"
#include "formats/css/media.hpp"
#include "formats/css/value.hpp"

namespace sfumato::css {
namespace {

using enum TokenType;
/// Texts of one place are equal without a look: a rule may set many values for one long selector.
int compared(std::string_view a, std::string_view b) {
  if (a.data() == b.data() && a.size() == b.size()) return 0;
  return a.compare(b);
}

/// The name of a class, an id or an element that is written with escapes.
constexpr std::size_t kLongestName = 4096;

bool has_escape(std::string_view name) {
  return name.find('\\') != std::string_view::npos;
}

/// CSS drops a whole rule if one of its selectors is wrong. `parts`: room for the parts of one
/// selector.
bool are_valid(std::string_view selectors, TextPoll& poll, std::vector<SelectorPart>& parts) {
  Tokenizer tokens(selectors, poll);
  for (;;) {
    const Selector selector = take_selector(tokens, parts);
    if (selector.kind == Selector::Kind::invalid) return false;
    if (selector.is_last) return true;
  }
}

bool is_long(std::string_view name) {
  return name.size() > kLongestName && has_escape(name);
}

bool has_long_text(std::span<const SelectorPart> parts) {
  return std::ranges::any_of(
      parts, [](const SelectorPart& part) { return is_long(part.name) || is_long(part.value); });
}

/// Calls `sink` with each class of a list that white space separates.
template <class Sink>
void for_each_class(std::string_view classes, Sink sink) {
  while (!(classes = ascii_trimmed(classes)).empty()) {
    const auto end_of_class = std::ranges::find_if(classes, is_ascii_blank);
    const auto length = static_cast<std::size_t>(end_of_class - classes.begin());
    sink(classes.substr(0, length));
    classes.remove_prefix(length);
  }
}

}  // namespace

bool RankedSetting::outranks(const RankedSetting& other) const {
  const auto rank = [](const RankedSetting& ranked) {
    return std::tuple(ranked.setting.is_important, ranked.specificity, ranked.order);
  };
  return rank(*this) > rank(other);
}

bool StyleSheet::Key::operator<(const Key& other) const {
  if (kind != other.kind) return kind < other.kind;
  if (property.property != other.property.property) {
    return property.property < other.property.property;
  }
  const int names = compared(name, other.name);
  return names != 0 ? names < 0 : compared(property.custom, other.property.custom) < 0;
}

/// Walks through the rules of one sheet.
class StyleSheet::Reader {
 public:
  Reader(StyleSheet& sheet, std::string_view text, std::size_t most_values, TextPoll& poll)
      : sheet_(sheet), tokens_(text, poll), most_values_(most_values), poll_(poll) {}

  Notes read();

 private:
  /// Reads the text before a block, or before the end of a rule without a block.
  struct Prelude {
    std::string_view text;
    bool has_block = false;  ///< its brace was taken
  };

  Prelude take_prelude(bool is_at_rule);
  void read_at_rule(const Token& name);
  void read_rule(std::size_t begin);
  void add(std::string_view selectors, const Style& style);
  void skip_block() { skip_component(tokens_, {open_curly}); }
  void leave_out(std::string_view what) {
    if (notes_.left_out.empty()) notes_.left_out = ascii_trimmed(what);
  }

  StyleSheet& sheet_;
  Tokenizer tokens_;
  std::size_t most_values_;
  TextPoll& poll_;
  std::size_t depth_ = 0;  ///< of @media that are read
  std::vector<SelectorPart> parts_;
  Notes notes_;
};

StyleSheet::Notes StyleSheet::Reader::read() {
  for (;;) {
    const std::size_t begin = tokens_.position();
    const Token token = tokens_.next();
    if (token.is(end)) return notes_;
    if (token.is(whitespace) || (depth_ == 0 && (token.is(cdo) || token.is(cdc)))) continue;
    if (token.is(close_curly) && depth_ > 0) {
      --depth_;
    } else if (token.is(at_keyword)) {
      read_at_rule(token);
    } else {
      read_rule(begin);
    }
  }
}

StyleSheet::Reader::Prelude StyleSheet::Reader::take_prelude(bool is_at_rule) {
  const std::size_t begin = tokens_.position();
  for (;;) {
    const std::size_t before = tokens_.position();
    const Token token = tokens_.next();
    const std::string_view text = tokens_.text().substr(begin, before - begin);
    if (token.is(open_curly)) return {text, true};
    if (token.is(end) || (is_at_rule && token.is(semicolon))) return {text};
    if (depth_ > 0 && token.is(close_curly)) {
      tokens_.rewind(before);
      return {text};
    }
    skip_component(tokens_, token);
  }
}

void StyleSheet::Reader::read_at_rule(const Token& name) {
  const Prelude prelude = take_prelude(true);
  const std::string_view whole(name.text.data(), prelude.text.data() + prelude.text.size());
  const bool is_media = is_named(name.value, "media") && prelude.has_block;
  const Media media = is_media ? media_of(prelude.text, poll_) : Media::unknown;
  if (media == Media::matches) {
    ++depth_;
    return;
  }
  if (prelude.has_block) skip_block();
  if (media == Media::unknown) leave_out(whole);
}

void StyleSheet::Reader::read_rule(std::size_t begin) {
  tokens_.rewind(begin);
  const Prelude prelude = take_prelude(false);
  if (!prelude.has_block) return leave_out(prelude.text);
  if (!are_valid(prelude.text, poll_, parts_)) {
    skip_block();
    return leave_out(prelude.text);
  }
  Style style;
  read_declarations(tokens_, true,
                    [&](const Declaration& declaration) { style.add(declaration, poll_); });
  if (!notes_.dropped) notes_.dropped = style.dropped();
  if (poll_.status()) add(prelude.text, style);
}

void StyleSheet::Reader::add(std::string_view selectors, const Style& style) {
  sheet_.shares_settings_ = false;
  Tokenizer tokens(selectors, poll_);
  for (;;) {
    const Selector selector = take_selector(tokens, parts_);
    if (selector.kind == Selector::Kind::unsupported || has_long_text(parts_)) {
      leave_out(selector.text);
    } else if (selector.kind == Selector::Kind::complex) {
      sheet_.add_complex_rule(selector, parts_, style, most_values_);
    } else {
      sheet_.add_rule(selector, style, most_values_);
    }
    if (selector.is_last || sheet_.count_ > most_values_) return;
  }
}

StyleSheet::Notes StyleSheet::add(std::string_view text, std::size_t most_values, TextPoll& poll) {
  return Reader(*this, text, most_values, poll).read();
}

/// False where the limit is reached.
bool StyleSheet::count(std::size_t values, std::size_t most_values) {
  count_ += values;
  return count_ <= most_values;
}

std::string_view StyleSheet::stored(std::string_view raw) {
  return has_escape(raw) ? std::string_view(names_.emplace_back(unescaped(raw))) : raw;
}

void StyleSheet::add_rule(const Selector& selector, const Style& style, std::size_t most_values) {
  const std::size_t order = count_;
  if (!count(style.declaration_count(), most_values)) return;
  const std::string_view name = stored(selector.name);
  style.for_each([&](const PropertyName& property, const Setting& setting) {
    const RankedSetting added{setting, selector.specificity, order};
    const Key key{static_cast<Kind>(selector.kind), property, name};
    const auto [value, is_new] = values_.try_emplace(key, added);
    if (!is_new && added.outranks(value->second)) value->second = added;
    is_set_[static_cast<std::size_t>(property.property)] = true;
  });
}

void StyleSheet::add_settings(const Style& style) {
  style.for_each([&](const PropertyName& property, const Setting& setting) {
    settings_.push_back({property, setting});
    is_set_[static_cast<std::size_t>(property.property)] = true;
  });
}

void StyleSheet::add_complex_rule(const Selector& selector, std::span<const SelectorPart> parts,
                                  const Style& style, std::size_t most_values) {
  const std::size_t order = count_;
  if (!count(style.declaration_count() + parts.size() - 1, most_values) || style.empty()) return;
  ComplexRule rule{static_cast<std::uint32_t>(parts_.size()),
                   static_cast<std::uint32_t>(parts.size()),
                   0,
                   0,
                   selector.specificity,
                   order};
  if (!shares_settings_) {
    first_setting_ = static_cast<std::uint32_t>(settings_.size());
    add_settings(style);
    shares_settings_ = true;
  }
  rule.first_setting = first_setting_;
  rule.setting_count = static_cast<std::uint32_t>(settings_.size()) - first_setting_;
  for (SelectorPart part : parts) {
    part.name = stored(part.name);
    part.value = stored(part.value);
    parts_.push_back(part);
  }
  rules_.push_back(rule);
  index_rule(parts_of(rule));
}

/// By an id of its last compound, else a class, else a name: the later kinds are rarer.
void StyleSheet::index_rule(std::span<const SelectorPart> parts) {
  std::pair<Kind, std::string_view> key{Kind::any, {}};
  for (std::size_t i = parts.size(); i-- > 0;) {
    const SelectorPart& part = parts[i];
    const bool is_key = part.kind <= Kind::id && !part.is_negated;
    if (is_key && part.kind > key.first) key = {part.kind, part.name};
    if (part.combinator != SelectorPart::Combinator::none) break;
  }
  rules_for_[key].push_back(static_cast<std::uint32_t>(rules_.size() - 1));
}

std::span<const std::uint32_t> StyleSheet::rules_for(Kind kind, std::string_view name) const {
  const auto found = rules_for_.find({kind, name});
  return found == rules_for_.end() ? std::span<const std::uint32_t>() : found->second;
}

std::span<const SelectorPart> StyleSheet::parts_of(const ComplexRule& rule) const {
  return std::span(parts_).subspan(rule.first_part, rule.part_count);
}

void StyleSheet::consider(const Key& key, std::optional<RankedSetting>& best) const {
  const auto found = values_.find(key);
  if (found != values_.end() && (!best || found->second.outranks(*best))) best = found->second;
}

std::optional<RankedSetting> StyleSheet::find(std::string_view name, std::string_view id,
                                              std::string_view classes,
                                              const PropertyName& property) const {
  std::optional<RankedSetting> best;
  if (!sets(property.property)) return best;
  if (!id.empty()) consider({Kind::id, property, id}, best);
  for_each_class(classes, [&](std::string_view one) {
    consider({Kind::of_class, property, one}, best);
  });
  consider({Kind::element, property, name}, best);
  consider({Kind::any, property, {}}, best);
  return best;
}

}  // namespace sfumato::css
