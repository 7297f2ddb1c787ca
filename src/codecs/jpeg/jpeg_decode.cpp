#include "codecs/jpeg/jpeg_decode.hpp"

#include <cstddef>
#include <cstdio>
// jpeglib.h needs size_t and FILE before it.
#include <jerror.h>
#include <jpeglib.h>

#include <algorithm>
#include <csetjmp>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <string>
#include <string_view>

#include "base/charge.hpp"
#include "base/table_memory.hpp"
#include "base/try.hpp"
#include "codecs/photo/photo_exif.hpp"
#include "sfumato/base/function_ref.hpp"

namespace sfumato::codecs {
namespace {

/// Each scan of a progressive file goes through the whole picture again, so their number is
/// limited.
constexpr std::size_t kScans = 200;
/// Encoders write ten scans for colour; a large picture may have at most twice as many.
constexpr std::size_t kUsualScans = 20;
/// The most blocks of 8 × 8 in all scans together.
constexpr std::size_t kScannedBlocks = std::size_t{32} << 20;

constexpr std::size_t kArithmeticBlocksPerByte = 1024;

/// The library's own memory: coefficients of a progressive file (16 bits, three or four channels,
/// none subsampled), rows, tables.
constexpr std::size_t kDecoderBytesPerPixel = 8;
constexpr std::size_t kDecoderBytes = std::size_t{1} << 20;

/// Holds the library's state of one decoding. The library reports errors by a call that must not
/// return; that call jumps to decode_jpeg's setjmp. Between the two only the library's C code is on
/// the stack.
struct Session {
  explicit Session(const Context& of);
  ~Session() { jpeg_destroy_decompress(&decoder); }
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  const Context& context;
  jpeg_decompress_struct decoder{};
  jpeg_error_mgr errors{};
  jpeg_progress_mgr progress{};
  std::jmp_buf failed;
  char message[JMSG_LENGTH_MAX] = "";
  std::size_t most_scans = kScans;
  bool too_many_scans = false;
  bool no_memory = false;
  bool cancelled = false;
};

[[noreturn]] void fail(j_common_ptr library) {
  auto* session = static_cast<Session*>(library->client_data);
  session->no_memory = library->err->msg_code == JERR_OUT_OF_MEMORY;
  library->err->format_message(library, session->message);
  std::longjmp(session->failed, 1);
}

/// Level -1 is a warning: a file that ends early would be filled up with gray.
void on_message(j_common_ptr library, int level) {
  const int code = library->err->msg_code;
  if (level < 0 && (code == JWRN_JPEG_EOF || code == JWRN_HIT_MARKER)) fail(library);
}

void keep_quiet(j_common_ptr) {}

/// Called for every row of blocks that is read.
void watch(j_common_ptr library) {
  auto* session = static_cast<Session*>(library->client_data);
  if (session->context.cancelled()) {
    session->cancelled = true;
    std::longjmp(session->failed, 1);
  }
  if (session->decoder.input_scan_number <= static_cast<int>(session->most_scans)) return;
  session->too_many_scans = true;
  std::longjmp(session->failed, 1);
}

Session::Session(const Context& of) : context(of) {
  decoder.err = jpeg_std_error(&errors);
  errors.error_exit = fail;
  errors.emit_message = on_message;
  errors.output_message = keep_quiet;
  decoder.client_data = this;
}

constexpr int kExifMarker = JPEG_APP0 + 1;
constexpr int kProfileMarker = JPEG_APP0 + 2;
constexpr unsigned kMostMarkerBytes = 0xFFFF;
constexpr std::string_view kProfileName("ICC_PROFILE\0", 12);

/// keeps_markers: whether to keep the markers of EXIF and of colour profiles.
bool read_header(Session& session, std::span<const std::uint8_t> bytes, bool keeps_markers) {
  if (setjmp(session.failed) != 0) return false;
  jpeg_create_decompress(&session.decoder);
  if (keeps_markers) {
    jpeg_save_markers(&session.decoder, kExifMarker, kMostMarkerBytes);
    jpeg_save_markers(&session.decoder, kProfileMarker, kMostMarkerBytes);
  }
  jpeg_mem_src(&session.decoder, bytes.data(), static_cast<unsigned long>(bytes.size()));
  jpeg_read_header(&session.decoder, TRUE);
  return true;
}

/// Takes a row of the picture in the library's format.
using RowSink = FunctionRef<void(const std::uint8_t* row, std::size_t y)>;

/// Converts a row from RGB or CMYK, `channels` bytes a pixel.
void expand(const std::uint8_t* source, std::size_t channels, bool inverted, std::size_t count,
            std::uint8_t* rgba) {
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint8_t* pixel = source + channels * i;
    std::uint8_t* out = rgba + 4 * i;
    if (channels == 3) {
      out[0] = pixel[0], out[1] = pixel[1], out[2] = pixel[2];
    } else {
      rgb_of_inks(pixel, inverted, out);  // Adobe's bytes are 255 where there is no ink
    }
    out[3] = 255;
  }
}

/// row: room for a row in the library's format.
bool read_pixels(Session& session, std::uint8_t* row, RowSink sink) {
  if (setjmp(session.failed) != 0) return false;
  jpeg_decompress_struct& decoder = session.decoder;
  decoder.progress = &session.progress;
  session.progress.progress_monitor = watch;
  jpeg_start_decompress(&decoder);
  while (decoder.output_scanline < decoder.output_height) {
    watch(reinterpret_cast<j_common_ptr>(&decoder));
    const std::size_t y = decoder.output_scanline;
    jpeg_read_scanlines(&decoder, &row, 1);
    sink(row, y);
  }
  jpeg_finish_decompress(&decoder);
  return true;
}

Status failure(const Session& session) {
  if (session.cancelled) return session.context.cancel_status();
  if (session.no_memory) {
    return make_error(StatusCode::out_of_memory, "no memory to read the JPEG image");
  }
  if (session.too_many_scans) {
    return make_error(StatusCode::bad_input, "the JPEG image is damaged: more than " +
                                                 std::to_string(session.most_scans) + " scans");
  }
  return make_error(StatusCode::bad_input,
                    std::string("the JPEG image is damaged: ") + session.message);
}

Status check_size(const Limits& limits, const Session& session) {
  const std::size_t width = session.decoder.image_width, height = session.decoder.image_height;
  return check_image_size(limits, width, height);
}

/// Returns the number of 8 × 8 blocks of all components.
std::size_t count_blocks(const jpeg_decompress_struct& decoder) {
  std::size_t blocks = 0;
  for (int i = 0; i < decoder.num_components; ++i) {
    const jpeg_component_info& component = decoder.comp_info[i];
    blocks += std::size_t{component.width_in_blocks} * component.height_in_blocks;
  }
  return blocks;
}

/// Returns whether the file is long enough for the picture: Huffman codes take at least a bit for
/// each block. Arithmetic codes with so many blocks in a byte hold a single colour.
bool has_enough_bytes(const jpeg_decompress_struct& decoder, std::size_t byte_count) {
  const std::size_t blocks_per_byte = decoder.arith_code != FALSE ? kArithmeticBlocksPerByte : 8;
  return byte_count >= count_blocks(decoder) / blocks_per_byte;
}

/// Checks the header, chooses RGB or CMYK for the output, and charges the library's memory.
Status prepare(Context& context, Session& session, std::size_t byte_count, ScopedCharge& charge) {
  SFUMATO_TRY(check_size(context.limits, session));
  jpeg_decompress_struct& decoder = session.decoder;
  if (!has_enough_bytes(decoder, byte_count)) {
    return make_error(StatusCode::bad_input, "the JPEG image is damaged: too few bytes for " +
                                                 std::to_string(decoder.image_width) + " × " +
                                                 std::to_string(decoder.image_height) + " pixels");
  }
  session.most_scans = std::clamp(kScannedBlocks / std::max<std::size_t>(count_blocks(decoder), 1),
                                  kUsualScans, kScans);
  decoder.out_color_space = decoder.num_components == 4 ? JCS_CMYK : JCS_RGB;
  const std::size_t pixel_count = std::size_t{decoder.image_width} * decoder.image_height;
  return charge.add(context, kDecoderBytes + pixel_count * kDecoderBytesPerPixel, "a JPEG image");
}

/// Returns the bytes of a pixel that prepare() has chosen.
std::size_t output_channels(const Session& session) {
  return session.decoder.out_color_space == JCS_CMYK ? 4 : 3;
}

Result<RgbaImage> decode(Context& context, Session& session, std::span<const std::uint8_t> bytes) {
  if (!read_header(session, bytes, false)) return failure(session);
  ScopedCharge charge;
  SFUMATO_TRY(prepare(context, session, bytes.size(), charge));
  const jpeg_decompress_struct& decoder = session.decoder;
  const std::size_t channels = output_channels(session), width = decoder.image_width;
  TableMemory memory("a JPEG image");
  std::vector<std::uint8_t> row;
  RgbaImage image{
      static_cast<int>(decoder.image_width), static_cast<int>(decoder.image_height), {}};
  SFUMATO_TRY(memory.resize(context, row, channels * width));
  SFUMATO_TRY(memory.resize(context, image.rgba, 4 * width * decoder.image_height));
  const bool is_read = read_pixels(session, row.data(), [&](const std::uint8_t* of, std::size_t y) {
    expand(of, channels, decoder.saw_Adobe_marker != FALSE, width, &image.rgba[4 * width * y]);
  });
  if (!is_read) return failure(session);
  return image;
}

std::string_view text_of(const jpeg_marker_struct& marker) {
  return {reinterpret_cast<const char*>(marker.data), marker.data_length};
}

/// Returns the profile that the library joins from its parts, in memory of malloc; null if there is
/// no profile or it is incomplete.
JOCTET* joined_profile(Session& session, unsigned& byte_count) {
  if (setjmp(session.failed) != 0) return nullptr;
  JOCTET* joined = nullptr;
  return jpeg_read_icc_profile(&session.decoder, &joined, &byte_count) != FALSE ? joined : nullptr;
}

Status take_markers(Context& context, Session& session, TableMemory& memory, JpegPhoto& photo) {
  for (const jpeg_marker_struct* marker = session.decoder.marker_list; marker;
       marker = marker->next) {
    const std::string_view text = text_of(*marker);
    if (marker->marker == kProfileMarker && text.starts_with(kProfileName)) {
      photo.has_profile = true;
    }
    if (marker->marker != kExifMarker || !text.starts_with(kExifName) || !photo.exif.empty()) {
      continue;
    }
    SFUMATO_TRY(memory.append(context, text, photo.exif));
  }
  if (!photo.has_profile) return ok_status();
  unsigned byte_count = 0;
  const std::unique_ptr<JOCTET, decltype(&std::free)> joined(joined_profile(session, byte_count),
                                                             &std::free);
  if (!joined) return session.no_memory ? failure(session) : ok_status();
  return memory.append(context, std::span<const std::uint8_t>(joined.get(), byte_count),
                       photo.profile);
}

Result<JpegPhoto> decode_photo(Context& context, Session& session,
                               std::span<const std::uint8_t> bytes) {
  // The memory of the markers that the library keeps, and of a profile joined from them.
  ScopedCharge charge;
  SFUMATO_TRY(charge.add(context, 2 * bytes.size(), "a JPEG image"));
  if (!read_header(session, bytes, true)) return failure(session);
  SFUMATO_TRY(prepare(context, session, bytes.size(), charge));
  const jpeg_decompress_struct& decoder = session.decoder;
  TableMemory memory("a JPEG image");
  JpegPhoto photo;
  photo.is_cmyk = output_channels(session) == 4;
  photo.is_gray = decoder.num_components == 1;
  photo.is_inverted = decoder.saw_Adobe_marker != FALSE;
  photo.image = {static_cast<int>(decoder.image_width),
                 static_cast<int>(decoder.image_height),
                 photo.is_cmyk ? PixelFormat::rgba8 : PixelFormat::rgb8,
                 {}};
  const std::size_t row_bytes = photo.image.row_bytes();
  std::vector<std::uint8_t> row;
  SFUMATO_TRY(take_markers(context, session, memory, photo));
  SFUMATO_TRY(memory.resize(context, row, row_bytes));
  SFUMATO_TRY(memory.resize(context, photo.image.bytes, row_bytes * decoder.image_height));
  const bool is_read = read_pixels(session, row.data(), [&](const std::uint8_t* of, std::size_t y) {
    std::memcpy(&photo.image.bytes[row_bytes * y], of, row_bytes);
  });
  if (!is_read) return failure(session);
  return photo;
}

}  // namespace

Result<RgbaImage> decode_jpeg(Context& context, std::span<const std::uint8_t> bytes) {
  Session session(context);
  return decode(context, session, bytes);
}

Result<JpegPhoto> decode_jpeg_photo(Context& context, std::span<const std::uint8_t> bytes) {
  Session session(context);
  return decode_photo(context, session, bytes);
}

}  // namespace sfumato::codecs
