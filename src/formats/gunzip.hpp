#pragma once

#include <string>
#include <string_view>

#include "base/context.hpp"
#include "base/status.hpp"

namespace sfumato {

/// Whether the bytes begin as gzip's do.
bool is_gzip(std::string_view bytes);

/// Unpacks gzip, up to max_bytes; memory is charged to `charge` before it is taken.
/// Errors: bad_input, limit, out_of_memory, without a place.
Result<std::string> gunzip(Context& context, std::string_view bytes, std::size_t max_bytes,
                           ScopedCharge& charge);

}  // namespace sfumato
