#pragma once

#include <string>
#include <string_view>

namespace sfumato::outputs {

/// Text as the content of an element or an attribute in double quotes; control characters, which
/// HTML does not allow, become blanks.
std::string escaped_html(std::string_view text);

}  // namespace sfumato::outputs
