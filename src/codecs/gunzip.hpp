#pragma once

#include <string>
#include <string_view>

#include "base/table_memory.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::codecs {

/// Returns whether the bytes begin like a gzip file.
bool is_gzip(std::string_view bytes);

/// Unpacks one or several consecutive gzip streams, up to Limits::input_bytes and
/// Limits::unpack_ratio. Bytes after the streams are ignored, as gzip does. The text is charged to
/// `memory`.
/// Errors: bad_input, limit, cancelled, out_of_memory, without a place.
Result<std::string> gunzip(Context& context, std::string_view bytes, TableMemory& memory);

}  // namespace sfumato::codecs
