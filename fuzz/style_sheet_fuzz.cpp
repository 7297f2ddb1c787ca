// Style sheets, style attributes, colours, and the values of a sheet for elements.
#include <string>
#include <string_view>

#include "formats/css/color.hpp"
#include "formats/css/media.hpp"
#include "formats/css/style_sheet.hpp"
#include "formats/css/value.hpp"
#include "fuzz.hpp"

using namespace sfumato;

namespace {

css::TextPoll no_poll;

bool lies_in(std::string_view part, std::string_view whole) {
  return part.empty() ||
         (part.data() >= whole.data() && part.data() + part.size() <= whole.data() + whole.size());
}

/// Requires that the tokens follow each other, with only comments between.
void check_tokens(std::string_view text) {
  css::Tokenizer tokens(text, no_poll);
  std::size_t at = 0;
  for (;;) {
    const css::Token token = tokens.next();
    fuzz::require(lies_in(token.text, text) && lies_in(token.value, token.text) &&
                      lies_in(token.unit, token.text),
                  "a token from nowhere");
    const auto begin = static_cast<std::size_t>(token.text.data() - text.data());
    const std::string_view between = text.substr(at, begin - at);
    fuzz::require(between.empty() || between.starts_with("/*"), "text is passed over");
    at = begin + token.text.size();
    fuzz::require(at == tokens.position(), "a token does not end where the next begins");
    if (token.is(css::TokenType::end)) break;
    fuzz::require(!token.text.empty(), "an empty token");
    css::unescaped(token.value);
  }
  fuzz::require(at == text.size(), "a text that does not end");
}

void check_style(std::string_view text) {
  css::Style style;
  css::Tokenizer tokens(text, no_poll);
  css::read_declarations(tokens, false, [&](const css::Declaration& declaration) {
    fuzz::require(lies_in(declaration.name, text) && lies_in(declaration.value, text),
                  "a declaration from nowhere");
    style.add(declaration, no_poll);
  });
  fuzz::require(tokens.position() == text.size(), "declarations that do not end");
  for (std::size_t i = 0; i < css::kPropertyCount; ++i) {
    const auto property = static_cast<css::Property>(i);
    fuzz::require(!style[property] || css::is_value(property, style[property]->value, no_poll),
                  "a value that CSS drops");
  }
  css::media_of(text, no_poll);
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text = fuzz::as_text({data, size});
  check_tokens(text);
  check_style(text);
  css::StyleSheet sheet;
  sheet.add(text, limits::kStyleValues, no_poll);
  fuzz::require(sheet.empty() || sheet.value_count() > 0, "values without a count");
  for (const css::Property property :
       {css::Property::fill, css::Property::opacity, css::Property::display}) {
    for (const char* classes : {"", "a", " a  b ", "\ta\n"}) {
      const auto found = sheet.find("path", "a", classes, {property});
      fuzz::require(!found || lies_in(found->setting.value, text), "a value from nowhere");
    }
  }
  // A second sheet is added over the first.
  const std::size_t count = sheet.value_count();
  sheet.add(text, limits::kStyleValues, no_poll);
  fuzz::require(count > limits::kStyleValues || sheet.value_count() == 2 * count ||
                    sheet.value_count() > limits::kStyleValues,
                "the second reading of a sheet differs");
  if (const Result<css::Color> color = css::parse_color(text)) {
    const auto is_share = [](float x) { return x >= 0 && x <= 1; };
    fuzz::require(is_share(color->color.r) && is_share(color->color.g) &&
                      is_share(color->color.b) && is_share(color->alpha),
                  "a colour out of range");
  } else {
    fuzz::require_honest(color.status());
  }
  return 0;
}
