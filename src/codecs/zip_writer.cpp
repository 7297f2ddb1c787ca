#include "codecs/zip_writer.hpp"

#include <zlib.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace sfumato::codecs {
namespace {

constexpr std::uint32_t kLocalHeader = 0x04034b50, kDirectoryEntry = 0x02014b50;
constexpr std::uint32_t kDirectoryEnd = 0x06054b50;
constexpr std::uint16_t kVersion = 10;      // 1.0: stored files
constexpr std::uint16_t kFirstDate = 0x21;  // 1 January 1980
constexpr std::size_t kMost16 = std::numeric_limits<std::uint16_t>::max();
constexpr std::size_t kMost32 = std::numeric_limits<std::uint32_t>::max();
/// Bytes between two polls of the cancel flag.
constexpr std::size_t kPartBytesPerPoll = std::size_t{1} << 20;

void put16(OutputBuffer& file, std::uint32_t value) {
  file.push_back(static_cast<std::uint8_t>(value));
  file.push_back(static_cast<std::uint8_t>(value >> 8));
}

void put32(OutputBuffer& file, std::uint32_t value) {
  put16(file, value);
  put16(file, value >> 16);
}

}  // namespace

std::uint32_t ZipWriter::crc_of(std::span<const std::span<const std::uint8_t>> parts) {
  uLong crc = crc32(0, nullptr, 0);
  for (std::span<const std::uint8_t> part : parts) {
    while (!part.empty()) {
      if (context_.cancelled()) {
        file_.fail(context_.cancel_status());
        return 0;
      }
      const std::size_t taken = std::min(kPartBytesPerPoll, part.size());
      crc = crc32(crc, part.data(), static_cast<uInt>(taken));
      part = part.subspan(taken);
    }
  }
  return static_cast<std::uint32_t>(crc);
}

/// Appends the fields that the header of an entry and its line in the directory share.
void ZipWriter::write_common(const Entry& entry) {
  put16(file_, kVersion);
  put16(file_, 0);  // no flags
  put16(file_, 0);  // stored
  put16(file_, 0);  // midnight
  put16(file_, kFirstDate);
  put32(file_, entry.crc);
  put32(file_, entry.size);
  put32(file_, entry.size);
  put16(file_, static_cast<std::uint32_t>(entry.name.size()));
  put16(file_, 0);  // no further fields
}

void ZipWriter::add(std::string_view name, std::span<const std::span<const std::uint8_t>> parts) {
  std::size_t size = 0;
  for (const auto& part : parts) size += part.size();
  if (size > kMost32 || file_.size() > kMost32 || entries_.size() == kMost16) {
    file_.fail(make_error(StatusCode::limit, "more than a ZIP archive holds: 4 GiB, 65,535 files"));
    return;
  }
  Entry entry{std::string(name), crc_of(parts), static_cast<std::uint32_t>(size),
              static_cast<std::uint32_t>(file_.size())};
  put32(file_, kLocalHeader);
  write_common(entry);
  file_ += entry.name;
  for (const auto& part : parts) file_.append(part);
  entries_.push_back(std::move(entry));
}

void ZipWriter::finish() {
  const std::size_t start = file_.size();
  if (start > kMost32) {
    file_.fail(make_error(StatusCode::limit, "more than a ZIP archive holds: 4 GiB"));
    return;
  }
  for (const Entry& entry : entries_) {
    put32(file_, kDirectoryEntry);
    put16(file_, kVersion);
    write_common(entry);
    put16(file_, 0);  // no comment
    put16(file_, 0);  // the first and only volume
    put16(file_, 0);  // binary
    put32(file_, 0);  // no attributes
    put32(file_, entry.offset);
    file_ += entry.name;
  }
  const auto count = static_cast<std::uint32_t>(entries_.size());
  put32(file_, kDirectoryEnd);
  put16(file_, 0);  // this volume, and that of the directory
  put16(file_, 0);
  put16(file_, count);
  put16(file_, count);
  put32(file_, static_cast<std::uint32_t>(file_.size() - start - 12));
  put32(file_, static_cast<std::uint32_t>(start));
  put16(file_, 0);  // no comment
}

}  // namespace sfumato::codecs
