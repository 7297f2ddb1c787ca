#pragma once

#include "capi/call.hpp"
#include "options/output_kind.hpp"

namespace sfumato::capi {

/// Returns the kind of a format's name such as "png". Errors: bad usage, with the name that was
/// probably meant.
Outcome read_format(const char* format, options::OutputKind& kind);

}  // namespace sfumato::capi
