#include "formats/gunzip.hpp"

#include <zlib.h>

#include <algorithm>
#include <cstddef>

namespace sfumato {
namespace {

/// zlib's code for gzip with the largest window.
constexpr int kGzipWindow = 15 + 16;

constexpr std::size_t kFirstBytes = std::size_t{64} << 10;

/// An inflater that ends with its scope.
class Inflater {
 public:
  explicit Inflater(std::string_view bytes) {
    // zlib's interface is older than const.
    stream_.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
    stream_.avail_in = static_cast<uInt>(bytes.size());
    ready_ = inflateInit2(&stream_, kGzipWindow) == Z_OK;
  }
  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;
  ~Inflater() {
    if (ready_) inflateEnd(&stream_);
  }

  bool ready() const { return ready_; }

  /// Fills `room`; returns zlib's code and how much was written.
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

}  // namespace

bool is_gzip(std::string_view bytes) {
  return bytes.starts_with("\x1f\x8b");
}

Result<std::string> gunzip(Context& context, std::string_view bytes, std::size_t max_bytes,
                           ScopedCharge& charge) {
  Inflater inflater(bytes);
  if (!inflater.ready()) return make_error(StatusCode::out_of_memory, "no memory to unpack gzip");
  std::string text;
  std::size_t size = 0;
  for (;;) {
    if (size > max_bytes) {
      return make_error(StatusCode::limit, "unpacks to more than the limit of " +
                                               std::to_string(max_bytes) + " bytes");
    }
    if (size == text.size()) {
      const std::size_t next = std::clamp(2 * size, kFirstBytes, max_bytes + 1);
      if (Status status = charge.add(context, next, "unpacked gzip"); !status) return status;
      text.resize(next);
    }
    std::size_t written = 0;
    const int code = inflater.fill(&text[size], text.size() - size, written);
    size += written;
    if (code == Z_STREAM_END) break;
    if (code != Z_OK) {
      return make_error(StatusCode::bad_input, code == Z_BUF_ERROR ? "the gzip data are cut short"
                                                                   : "the gzip data are damaged");
    }
  }
  if (size > max_bytes) {
    return make_error(StatusCode::limit,
                      "unpacks to more than the limit of " + std::to_string(max_bytes) + " bytes");
  }
  text.resize(size);
  return text;
}

}  // namespace sfumato
