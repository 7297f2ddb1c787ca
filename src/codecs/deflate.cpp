#include "codecs/deflate.hpp"

#include <zlib.h>

#include <algorithm>
#include <cstddef>

#include "base/try.hpp"

namespace sfumato::codecs {
namespace {

constexpr int kLevel = 9;
/// zlib's default.
constexpr int kMemoryLevel = 8;
/// The largest window; adding 16 makes a gzip file.
constexpr int kZlibWindow = MAX_WBITS;
constexpr int kGzipWindow = MAX_WBITS + 16;

/// The result grows by at least this many bytes.
constexpr std::size_t kPiece = std::size_t{64} << 10;
/// Bytes of input between two polls of the cancel flag. If bytes have few values, the best level
/// searches thousands of earlier places for each byte, which takes microseconds.
constexpr std::size_t kBytesPerPoll = std::size_t{1} << 10;

/// A deflater that ends with its scope.
class Deflater {
 public:
  explicit Deflater(int window_bits) {
    ready_ = deflateInit2(&stream_, kLevel, Z_DEFLATED, window_bits, kMemoryLevel,
                          Z_DEFAULT_STRATEGY) == Z_OK;
  }
  Deflater(const Deflater&) = delete;
  Deflater& operator=(const Deflater&) = delete;
  ~Deflater() {
    if (ready_) deflateEnd(&stream_);
  }

  bool ready() const { return ready_; }
  bool is_hungry() const { return stream_.avail_in == 0; }

  void feed(std::span<const std::uint8_t> bytes) {
    // zlib's interface is older than const.
    stream_.next_in = const_cast<Bytef*>(bytes.data());
    stream_.avail_in = static_cast<uInt>(bytes.size());
  }

  /// Writes to `room` and sets `written`. Returns true at the end of the stream.
  bool drain(bool is_last, std::span<std::uint8_t> room, std::size_t& written) {
    stream_.next_out = room.data();
    stream_.avail_out = static_cast<uInt>(room.size());
    const int code = deflate(&stream_, is_last ? Z_FINISH : Z_NO_FLUSH);
    written = room.size() - stream_.avail_out;
    return code == Z_STREAM_END;
  }

 private:
  z_stream stream_{};
  bool ready_ = false;
};

Result<std::vector<std::uint8_t>> packed_by(const Context& context, int window_bits,
                                            std::span<const std::uint8_t> bytes,
                                            TableMemory& memory) {
  Deflater deflater(window_bits);
  if (!deflater.ready()) return make_error(StatusCode::out_of_memory, "no memory to pack bytes");
  std::vector<std::uint8_t> packed;
  std::size_t fed = 0, size = 0;
  for (bool is_done = false; !is_done;) {
    if (context.cancelled()) return context.cancel_status();
    if (size == packed.size()) {
      const std::size_t larger = size + std::max(size / 2, kPiece);
      SFUMATO_TRY(memory.resize(context, packed, larger));
    }
    if (deflater.is_hungry()) {
      const std::size_t taken = std::min(kBytesPerPoll, bytes.size() - fed);
      deflater.feed(bytes.subspan(fed, taken));
      fed += taken;
    }
    const auto room = std::span(packed).subspan(size, std::min(kPiece, packed.size() - size));
    std::size_t written = 0;
    is_done = deflater.drain(fed == bytes.size(), room, written);
    size += written;
  }
  packed.resize(size);
  return packed;
}

}  // namespace

Result<std::vector<std::uint8_t>> deflated(const Context& context,
                                           std::span<const std::uint8_t> bytes,
                                           TableMemory& memory) {
  return packed_by(context, kZlibWindow, bytes, memory);
}

Result<std::vector<std::uint8_t>> gzipped(const Context& context,
                                          std::span<const std::uint8_t> bytes,
                                          TableMemory& memory) {
  return packed_by(context, kGzipWindow, bytes, memory);
}

}  // namespace sfumato::codecs
