// Style sheets, colours, and what a sheet says of elements.
#include <string_view>

#include "formats/css_color.hpp"
#include "formats/svg/style_sheet.hpp"
#include "fuzz.hpp"

using namespace sfumato;

namespace {

bool lies_in(std::string_view part, std::string_view whole) {
  return part.empty() ||
         (part.data() >= whole.data() && part.data() + part.size() <= whole.data() + whole.size());
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text = fuzz::as_text({data, size});
  svg::StyleSheet sheet;
  sheet.add(text, limits::kStyleValues);
  fuzz::require(sheet.empty() == (sheet.value_count() == 0), "an empty sheet with values");
  for (const char* property : {"fill", "opacity", "display"}) {
    for (const char* classes : {"", "a", " a  b ", "\ta\n"}) {
      const auto value = sheet.find("path", "a", classes, property);
      fuzz::require(!value || lies_in(*value, text), "a value from nowhere");
    }
  }
  // A second sheet is laid over the first.
  const std::size_t count = sheet.value_count();
  sheet.add(text, limits::kStyleValues);
  fuzz::require(sheet.value_count() == 2 * count, "the second reading of a sheet differs");
  if (const Result<CssColor> color = parse_css_color(text)) {
    const auto is_share = [](float x) { return x >= 0 && x <= 1; };
    fuzz::require(is_share(color->color.r) && is_share(color->color.g) &&
                      is_share(color->color.b) && is_share(color->alpha),
                  "a colour out of range");
  } else {
    fuzz::require_honest(color.status());
  }
  return 0;
}
