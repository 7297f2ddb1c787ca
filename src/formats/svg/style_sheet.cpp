#include "formats/svg/style_sheet.hpp"

#include <algorithm>

#include "base/limits.hpp"
#include "formats/css_text.hpp"

namespace sfumato::svg {
namespace {

bool is_name_character(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
         c == '_' || (static_cast<unsigned char>(c) & 0x80) != 0;
}

bool is_simple(std::string_view selector) {
  if (selector == "*") return true;
  if (selector.starts_with('.') || selector.starts_with('#')) selector.remove_prefix(1);
  return !selector.empty() && std::ranges::all_of(selector, is_name_character);
}

/// Takes "/* … */" and blanks from the front.
void skip_comments(std::string_view& text) {
  for (;;) {
    const std::size_t begin = std::min(text.find_first_not_of(" \t\r\n\f"), text.size());
    text.remove_prefix(begin);
    const bool at_marker = text.starts_with("<!--") || text.starts_with("-->");
    if (at_marker) {
      text.remove_prefix(text.front() == '<' ? 4 : 3);
    } else if (text.starts_with("/*")) {
      const std::size_t end = text.find("*/", 2);
      text.remove_prefix(end == std::string_view::npos ? text.size() : end + 2);
    } else {
      return;
    }
  }
}

/// Takes a block with the blocks in it, from behind its brace to behind its end.
std::string_view take_block(std::string_view& text) {
  std::size_t depth = 1, i = 0;
  for (; i < text.size(); ++i) {
    if (text[i] == '{') ++depth;
    if (text[i] == '}' && --depth == 0) break;
  }
  const std::string_view block = text.substr(0, i);
  text.remove_prefix(std::min(i + 1, text.size()));
  return block;
}

/// Texts of one place are equal without a look: a rule may set many values for one long selector.
int compared(std::string_view a, std::string_view b) {
  if (a.data() == b.data() && a.size() == b.size()) return 0;
  return a.compare(b);
}

using Declarations = std::vector<std::pair<std::string_view, std::string_view>>;

/// A block's declarations, as often as they stand there; at most one more than the limit.
Declarations declarations_of(std::string_view block, std::size_t most_values) {
  Declarations declarations;
  while (!block.empty() && declarations.size() <= most_values) {
    skip_comments(block);
    const std::string_view declaration = take_until(block, ';');
    const std::size_t colon = declaration.find(':');
    if (colon == std::string_view::npos) continue;
    const std::string_view property = css_trimmed(declaration.substr(0, colon));
    const auto value = css_declaration(declaration, property);
    declarations.emplace_back(property, value.value_or(std::string_view()));
  }
  return declarations;
}

}  // namespace

bool StyleSheet::Key::operator<(const Key& other) const {
  if (kind != other.kind) return kind < other.kind;
  if (const int order = compared(name, other.name); order != 0) return order < 0;
  return compared(property, other.property) < 0;
}

std::string_view StyleSheet::add(std::string_view text, std::size_t most_values) {
  std::string_view left_out;
  const auto leave_out = [&](std::string_view what) {
    if (left_out.empty()) left_out = css_trimmed(what);
  };
  for (skip_comments(text); !text.empty(); skip_comments(text)) {
    const std::size_t end = std::min(text.find_first_of("{;"), text.size());
    std::string_view selectors = text.substr(0, end);
    const bool has_block = end < text.size() && text[end] == '{';
    text.remove_prefix(std::min(end + 1, text.size()));
    const std::string_view block = has_block ? take_block(text) : std::string_view();
    if (selectors.starts_with('@') || !has_block) {
      leave_out(selectors);
      continue;
    }
    const Declarations declarations = declarations_of(block, most_values);
    while (!selectors.empty()) {
      const std::string_view selector = css_trimmed(take_until(selectors, ','));
      if (is_simple(selector)) {
        add_rule(selector, declarations, most_values);
      } else {
        leave_out(selector);
      }
    }
  }
  return left_out;
}

void StyleSheet::add_rule(std::string_view selector, const std::vector<Declaration>& declarations,
                          std::size_t most_values) {
  const bool is_marked = selector.starts_with('#') || selector.starts_with('.');
  const char kind = is_marked ? selector.front() : 'e';
  if (is_marked) selector.remove_prefix(1);
  for (const auto& [property, value] : declarations) {
    if (count_ > most_values) return;
    values_[{kind, selector, property}] = {value, ++count_};
  }
}

const StyleSheet::Value* StyleSheet::value_of(const Key& key) const {
  const auto found = values_.find(key);
  return found == values_.end() ? nullptr : &found->second;
}

std::optional<std::string_view> StyleSheet::find(std::string_view name, std::string_view id,
                                                 std::string_view classes,
                                                 std::string_view property) const {
  if (!id.empty()) {
    if (const Value* value = value_of({'#', id, property})) return value->text;
  }
  const Value* best = nullptr;
  while (!(classes = css_trimmed(classes)).empty()) {
    const std::size_t end = std::min(classes.find_first_of(" \t\r\n\f"), classes.size());
    const Value* value = value_of({'.', classes.substr(0, end), property});
    if (value && (!best || value->order > best->order)) best = value;
    classes.remove_prefix(end);
  }
  if (!best) best = value_of({'e', name, property});
  if (!best) best = value_of({'e', "*", property});
  return best ? std::optional(best->text) : std::nullopt;
}

}  // namespace sfumato::svg
