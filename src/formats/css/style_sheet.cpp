#include "formats/css/style_sheet.hpp"

#include <algorithm>
#include <utility>

#include "base/ascii.hpp"
#include "formats/css/media.hpp"
#include "formats/css/value.hpp"

namespace sfumato::css {
namespace {

using enum TokenType;
using Kind = Selector::Kind;

/// Texts of one place are equal without a look: a rule may set many values for one long selector.
int compared(std::string_view a, std::string_view b) {
  if (a.data() == b.data() && a.size() == b.size()) return 0;
  return a.compare(b);
}

/// Of a class, an id or an element that is written with escapes.
constexpr std::size_t kLongestName = 4096;

bool has_escape(std::string_view name) {
  return name.find('\\') != std::string_view::npos;
}

/// CSS drops a rule whole where one of its selectors is wrong.
bool are_valid(std::string_view selectors, TextPoll& poll) {
  Tokenizer tokens(selectors, poll);
  for (;;) {
    const Selector selector = take_selector(tokens);
    if (selector.kind == Kind::invalid) return false;
    if (selector.is_last) return true;
  }
}

}  // namespace

bool StyleSheet::Key::operator<(const Key& other) const {
  if (kind != other.kind) return kind < other.kind;
  if (property != other.property) return property < other.property;
  return compared(name, other.name) < 0;
}

/// Walks through the rules of one sheet.
class StyleSheet::Reader {
 public:
  Reader(StyleSheet& sheet, std::string_view text, std::size_t most_values, TextPoll& poll)
      : sheet_(sheet), tokens_(text, poll), most_values_(most_values), poll_(poll) {}

  Notes read();

 private:
  /// What stands before a block, or before what ends a rule without one.
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
  if (!are_valid(prelude.text, poll_)) {
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
  Tokenizer tokens(selectors, poll_);
  for (;;) {
    const Selector selector = take_selector(tokens);
    const bool is_long = selector.name.size() > kLongestName && has_escape(selector.name);
    if (selector.kind == Kind::other || is_long) {
      leave_out(selector.text);
    } else {
      sheet_.add_rule(selector, style, most_values_);
    }
    if (selector.is_last || sheet_.count_ > most_values_) return;
  }
}

StyleSheet::Notes StyleSheet::add(std::string_view text, std::size_t most_values, TextPoll& poll) {
  return Reader(*this, text, most_values, poll).read();
}

void StyleSheet::add_rule(const Selector& selector, const Style& style, std::size_t most_values) {
  const std::size_t order = count_;
  count_ += style.declaration_count();
  if (count_ > most_values) return;
  std::string_view name = selector.name;
  if (has_escape(name)) name = names_.emplace_back(unescaped(name));
  for (std::size_t i = 0; i < kPropertyCount; ++i) {
    const auto property = static_cast<Property>(i);
    const std::optional<Setting>& setting = style[property];
    if (!setting) continue;
    Value& value = values_[{selector.kind, property, name}];
    if (!value.setting.is_important || setting->is_important) value = {*setting, order};
  }
}

const StyleSheet::Value* StyleSheet::value_of(const Key& key) const {
  const auto found = values_.find(key);
  return found == values_.end() ? nullptr : &found->second;
}

std::optional<Setting> StyleSheet::find(std::string_view name, std::string_view id,
                                        std::string_view classes, Property property) const {
  const Value* best = nullptr;
  // From the more specific to the less: of one importance the first stays.
  const auto consider = [&](const Value* value) {
    if (value && (!best || (value->setting.is_important && !best->setting.is_important))) {
      best = value;
    }
  };
  if (!id.empty()) consider(value_of({Kind::id, property, id}));
  const Value* of_classes = nullptr;
  while (!(classes = ascii_trimmed(classes)).empty()) {
    const auto end_of_class = std::ranges::find_if(classes, is_ascii_blank);
    const auto length = static_cast<std::size_t>(end_of_class - classes.begin());
    const Value* value = value_of({Kind::of_class, property, classes.substr(0, length)});
    classes.remove_prefix(length);
    if (!value) continue;
    const auto rank = [](const Value& v) { return std::pair(v.setting.is_important, v.order); };
    if (!of_classes || rank(*value) > rank(*of_classes)) of_classes = value;
  }
  consider(of_classes);
  consider(value_of({Kind::element, property, name}));
  consider(value_of({Kind::any, property, {}}));
  return best ? std::optional(best->setting) : std::nullopt;
}

}  // namespace sfumato::css
