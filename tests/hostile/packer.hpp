#pragma once

#include <zlib.h>

#include <cstddef>
#include <string>

namespace sfumato::hostile {

/// The container of deflated bytes, as a parameter of deflateInit2.
enum class Wrapper { none = -15, zlib = 15, gzip = 15 + 16 };

/// A stream that packs its input in pieces.
class Packer {
 public:
  explicit Packer(Wrapper wrapper);
  ~Packer() { deflateEnd(&stream_); }
  Packer(const Packer&) = delete;
  Packer& operator=(const Packer&) = delete;

  /// flush: as for deflate(); Z_FINISH with the last piece.
  void add(const std::string& bytes, int flush);
  const std::string& packed() const { return packed_; }

 private:
  z_stream stream_{};
  std::string packed_;
};

/// Returns `count` copies of a byte, packed.
std::string packed_run(Wrapper wrapper, char byte, std::size_t count);

}  // namespace sfumato::hostile
