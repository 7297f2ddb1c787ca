#pragma once

#include <zlib.h>

#include <cstddef>
#include <string>

namespace sfumato::hostile {

/// What stands around deflated bytes, as deflateInit2 takes it.
enum class Wrapper { none = -15, zlib = 15, gzip = 15 + 16 };

/// A stream that takes what it packs in pieces.
class Packer {
 public:
  explicit Packer(Wrapper wrapper);
  ~Packer() { deflateEnd(&stream_); }
  Packer(const Packer&) = delete;
  Packer& operator=(const Packer&) = delete;

  /// flush: as deflate() takes it; Z_FINISH with the last piece.
  void add(const std::string& bytes, int flush);
  const std::string& packed() const { return packed_; }

 private:
  z_stream stream_{};
  std::string packed_;
};

/// A byte again and again, packed; `count` of them.
std::string packed_run(Wrapper wrapper, char byte, std::size_t count);

}  // namespace sfumato::hostile
