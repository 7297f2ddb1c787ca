#include "codecs/gunzip.hpp"

#include <zlib.h>

#include <algorithm>
#include <cstddef>

#include "base/limit_error.hpp"
#include "base/try.hpp"
#include "sfumato/base/limits.hpp"

namespace sfumato::codecs {
namespace {

/// zlib's code for gzip with the largest window.
constexpr int kGunzipWindow = 15 + 16;

constexpr std::size_t kFirstBytes = std::size_t{64} << 10;
constexpr std::size_t kTextBytesPerPoll = std::size_t{1} << 20;

/// An inflater that ends with its scope.
class Inflater {
 public:
  explicit Inflater(std::string_view bytes) {
    // zlib's interface is older than const.
    stream_.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
    stream_.avail_in = static_cast<uInt>(bytes.size());
    ready_ = inflateInit2(&stream_, kGunzipWindow) == Z_OK;
  }
  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;
  ~Inflater() {
    if (ready_) inflateEnd(&stream_);
  }

  bool ready() const { return ready_; }

  /// Returns whether another gzip stream follows the finished one, and continues with it.
  bool next_member() {
    const std::string_view rest(reinterpret_cast<const char*>(stream_.next_in), stream_.avail_in);
    return is_gzip(rest) && inflateReset(&stream_) == Z_OK;
  }

  /// Fills `room`. Returns zlib's code and the number of bytes written.
  int fill(char* room, std::size_t size, std::size_t& written) {
    stream_.next_out = reinterpret_cast<Bytef*>(room);
    stream_.avail_out = static_cast<uInt>(size);
    const int code = inflate(&stream_, Z_NO_FLUSH);
    written = size - stream_.avail_out;
    return code;
  }

 private:
  z_stream stream_{};
  bool ready_ = false;
};

Status too_long(const Limits& limits, std::size_t most) {
  if (most == limits.input_bytes) {
    return make_limit_error(
        &Limits::input_bytes,
        "unpacks to more than the limit of " + limit_text(limits, &Limits::input_bytes, "bytes"));
  }
  return make_limit_error(
      &Limits::unpack_ratio,
      "unpacks to " + std::to_string(most) + " bytes and more: more than the limit of " +
          limit_text(limits, &Limits::unpack_ratio, "bytes of each packed byte"));
}

}  // namespace

bool is_gzip(std::string_view bytes) {
  return bytes.starts_with("\x1f\x8b");
}

Result<std::string> gunzip(Context& context, std::string_view bytes, TableMemory& memory) {
  Inflater inflater(bytes);
  if (!inflater.ready()) return make_error(StatusCode::out_of_memory, "no memory to unpack gzip");
  const Limits& limits = context.limits;
  const std::size_t expected = limits.unpack_ratio * bytes.size() + limits::kUnpackedSlack;
  const std::size_t most = std::min(limits.input_bytes, expected);
  std::string text;
  std::size_t size = 0;
  for (int code = Z_OK; code != Z_STREAM_END;) {
    if (context.cancelled()) return context.cancel_status();
    if (size > most) break;
    if (size == text.size()) {
      const std::size_t next = std::min(std::max(2 * size, kFirstBytes), most + 1);
      SFUMATO_TRY(memory.resize(context, text, next));
    }
    std::size_t written = 0;
    const std::size_t room = std::min(text.size() - size, kTextBytesPerPoll);
    code = inflater.fill(&text[size], room, written);
    size += written;
    if (code == Z_STREAM_END && inflater.next_member()) code = Z_OK;
    if (code != Z_OK && code != Z_STREAM_END) {
      return make_error(StatusCode::bad_input, code == Z_BUF_ERROR ? "the gzip data are cut short"
                                                                   : "the gzip data are damaged");
    }
  }
  if (size > most) return too_long(limits, most);
  text.resize(size);
  return text;
}

}  // namespace sfumato::codecs
