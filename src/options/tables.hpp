#pragma once

#include <span>

#include "options/option.hpp"
#include "options/settings.hpp"

namespace sfumato::options {

/// All options by which drawings are solved, drawn and written, in the order of the help.
std::span<const Option<Settings>> render_options();

/// Those that bound work; `limit` is set by set_limit().
std::span<const Option<Resources>> resource_options();

/// Those that the C interface alone has: for a new context, and for a new document.
std::span<const Option<ContextSettings>> context_options();
std::span<const Option<DocumentSettings>> document_options();

}  // namespace sfumato::options
