#pragma once

#include <string>
#include <string_view>

#include "base/table_memory.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::codecs {

/// Whether the bytes begin as gzip's do.
bool is_gzip(std::string_view bytes);

/// Unpacks gzip, one stream or several one behind the other, up to the limits of an input's bytes
/// and of how many a packed byte may become; bytes behind them are passed over, as gzip does;
/// the text's room comes from `memory`.
/// Errors: bad_input, limit, cancelled, out_of_memory, without a place.
Result<std::string> gunzip(Context& context, std::string_view bytes, TableMemory& memory);

}  // namespace sfumato::codecs
