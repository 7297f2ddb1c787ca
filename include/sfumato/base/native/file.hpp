#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "sfumato/base/status.hpp"

namespace sfumato {

struct Context;

/// Reads a whole file; "-" is standard input. Where reading has to wait (a pipe, a terminal), it
/// waits until `context`, unless that is null, is cancelled.
///
/// Errors: io; limit (longer than `max_bytes`); as Context::cancel_status(); out_of_memory.
Result<std::string> read_file(const std::string& path, std::size_t max_bytes,
                              const Context* context = nullptr);

/// Does read_file(), with the content as bytes instead of text.
Result<std::vector<std::uint8_t>> read_bytes(const std::string& path, std::size_t max_bytes,
                                             const Context* context = nullptr);

/// Returns the path with symbolic links at its end followed, at most 40 of them. The result may
/// name a file that does not exist yet.
std::string without_links(std::string path);

/// Writes a whole file or leaves it unchanged: writes a temporary file in the same folder, syncs
/// it, renames it, and syncs the folder. "-" is standard output. A symbolic link is followed, and
/// an existing file keeps its mode. A pipe, /dev/null and everything else that is not a regular
/// file is written in place. Where that has to wait, it waits until `context`, unless that is null,
/// is cancelled.
///
/// Errors: io, as Context::cancel_status(), out_of_memory.
Status write_file(const std::string& path, std::span<const std::uint8_t> bytes,
                  const Context* context = nullptr);

}  // namespace sfumato
