#include <zlib.h>

#include <algorithm>
#include <cstring>
#include <initializer_list>
#include <memory>
#include <new>
#include <string>
#include <utility>

#include "base/charge.hpp"
#include "base/parallel.hpp"
#include "base/public_verb.hpp"
#include "codecs/png_filter.hpp"
#include "sfumato/base/limits.hpp"
#include "sfumato/codecs/png.hpp"

namespace sfumato {
namespace {

constexpr std::uint8_t kSignature[] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
constexpr std::size_t kHeadBytes = 64;  // at least: signature, IHDR, sRGB
constexpr std::uint8_t kTrueColor = 2;
constexpr std::uint8_t kTrueColorAlpha = 6;
constexpr std::uint8_t kPerceptual = 0;

/// Filtered bytes of one stripe, which is packed by itself into one IDAT chunk. The cut depends on
/// the image alone, so that its bytes do not depend on the number of threads.
constexpr std::size_t kStripeBytes = std::size_t{1} << 17;
/// Filtered bytes of the stripes that are in work at one time.
constexpr std::size_t kWaveBytes = std::size_t{1} << 24;

using Bytes = std::vector<std::uint8_t>;

void append_big_endian(std::uint32_t value, Bytes& out) {
  for (int shift = 24; shift >= 0; shift -= 8)
    out.push_back(static_cast<std::uint8_t>(value >> shift));
}

/// Appends a chunk whose data append_data(out) appends.
template <class AppendData>
void append_chunk(const char* type, Bytes& out, AppendData append_data) {
  const std::size_t begin = out.size();
  append_big_endian(0, out);
  out.insert(out.end(), type, type + 4);
  append_data(out);
  const std::size_t length = out.size() - begin - 8;
  for (std::size_t i = 0; i < 4; ++i) {
    out[begin + i] = static_cast<std::uint8_t>(length >> (24 - 8 * i));
  }
  append_big_endian(
      static_cast<std::uint32_t>(crc32(0, &out[begin + 4], static_cast<uInt>(length + 4))), out);
}

struct EndDeflate {
  void operator()(z_stream* stream) const { deflateEnd(stream); }
};

/// Appends `bytes` as deflate blocks of which none is the last, ended on a whole byte, so that
/// stripes made apart may be joined. Z_RLE, made for PNG, packs smooth images nearly as small as
/// level 6 in a sixth of its time.
void append_deflate_blocks(Bytes& bytes, Bytes& out) {
  z_stream stream{};
  if (deflateInit2(&stream, 1, Z_DEFLATED, -MAX_WBITS, MAX_MEM_LEVEL, Z_RLE) != Z_OK) {
    throw std::bad_alloc();
  }
  const std::unique_ptr<z_stream, EndDeflate> end(&stream);
  const std::size_t begin = out.size();
  constexpr std::size_t kSyncMarker = 16;
  out.resize(begin + deflateBound(&stream, static_cast<uLong>(bytes.size())) + kSyncMarker);
  stream.next_in = bytes.data();
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = &out[begin];
  stream.avail_out = static_cast<uInt>(out.size() - begin);
  deflate(&stream, Z_SYNC_FLUSH);
  out.resize(out.size() - stream.avail_out);
}

struct Stripe {
  Bytes chunk;
  std::uint32_t adler = 1;
  std::size_t filtered_bytes = 0;
};

class Encoder {
 public:
  Encoder(Context& context, const Image& image)
      : context_(context),
        image_(image),
        row_bytes_(image.row_bytes()),
        rows_per_stripe_((kStripeBytes + row_bytes_) / (row_bytes_ + 1)) {}

  Result<Bytes> encode();

 private:
  Status encode_wave(std::size_t first_stripe, std::size_t stripe_count);
  Stripe encode_stripe(std::size_t index) const;
  Bytes filtered(std::size_t first_row, std::size_t end_row) const;
  /// A row in the byte order of PNG: the image's own, or `scratch` with it.
  const std::uint8_t* row(std::size_t y, Bytes& scratch) const;
  Bytes head() const;
  void finish_data();
  Result<Bytes> joined_parts();

  Context& context_;
  const Image& image_;
  std::size_t row_bytes_;
  std::size_t rows_per_stripe_;
  std::vector<Bytes> parts_;
  ScopedCharge charge_;
  std::uint32_t adler_ = 1;
};

Result<Bytes> Encoder::encode() {
  const std::size_t stripe_bytes = rows_per_stripe_ * (row_bytes_ + 1);
  const std::size_t wave_stripes = std::max<std::size_t>(1, kWaveBytes / stripe_bytes);
  const auto rows = static_cast<std::size_t>(image_.height);
  const std::size_t stripe_count = (rows + rows_per_stripe_ - 1) / rows_per_stripe_;
  // Filtered and packed bytes of a wave; packed ones are never much longer.
  const std::size_t work_bytes = 3 * std::min(stripe_count, wave_stripes) * stripe_bytes;
  if (Status status = charge_.add(context_, work_bytes, "writing a PNG"); !status) return status;
  parts_.push_back(head());
  for (std::size_t first = 0; first < stripe_count; first += wave_stripes) {
    Status status = encode_wave(first, std::min(wave_stripes, stripe_count - first));
    if (status) status = charge_.add(context_, parts_.back().size(), "a PNG");
    if (!status) return status;
  }
  finish_data();
  return joined_parts();
}

Status Encoder::encode_wave(std::size_t first_stripe, std::size_t stripe_count) {
  std::vector<Stripe> stripes(stripe_count);
  Status status = parallel_for(context_, stripe_count, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) stripes[i] = encode_stripe(first_stripe + i);
  });
  if (!status) return status;
  Bytes& part = parts_.emplace_back();
  std::size_t size = 0;
  for (const Stripe& stripe : stripes) size += stripe.chunk.size();
  part.reserve(size);
  for (const Stripe& stripe : stripes) {
    part.insert(part.end(), stripe.chunk.begin(), stripe.chunk.end());
    adler_ = static_cast<std::uint32_t>(
        adler32_combine(adler_, stripe.adler, static_cast<z_off_t>(stripe.filtered_bytes)));
  }
  return status;
}

Stripe Encoder::encode_stripe(std::size_t index) const {
  const std::size_t first_row = index * rows_per_stripe_;
  const std::size_t end_row =
      std::min(first_row + rows_per_stripe_, static_cast<std::size_t>(image_.height));
  Bytes bytes = filtered(first_row, end_row);
  Stripe stripe;
  stripe.filtered_bytes = bytes.size();
  stripe.adler =
      static_cast<std::uint32_t>(adler32(1, bytes.data(), static_cast<uInt>(bytes.size())));
  append_chunk("IDAT", stripe.chunk, [&](Bytes& out) {
    // zlib's header: deflate with a window of 32 KiB, fast.
    if (index == 0) {
      out.push_back(0x78);
      out.push_back(0x01);
    }
    append_deflate_blocks(bytes, out);
  });
  return stripe;
}

Bytes Encoder::filtered(std::size_t first_row, std::size_t end_row) const {
  const int pixel_bytes = channel_count(image_.format) * bytes_per_channel(image_.format);
  codecs::PngFilter filter(row_bytes_, static_cast<std::size_t>(pixel_bytes));
  Bytes bytes((end_row - first_row) * (row_bytes_ + 1));
  Bytes current_scratch;
  Bytes previous_scratch(first_row == 0 ? row_bytes_ : 0);
  const std::uint8_t* previous =
      first_row == 0 ? previous_scratch.data() : row(first_row - 1, previous_scratch);
  for (std::size_t y = first_row; y < end_row; ++y) {
    const std::uint8_t* current = row(y, current_scratch);
    filter.filter(current, previous, &bytes[(y - first_row) * (row_bytes_ + 1)]);
    previous = current;
    std::swap(current_scratch, previous_scratch);
  }
  return bytes;
}

const std::uint8_t* Encoder::row(std::size_t y, Bytes& scratch) const {
  const std::uint8_t* source = &image_.bytes[y * row_bytes_];
  if (bytes_per_channel(image_.format) == 1) return source;
  scratch.resize(row_bytes_);
  for (std::size_t i = 0; i < row_bytes_; i += 2) {
    std::uint16_t value;
    std::memcpy(&value, source + i, 2);
    scratch[i] = static_cast<std::uint8_t>(value >> 8);
    scratch[i + 1] = static_cast<std::uint8_t>(value);
  }
  return scratch.data();
}

Bytes Encoder::head() const {
  Bytes out;
  out.reserve(kHeadBytes);
  out.insert(out.end(), std::begin(kSignature), std::end(kSignature));
  append_chunk("IHDR", out, [&](Bytes& data) {
    append_big_endian(static_cast<std::uint32_t>(image_.width), data);
    append_big_endian(static_cast<std::uint32_t>(image_.height), data);
    const int depth = 8 * bytes_per_channel(image_.format);
    const std::uint8_t color_type =
        channel_count(image_.format) == 3 ? kTrueColor : kTrueColorAlpha;
    data.insert(data.end(), {static_cast<std::uint8_t>(depth), color_type, 0, 0, 0});
  });
  append_chunk("sRGB", out, [](Bytes& data) { data.push_back(kPerceptual); });
  return out;
}

void Encoder::finish_data() {
  Bytes& out = parts_.emplace_back();
  append_chunk("IDAT", out, [&](Bytes& data) {
    data.push_back(3);  // with the next byte an empty last block
    data.push_back(0);
    append_big_endian(adler_, data);
  });
  append_chunk("IEND", out, [](Bytes&) {});
}

/// One text of all parts; each part's memory is given back as soon as it is copied.
Result<Bytes> Encoder::joined_parts() {
  std::size_t size = 0;
  for (const Bytes& part : parts_) size += part.size();
  Bytes joined;
  joined.reserve(size);
  for (Bytes& part : parts_) {
    if (context_.cancelled()) return context_.cancel_status();
    joined.insert(joined.end(), part.begin(), part.end());
    part = Bytes();
  }
  return joined;
}

Result<Bytes> encode(Context& context, const Image& image) {
  if (Status status = validate(context.limits, image); !status) return status;
  return Encoder(context, image).encode();
}

}  // namespace

Result<std::vector<std::uint8_t>> encode_png(Context& context, const Image& image) {
  return public_verb(context, [&] { return encode(context, image); });
}

}  // namespace sfumato
