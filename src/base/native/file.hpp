#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/status.hpp"

namespace sfumato {

/// Reads a whole file; "-" is standard input. Errors: io; limit where it is longer than max_bytes.
Result<std::string> read_file(const std::string& path, std::size_t max_bytes);

/// The same as numbers.
Result<std::vector<std::uint8_t>> read_bytes(const std::string& path, std::size_t max_bytes);

/// Writes a whole file or nothing: a temporary file in the same folder, fsync, rename, fsync of the
/// folder. "-" is standard output. A symbolic link is followed, an existing mode is kept; what is
/// not a regular file (a pipe, /dev/null) is written in place. Errors: io.
Status write_file(const std::string& path, std::span<const std::uint8_t> bytes);

}  // namespace sfumato
