#include "codecs/deflate.hpp"

#include <zlib.h>

#include <algorithm>
#include <cstddef>

#include "base/charge.hpp"

namespace sfumato::codecs {
namespace {

constexpr int kLevel = 9;

/// Bytes given out at once.
constexpr std::size_t kPiece = std::size_t{64} << 10;
/// Taken in at once; between them the cancel flag is looked at. Where bytes
/// have few values, the best level looks at thousands of places before each: microseconds.
constexpr std::size_t kBytesPerPoll = std::size_t{4} << 10;

/// A deflater that ends with its scope.
class Deflater {
 public:
  Deflater() { ready_ = deflateInit(&stream_, kLevel) == Z_OK; }
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

  /// Appends at most a piece to `out`; true at the end of the stream.
  bool drain(bool is_last, std::vector<std::uint8_t>& out) {
    const std::size_t before = out.size();
    out.resize(before + kPiece);
    stream_.next_out = out.data() + before;
    stream_.avail_out = static_cast<uInt>(kPiece);
    const int code = deflate(&stream_, is_last ? Z_FINISH : Z_NO_FLUSH);
    out.resize(out.size() - stream_.avail_out);
    return code == Z_STREAM_END;
  }

 private:
  z_stream stream_{};
  bool ready_ = false;
};

}  // namespace

Result<std::vector<std::uint8_t>> deflated(Context& context, std::span<const std::uint8_t> bytes) {
  ScopedCharge charge;
  const std::size_t most = compressBound(static_cast<uLong>(bytes.size())) + 2 * kPiece;
  if (Status status = charge.add(context, most, "packed bytes"); !status) return status;
  Deflater deflater;
  if (!deflater.ready()) return make_error(StatusCode::out_of_memory, "no memory to pack bytes");
  std::vector<std::uint8_t> packed;
  std::size_t fed = 0;
  for (bool is_done = false; !is_done;) {
    if (context.cancelled()) return context.cancel_status();
    if (deflater.is_hungry()) {
      const std::size_t size = std::min(kBytesPerPoll, bytes.size() - fed);
      deflater.feed(bytes.subspan(fed, size));
      fed += size;
    }
    is_done = deflater.drain(fed == bytes.size(), packed);
  }
  return packed;
}

}  // namespace sfumato::codecs
