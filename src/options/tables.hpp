#pragma once

#include <span>

#include "options/option.hpp"
#include "options/settings.hpp"

namespace sfumato::options {

/// Returns all options for solving, drawing and writing drawings, in the order of the help.
std::span<const Option<Settings>> render_options();

/// Returns the options that bound work; set_limit() sets `limit`.
std::span<const Option<Resources>> resource_options();

/// Returns the options for tracing pictures, in the order of the help.
std::span<const Option<TraceSettings>> trace_options();

/// The following options belong to the C interface alone: for a new context, a new document, a
/// picture, and hints.
std::span<const Option<ContextSettings>> context_options();
std::span<const Option<PictureSettings>> picture_options();
std::span<const Option<LintSettings>> lint_options();
std::span<const Option<DocumentSettings>> document_options();

}  // namespace sfumato::options
