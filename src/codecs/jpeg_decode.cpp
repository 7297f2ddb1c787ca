#include "codecs/jpeg_decode.hpp"

#include <cstddef>
#include <cstdio>
// jpeglib.h needs size_t and FILE before it.
#include <jerror.h>
#include <jpeglib.h>

#include <algorithm>
#include <csetjmp>
#include <string>
#include <utility>

#include "base/charge.hpp"
#include "base/table_memory.hpp"
#include "codecs/image_file.hpp"

namespace sfumato::codecs {
namespace {

/// A progressive file may ask for the whole picture to be gone through again and again.
constexpr std::size_t kScans = 200;
/// Encoders write ten for colour; a large picture may have no more than twice that.
constexpr std::size_t kUsualScans = 20;
/// Blocks of 8 × 8 in all scans together.
constexpr std::size_t kScannedBlocks = std::size_t{32} << 20;

constexpr std::size_t kArithmeticBlocksPerByte = 1024;

/// The library's own memory: coefficients of a progressive file (16 bits, three or four channels,
/// none subsampled), rows, tables.
constexpr std::size_t kWorkingBytesPerPixel = 8;
constexpr std::size_t kWorkingBytes = std::size_t{1} << 20;

/// The library's view of one decoding. It reports errors by a call that must not come back: that
/// call jumps to decode_jpeg's setjmp. Between the two only the library's C code is on the stack.
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

bool read_header(Session& session, std::span<const std::uint8_t> bytes) {
  if (setjmp(session.failed) != 0) return false;
  jpeg_create_decompress(&session.decoder);
  jpeg_mem_src(&session.decoder, bytes.data(), static_cast<unsigned long>(bytes.size()));
  jpeg_read_header(&session.decoder, TRUE);
  return true;
}

/// From RGB or CMYK, `channels` bytes a pixel.
void expand(const std::uint8_t* source, std::size_t channels, bool inverted, std::size_t count,
            std::uint8_t* rgba) {
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint8_t* pixel = source + channels * i;
    std::uint8_t* out = rgba + 4 * i;
    if (channels == 3) {
      out[0] = pixel[0], out[1] = pixel[1], out[2] = pixel[2];
    } else {
      // Adobe's bytes are 255 where there is no ink.
      const auto ink_free = [inverted](std::uint8_t byte) {
        return static_cast<unsigned>(inverted ? byte : 255 - byte);
      };
      const unsigned light = ink_free(pixel[3]);
      for (int c = 0; c < 3; ++c) {
        out[c] = static_cast<std::uint8_t>((ink_free(pixel[c]) * light + 127) / 255);
      }
    }
    out[3] = 255;
  }
}

/// rgba: 4 bytes for each pixel, row by row. row: room for one as the library has it.
bool read_pixels(Session& session, std::size_t channels, std::uint8_t* row, std::uint8_t* rgba) {
  if (setjmp(session.failed) != 0) return false;
  jpeg_decompress_struct& decoder = session.decoder;
  decoder.progress = &session.progress;
  session.progress.progress_monitor = watch;
  jpeg_start_decompress(&decoder);
  while (decoder.output_scanline < decoder.output_height) {
    watch(reinterpret_cast<j_common_ptr>(&decoder));
    std::uint8_t* const out =
        rgba + std::size_t{4} * decoder.output_width * decoder.output_scanline;
    jpeg_read_scanlines(&decoder, &row, 1);
    expand(row, channels, decoder.saw_Adobe_marker != FALSE, decoder.output_width, out);
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

/// Blocks of 8 × 8 of all components.
std::size_t count_blocks(const jpeg_decompress_struct& decoder) {
  std::size_t blocks = 0;
  for (int i = 0; i < decoder.num_components; ++i) {
    const jpeg_component_info& component = decoder.comp_info[i];
    blocks += std::size_t{component.width_in_blocks} * component.height_in_blocks;
  }
  return blocks;
}

/// Whether the file can hold the picture: Huffman codes take a bit for each block at least. Of
/// arithmetic codes so many blocks in a byte are nothing but one colour.
bool has_enough_bytes(const jpeg_decompress_struct& decoder, std::size_t byte_count) {
  const std::size_t blocks_per_byte = decoder.arith_code != FALSE ? kArithmeticBlocksPerByte : 8;
  return byte_count >= count_blocks(decoder) / blocks_per_byte;
}

Result<RgbaImage> decode(Context& context, Session& session, std::span<const std::uint8_t> bytes) {
  if (!read_header(session, bytes)) return failure(session);
  if (Status status = check_size(context.limits, session); !status) return status;
  jpeg_decompress_struct& decoder = session.decoder;
  if (!has_enough_bytes(decoder, bytes.size())) {
    return make_error(StatusCode::bad_input, "the JPEG image is damaged: too few bytes for " +
                                                 std::to_string(decoder.image_width) + " × " +
                                                 std::to_string(decoder.image_height) + " pixels");
  }
  session.most_scans = std::clamp(kScannedBlocks / std::max<std::size_t>(count_blocks(decoder), 1),
                                  kUsualScans, kScans);
  const bool is_cmyk = decoder.num_components == 4;
  decoder.out_color_space = is_cmyk ? JCS_CMYK : JCS_RGB;
  const std::size_t channels = is_cmyk ? 4 : 3;
  const std::size_t pixel_count = std::size_t{decoder.image_width} * decoder.image_height;
  ScopedCharge charge;
  Status status =
      charge.add(context, kWorkingBytes + pixel_count * kWorkingBytesPerPixel, "a JPEG image");
  if (!status) return status;
  TableMemory memory("a JPEG image");
  std::vector<std::uint8_t> row;
  RgbaImage image{
      static_cast<int>(decoder.image_width), static_cast<int>(decoder.image_height), {}};
  status = memory.resize(context, row, channels * decoder.image_width);
  if (status) status = memory.resize(context, image.rgba, 4 * pixel_count);
  if (!status) return status;
  if (!read_pixels(session, channels, row.data(), image.rgba.data())) return failure(session);
  return image;
}

}  // namespace

Result<RgbaImage> decode_jpeg(Context& context, std::span<const std::uint8_t> bytes) {
  Session session(context);
  return decode(context, session, bytes);
}

}  // namespace sfumato::codecs
