#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <initializer_list>
#include <utility>

#include "base/parallel.hpp"
#include "base/public_verb.hpp"
#include "base/table_memory.hpp"
#include "base/try.hpp"
#include "codecs/png/png_filter.hpp"
#include "codecs/png/png_pack.hpp"
#include "sfumato/base/limits.hpp"
#include "sfumato/codecs/png.hpp"

namespace sfumato {
namespace {

constexpr std::uint8_t kSignature[] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
constexpr std::size_t kEndBytes = 64;  // at least: signature, IHDR, sRGB; the last IDAT, IEND
/// Length, type and CRC of a chunk.
constexpr std::size_t kChunkOverhead = 12;
/// zlib's header: deflate with a window of 32 KiB, fast.
constexpr std::array<std::uint8_t, 2> kDeflateHead{0x78, 0x01};
constexpr std::uint8_t kTrueColor = 2;
constexpr std::uint8_t kTrueColorAlpha = 6;
constexpr std::uint8_t kPerceptual = 0;

/// Filtered bytes of one stripe, which is packed separately into one IDAT chunk. The division into
/// stripes depends on the image alone, so that the file does not depend on the number of threads.
constexpr std::size_t kStripeBytes = codecs::kPackBlockBytes;
/// Filtered bytes of all stripes that are processed at one time.
constexpr std::size_t kWaveBytes = std::size_t{1} << 24;

using Bytes = std::vector<std::uint8_t>;

void append_big_endian(std::uint32_t value, Bytes& out) {
  for (int shift = 24; shift >= 0; shift -= 8)
    out.push_back(static_cast<std::uint8_t>(value >> shift));
}

/// Appends a chunk; append_data(out) appends its data.
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

struct Stripe {
  TableMemory memory{"a PNG"};  // a separate Context: stripes are made in parallel
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
        rows_per_stripe_(std::max<std::size_t>(1, kStripeBytes / (row_bytes_ + 1))) {}

  Result<Bytes> encode();

 private:
  Status encode_wave(std::size_t first_stripe, std::size_t stripe_count);
  Status encode_stripe(std::size_t index, Stripe& stripe) const;
  Status filter_rows(std::size_t first_row, std::size_t end_row, TableMemory& memory,
                     Bytes& filtered) const;
  /// Returns a row in the byte order of PNG: the image's own row, or a copy in `scratch`, which is
  /// as long as a row.
  const std::uint8_t* row(std::size_t y, Bytes& scratch) const;
  Status write_head();
  Status write_tail();
  Result<Bytes> joined_parts();

  Context& context_;
  const Image& image_;
  std::size_t row_bytes_;
  std::size_t rows_per_stripe_;
  std::vector<Bytes> parts_;
  TableMemory memory_{"a PNG"};  ///< of parts_, and of the packed parts
  std::uint32_t adler_ = 1;
};

Result<Bytes> Encoder::encode() {
  const std::size_t stripe_bytes = rows_per_stripe_ * (row_bytes_ + 1);
  const std::size_t wave_stripes = std::max<std::size_t>(1, kWaveBytes / stripe_bytes);
  const auto rows = static_cast<std::size_t>(image_.height);
  const std::size_t stripe_count = (rows + rows_per_stripe_ - 1) / rows_per_stripe_;
  SFUMATO_TRY(write_head());
  for (std::size_t first = 0; first < stripe_count; first += wave_stripes) {
    SFUMATO_TRY(encode_wave(first, std::min(wave_stripes, stripe_count - first)));
  }
  SFUMATO_TRY(write_tail());
  return joined_parts();
}

Status Encoder::encode_wave(std::size_t first_stripe, std::size_t stripe_count) {
  std::vector<Stripe> stripes(stripe_count);
  SFUMATO_TRY(try_parallel_for(context_, stripe_count, 1, [&](std::size_t i, std::size_t) {
    return encode_stripe(first_stripe + i, stripes[i]);
  }));
  Bytes& part = parts_.emplace_back();
  std::size_t size = 0;
  for (const Stripe& stripe : stripes) size += stripe.chunk.size();
  SFUMATO_TRY(memory_.reserve(context_, part, size));
  for (const Stripe& stripe : stripes) {
    SFUMATO_TRY(memory_.append(context_, stripe.chunk, part));
    adler_ = static_cast<std::uint32_t>(
        adler32_combine(adler_, stripe.adler, static_cast<z_off_t>(stripe.filtered_bytes)));
  }
  return ok_status();
}

Status Encoder::encode_stripe(std::size_t index, Stripe& stripe) const {
  const std::size_t first_row = index * rows_per_stripe_;
  const std::size_t end_row =
      std::min(first_row + rows_per_stripe_, static_cast<std::size_t>(image_.height));
  TableMemory memory("writing a PNG");
  Bytes bytes;
  SFUMATO_TRY(filter_rows(first_row, end_row, memory, bytes));
  stripe.filtered_bytes = bytes.size();
  stripe.adler =
      static_cast<std::uint32_t>(adler32(1, bytes.data(), static_cast<uInt>(bytes.size())));
  const std::size_t room =
      kChunkOverhead + kDeflateHead.size() + codecs::packed_bound(bytes.size());
  SFUMATO_TRY(stripe.memory.reserve(context_, stripe.chunk, room));
  append_chunk("IDAT", stripe.chunk, [&](Bytes& out) {
    if (index == 0) out.insert(out.end(), kDeflateHead.begin(), kDeflateHead.end());
    codecs::pack_runs(bytes, out);
  });
  return ok_status();
}

Status Encoder::filter_rows(std::size_t first_row, std::size_t end_row, TableMemory& memory,
                            Bytes& filtered) const {
  Bytes current_scratch, previous_scratch;
  SFUMATO_TRY(memory.resize(context_, filtered, (end_row - first_row) * (row_bytes_ + 1)));
  SFUMATO_TRY(memory.resize_all(context_, row_bytes_, current_scratch, previous_scratch));
  const auto pixel_bytes =
      static_cast<std::size_t>(channel_count(image_.format) * bytes_per_channel(image_.format));
  const std::uint8_t* previous =
      first_row == 0 ? previous_scratch.data() : row(first_row - 1, previous_scratch);
  for (std::size_t y = first_row; y < end_row; ++y) {
    const std::uint8_t* current = row(y, current_scratch);
    codecs::filter_row(current, previous, row_bytes_, pixel_bytes,
                       &filtered[(y - first_row) * (row_bytes_ + 1)]);
    previous = current;
    std::swap(current_scratch, previous_scratch);
  }
  return ok_status();
}

const std::uint8_t* Encoder::row(std::size_t y, Bytes& scratch) const {
  const std::uint8_t* source = &image_.bytes[y * row_bytes_];
  if (bytes_per_channel(image_.format) == 1) return source;
  for (std::size_t i = 0; i < row_bytes_; i += 2) {
    std::uint16_t value;
    std::memcpy(&value, source + i, 2);
    scratch[i] = static_cast<std::uint8_t>(value >> 8);
    scratch[i + 1] = static_cast<std::uint8_t>(value);
  }
  return scratch.data();
}

Status Encoder::write_head() {
  Bytes& out = parts_.emplace_back();
  SFUMATO_TRY(memory_.reserve(context_, out, kEndBytes));
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
  return ok_status();
}

Status Encoder::write_tail() {
  Bytes& out = parts_.emplace_back();
  SFUMATO_TRY(memory_.reserve(context_, out, kEndBytes));
  append_chunk("IDAT", out, [&](Bytes& data) {
    data.push_back(3);  // together with the next byte an empty last block
    data.push_back(0);
    append_big_endian(adler_, data);
  });
  append_chunk("IEND", out, [](Bytes&) {});
  return ok_status();
}

/// Joins all parts in one table. Each part's memory is freed as soon as it is copied.
Result<Bytes> Encoder::joined_parts() {
  std::size_t size = 0;
  for (const Bytes& part : parts_) size += part.size();
  Bytes joined;
  SFUMATO_TRY(memory_.reserve(context_, joined, size));
  for (Bytes& part : parts_) {
    SFUMATO_TRY(memory_.append(context_, part, joined));
    memory_.free(part);
  }
  return joined;
}

Result<Bytes> encode(Context& context, const Image& image) {
  SFUMATO_TRY(validate(context.limits, image));
  return Encoder(context, image).encode();
}

}  // namespace

Result<std::vector<std::uint8_t>> encode_png(Context& context, const Image& image) {
  return public_verb(context, [&] { return encode(context, image); });
}

}  // namespace sfumato
