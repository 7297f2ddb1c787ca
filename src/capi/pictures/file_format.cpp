#include "capi/pictures/file_format.hpp"

#include <optional>
#include <string_view>
#include <vector>

#include "formats/text/suggestion.hpp"

namespace sfumato::capi {

Outcome read_format(const char* format, options::OutputKind& kind) {
  if (!format) return bad_usage("NULL given; pass a format");
  const std::optional<options::OutputKind> found = options::kind_of_extension(format);
  if (found) {
    kind = *found;
    return {};
  }
  std::vector<std::string_view> names;
  for (const options::KnownOutput& known : options::known_outputs()) {
    names.push_back(known.extension);
  }
  return bad_usage("unknown format " + text::quoted(format) + text::did_you_mean(format, names));
}

}  // namespace sfumato::capi
