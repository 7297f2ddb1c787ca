#pragma once

#include <span>

#include "options/option.hpp"
#include "options/settings.hpp"

namespace sfumato::options {

/// All options by which drawings are solved, drawn and written, in the order of the help.
std::span<const Option<Settings>> render_options();

/// Those that bound work; `limit` is set by set_limit().
std::span<const Option<Resources>> resource_options();

/// Those by which pictures are traced, in the order of the help.
std::span<const Option<TraceSettings>> trace_options();

/// Those that the C interface alone has from here: for a new context, for a new document, for a
/// picture, and for hints.
std::span<const Option<ContextSettings>> context_options();
std::span<const Option<PictureSettings>> picture_options();
std::span<const Option<LintSettings>> lint_options();
std::span<const Option<DocumentSettings>> document_options();

}  // namespace sfumato::options
