#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/output_buffer.hpp"
#include "sfumato/base/context.hpp"

namespace sfumato::codecs {

/// Writes a ZIP archive whose entries are stored, not packed: PKWARE's APPNOTE 6.3.3, sections 4.3
/// and 4.4. Every entry has the first date of the format, so that the same content gives the same
/// bytes. Errors: as the OutputBuffer, and limit if the entries are too many or the archive is too
/// large for the format's 16 and 32 bits.
class ZipWriter {
 public:
  ZipWriter(const Context& context, OutputBuffer& file) : context_(context), file_(file) {}

  /// Adds an entry that consists of `parts`, one after another.
  void add(std::string_view name, std::span<const std::span<const std::uint8_t>> parts);

  /// Writes the directory. Nothing may be added afterwards.
  void finish();

 private:
  struct Entry {
    std::string name;
    std::uint32_t crc = 0, size = 0, offset = 0;
  };

  std::uint32_t crc_of(std::span<const std::span<const std::uint8_t>> parts);
  void write_common(const Entry& entry);

  const Context& context_;
  OutputBuffer& file_;
  std::vector<Entry> entries_;
};

}  // namespace sfumato::codecs
