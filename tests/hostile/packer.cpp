#include "hostile/packer.hpp"

#include <algorithm>
#include <cstdint>

namespace sfumato::hostile {
namespace {

std::string little_end_first(std::uint32_t value) {
  std::string bytes;
  for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(value >> shift);
  return bytes;
}

/// Returns raw deflate data, ended by `flush`.
std::string deflated(const std::string& bytes, int flush) {
  Packer packer(Wrapper::none);
  packer.add(bytes, flush);
  return packer.packed();
}

/// The checksum after deflated bytes: CRC-32 in gzip, Adler-32 in zlib.
class Checksum {
 public:
  explicit Checksum(bool is_crc) : is_crc_(is_crc), value_(is_crc ? 0 : 1) {}

  /// Adds the same bytes so many times.
  void add(const std::string& bytes, std::size_t times) {
    const auto* data = reinterpret_cast<const Bytef*>(bytes.data());
    const auto size = static_cast<uInt>(bytes.size());
    const uLong once = is_crc_ ? crc32(0, data, size) : adler32(1, data, size);
    const auto length = static_cast<z_off_t>(size);
    for (std::size_t i = 0; i < times; ++i) {
      value_ =
          is_crc_ ? crc32_combine(value_, once, length) : adler32_combine(value_, once, length);
    }
  }
  std::uint32_t value() const { return static_cast<std::uint32_t>(value_); }

 private:
  bool is_crc_;
  uLong value_;
};

}  // namespace

Packer::Packer(Wrapper wrapper) {
  deflateInit2(&stream_, 9, Z_DEFLATED, static_cast<int>(wrapper), 9, Z_DEFAULT_STRATEGY);
}

void Packer::add(const std::string& bytes, int flush) {
  stream_.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream_.avail_in = static_cast<uInt>(bytes.size());
  do {
    char room[65536];
    stream_.next_out = reinterpret_cast<Bytef*>(room);
    stream_.avail_out = sizeof(room);
    deflate(&stream_, flush);
    packed_.append(room, sizeof(room) - stream_.avail_out);
  } while (stream_.avail_out == 0);
}

std::string packed_run(Wrapper wrapper, char byte, std::size_t count) {
  const std::string block(std::size_t{8} << 20, byte);
  const std::size_t block_count = count / block.size();
  const std::string rest = block.substr(0, count % block.size());
  const bool is_gzip = wrapper == Wrapper::gzip;
  Checksum checksum(is_gzip);
  checksum.add(block, block_count);
  checksum.add(rest, 1);
  // Blocks that restart compression are packed to equal bytes, so a gibibyte takes no longer than
  // one of them.
  const std::string packed_block = block_count > 0 ? deflated(block, Z_FULL_FLUSH) : std::string();
  std::string packed =
      is_gzip ? std::string("\x1f\x8b\x08\0\0\0\0\0\x02\x03", 10) : std::string("\x78\xda");
  for (std::size_t i = 0; i < block_count; ++i) packed += packed_block;
  packed += deflated(rest, Z_FINISH);
  if (!is_gzip) {
    std::string adler = little_end_first(checksum.value());
    std::reverse(adler.begin(), adler.end());
    return packed + adler;
  }
  return packed + little_end_first(checksum.value()) +
         little_end_first(static_cast<std::uint32_t>(count));
}

}  // namespace sfumato::hostile
