#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "sfumato/base/status.hpp"

namespace sfumato {

struct Context;

/// Reads a whole file; "-" is standard input. What has to be waited for (a pipe, a terminal) is
/// waited for until `context`, if any, says to stop.
/// Errors: io; limit where it is longer than max_bytes; those of Context::cancel_status.
Result<std::string> read_file(const std::string& path, std::size_t max_bytes,
                              const Context* context = nullptr);

/// The same as numbers.
Result<std::vector<std::uint8_t>> read_bytes(const std::string& path, std::size_t max_bytes,
                                             const Context* context = nullptr);

/// The path behind symbolic links, which may name nothing yet.
std::string without_links(std::string path);

/// Writes a whole file or nothing: a temporary file in the same folder, fsync, rename, fsync of the
/// folder. "-" is standard output. A symbolic link is followed, an existing mode is kept; what is
/// not a regular file (a pipe, /dev/null) is written in place, and waited for as `read_file` does.
/// Errors: io, those of Context::cancel_status.
Status write_file(const std::string& path, std::span<const std::uint8_t> bytes,
                  const Context* context = nullptr);

}  // namespace sfumato
