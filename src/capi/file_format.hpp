#pragma once

#include "capi/call.hpp"
#include "options/output_kind.hpp"

namespace sfumato::capi {

/// The kind that a format's name stands for, as "png". Errors: bad usage, with what was probably
/// meant.
Outcome read_format(const char* format, options::OutputKind& kind);

}  // namespace sfumato::capi
