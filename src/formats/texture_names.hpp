#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::formats {

/// Calls `visit` for every file that a pattern of the document names, once for each <image>, with
/// the name that a ResourceLoader would get, even if the pattern is not used. Opens no file. Only
/// SVG (docs/format.md) names files. Errors: bad_input if the text is not XML, limit, cancelled,
/// out_of_memory; some files may have been visited then.
Status visit_texture_names(Context& context, std::string_view bytes, const std::string& file,
                           const std::function<void(const std::string& name)>& visit);

}  // namespace sfumato::formats
