#include "formats/svg/style/variable_values.hpp"

#include <algorithm>

#include "base/limit_error.hpp"
#include "base/try.hpp"
#include "formats/text/suggestion.hpp"
#include "sfumato/base/limits.hpp"

namespace sfumato::svg {
namespace {

/// The cost of each test of a reference or an element, so that empty values cost too.
constexpr std::size_t kLookBytes = 16;

bool is_in_token(char c) {
  constexpr std::string_view kSigns = "-_.%#+\\";
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
         static_cast<unsigned char>(c) >= 0x80 || kSigns.find(c) != std::string_view::npos;
}

/// The memory of a value in a set: the string, and its node.
std::size_t bytes_of(const std::string& value) {
  return capacity_bytes(value) + sizeof(value) + 4 * sizeof(void*);
}

}  // namespace

bool VariableValues::take(std::size_t bytes) {
  bytes_ += bytes;
  is_over_ |= bytes_ > kVariableValueBytes || !input_.take_variable_bytes(bytes);
  return !is_over_;
}

/// Separates two tokens.
bool VariableValues::append(std::string_view piece, std::string& text) {
  if (!take(piece.size())) return false;
  if (!text.empty() && !piece.empty() && is_in_token(text.back()) && is_in_token(piece.front())) {
    text += "/**/";
  }
  text += piece;
  return true;
}

bool VariableValues::expand(const StyleScope& scope, std::string_view value, std::string& text) {
  if (depth_ >= input_.limits().variable_depth) is_over_ = true;
  if (!take(kLookBytes + value.size())) return false;
  ++depth_;
  css::Tokenizer tokens(value, input_.text_poll());
  std::size_t copied = 0;
  bool is_valid = true;
  for (css::Token token = tokens.next(); is_valid && !token.is(css::TokenType::end);
       token = tokens.next()) {
    if (!css::begins_variable(token)) continue;
    const auto begin = static_cast<std::size_t>(token.text.data() - value.data());
    const auto reference = css::take_variable(tokens);
    is_valid = reference && append(value.substr(copied, begin - copied), text) &&
               replace(scope, *reference, text);
    copied = tokens.position();
  }
  --depth_;
  return is_valid && append(value.substr(copied), text);
}

bool VariableValues::replace(const StyleScope& scope, const css::VariableReference& reference,
                             std::string& text) {
  if (append_variable(scope, reference.name, text)) return true;
  // Within a cycle a fallback does not count; without a limit's room nothing does.
  if (cycle_begin_ != kNoCycle || is_over_ || !reference.fallback) return false;
  return expand(scope, *reference.fallback, text);
}

/// The value where the element or the nearest around it declares the property.
bool VariableValues::append_variable(StyleScope scope, std::string_view name, std::string& text) {
  for (; scope; scope = scope.outer()) {
    if (!take(kLookBytes)) return false;
    const Input::Cascaded own = input_.declared_variable(scope.element(), name);
    if (own.value) return append_declared(scope, name, *own.value, text);
    if (own.keyword == css::WideKeyword::initial) return false;
  }
  return false;
}

bool VariableValues::append_declared(const StyleScope& scope, std::string_view name,
                                     std::string_view value, std::string& text) {
  const auto is_this = [&](const Open& open) {
    return open.element == scope.element() && open.name == name;
  };
  const auto found = std::ranges::find_if(open_, is_this);
  if (found != open_.end()) {
    cycle_begin_ = std::min(cycle_begin_, static_cast<std::size_t>(found - open_.begin()));
    return false;
  }
  open_.push_back({scope.element(), name});
  std::string own;
  bool is_valid = expand(scope, value, own);
  open_.pop_back();
  if (cycle_begin_ != kNoCycle && cycle_begin_ <= open_.size()) {
    is_valid = false;
    if (cycle_begin_ == open_.size()) cycle_begin_ = kNoCycle;
  }
  return is_valid && append(own, text);
}

bool Input::take_variable_bytes(std::size_t bytes) {
  variable_bytes_ += bytes;
  return variable_bytes_ <= limits().variable_bytes;
}

std::optional<std::string_view> Input::substituted(const StyleScope& scope,
                                                   std::string_view value) {
  VariableValues values(*this);
  std::string text;
  if (values.expand(scope, value, text)) {
    const auto known = substituted_.find(text);
    if (known != substituted_.end()) return *known;
    if (variable_charge_.add(context_, bytes_of(text), "values of var()")) {
      return *substituted_.insert(std::move(text)).first;
    }
  }
  if (values.is_over()) {
    warn("/variables", scope.element(),
         text::quoted(value.substr(0, 64)) + " of " + tag(scope.element()) +
             " is ignored: its var() exceed a limit: " +
             limit_text(limits(), &Limits::variable_depth, "within each other, ") +
             std::to_string(kVariableValueBytes) + " bytes in one value, " +
             limit_text(limits(), &Limits::variable_bytes,
                        "bytes in all; raise the limit variable-depth or variable-bytes"));
  }
  return std::nullopt;
}

css::UnitSizes Input::unit_sizes(const StyleScope& scope) {
  const void* asked = scope.element().internal_object();
  if (scope.is_of_document() && asked == sized_element_) return unit_sizes_;
  std::vector<StyleScope> scopes;
  for (StyleScope each = scope; each; each = each.outer()) scopes.push_back(each);
  // Many shapes in the same groups share the sizes of these.
  std::size_t known = 0;
  while (known < std::min(sized_.size(), scopes.size()) &&
         sized_[known].element == scopes[scopes.size() - 1 - known].element()) {
    ++known;
  }
  sized_.resize(known);
  css::UnitSizes sizes;
  sizes.viewport = picture_px_;
  if (known > 0) sizes = sized_.back().sizes;
  for (std::size_t i = scopes.size() - known; i-- > 0;) {
    const Cascaded own = cascaded(scopes[i], css::Property::font_size);
    if (own.keyword == css::WideKeyword::initial) sizes.em = css::UnitSizes{}.em;
    const auto size = own.value
                          ? css::font_size_of(*own.value, sizes, !own.is_attribute, text_poll_)
                          : std::nullopt;
    if (size) sizes.em = std::min(*size, limits::kCoordinate);
    if (i + 1 == scopes.size()) sizes.rem = sizes.em;
    sized_.push_back({scopes[i].element(), sizes});
  }
  if (scope.is_of_document()) {
    sized_element_ = asked;
    unit_sizes_ = sizes;
  }
  return sizes;
}

Result<double> Input::length(const StyleScope& scope, std::string_view text, const Box& viewport,
                             Axis axis) {
  SFUMATO_TRY_ASSIGN(const css::Length& length, read_length(text));
  const css::UnitSizes sizes = css::is_relative(length.unit) ? unit_sizes(scope) : css::UnitSizes{};
  return user_length(length, sizes, viewport, axis, text);
}

}  // namespace sfumato::svg
