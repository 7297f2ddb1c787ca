#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "sfumato/base/limits.hpp"

namespace sfumato {

/// Returns a limit as text for an error: "200000 curves". `what` is a plural.
std::string limit_text(const Limits& limits, std::size_t Limits::*limit, std::string_view what);

/// Makes the error of exceeding a limit. `limit` becomes Status::limit and must have static
/// lifetime.
Status make_limit_error(std::string_view limit, std::string message, SourcePlace where = {});
Status make_limit_error(std::size_t Limits::*limit, std::string message, SourcePlace where = {});

/// Does make_limit_error() with the usual message: "more than the limit of 200000 curves".
Status limit_error(const Limits& limits, std::size_t Limits::*limit, std::string_view what,
                   SourcePlace where = {});

/// Returns whether the Budget or the system had too little memory.
bool is_lack_of_memory(const Status& status);

}  // namespace sfumato
