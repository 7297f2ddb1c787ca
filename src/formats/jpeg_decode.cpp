#include "formats/jpeg_decode.hpp"

#include <cstddef>
#include <cstdio>
// jpeglib.h needs size_t and FILE before it.
#include <jerror.h>
#include <jpeglib.h>

#include <csetjmp>
#include <string>
#include <utility>

#include "formats/image_file.hpp"

namespace sfumato {
namespace {

/// A progressive file may ask for the whole picture to be gone through again and again.
constexpr int kScans = 200;

/// The library's own memory: coefficients of a progressive file (16 bits, three or four channels,
/// none subsampled), rows, tables.
constexpr std::size_t kWorkingBytesPerPixel = 8;
constexpr std::size_t kWorkingBytes = std::size_t{1} << 20;

/// The library's view of one decoding. It reports errors by a call that must not come back: that
/// call jumps to decode_jpeg's setjmp. Between the two only the library's C code is on the stack.
struct Session {
  Session();
  ~Session() { jpeg_destroy_decompress(&decoder); }
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  jpeg_decompress_struct decoder{};
  jpeg_error_mgr errors{};
  jpeg_progress_mgr progress{};
  std::jmp_buf failed;
  char message[JMSG_LENGTH_MAX] = "";
  bool too_many_scans = false;
  bool no_memory = false;
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

void count_scans(j_common_ptr library) {
  auto* session = static_cast<Session*>(library->client_data);
  if (session->decoder.input_scan_number <= kScans) return;
  session->too_many_scans = true;
  std::longjmp(session->failed, 1);
}

Session::Session() {
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

/// pixels: output_components bytes for each, row by row.
bool read_pixels(Session& session, std::uint8_t* pixels, std::size_t row_bytes) {
  if (setjmp(session.failed) != 0) return false;
  session.decoder.progress = &session.progress;
  session.progress.progress_monitor = count_scans;
  jpeg_start_decompress(&session.decoder);
  while (session.decoder.output_scanline < session.decoder.output_height) {
    JSAMPROW row = pixels + row_bytes * session.decoder.output_scanline;
    jpeg_read_scanlines(&session.decoder, &row, 1);
  }
  jpeg_finish_decompress(&session.decoder);
  return true;
}

Status failure(const Session& session) {
  if (session.no_memory) {
    return make_error(StatusCode::out_of_memory, "no memory to read the JPEG image");
  }
  if (session.too_many_scans) {
    return make_error(StatusCode::bad_input,
                      "the JPEG image is damaged: more than " + std::to_string(kScans) + " scans");
  }
  return make_error(StatusCode::bad_input,
                    std::string("the JPEG image is damaged: ") + session.message);
}

Status check_size(const Limits& limits, const Session& session) {
  const std::size_t width = session.decoder.image_width, height = session.decoder.image_height;
  return check_image_size(limits, width, height);
}

/// Whether the file can hold the picture: Huffman codes take a bit for each block of 8 × 8 at
/// least.
bool has_enough_bytes(const jpeg_decompress_struct& decoder, std::size_t byte_count) {
  if (decoder.arith_code != FALSE) return true;
  std::size_t blocks = 0;
  for (int i = 0; i < decoder.num_components; ++i) {
    const jpeg_component_info& component = decoder.comp_info[i];
    blocks += std::size_t{component.width_in_blocks} * component.height_in_blocks;
  }
  return byte_count >= blocks / 8;
}

/// From RGB or CMYK, `channels` bytes a pixel.
void expand(const std::uint8_t* source, std::size_t channels, bool inverted,
            std::vector<std::uint8_t>& rgba) {
  for (std::size_t i = 0; i < rgba.size() / 4; ++i) {
    const std::uint8_t* pixel = source + channels * i;
    std::uint8_t* out = &rgba[4 * i];
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

Result<RgbaImage> decode(Context& context, Session& session, std::span<const std::uint8_t> bytes) {
  if (!read_header(session, bytes)) return failure(session);
  if (Status status = check_size(context.limits, session); !status) return status;
  jpeg_decompress_struct& decoder = session.decoder;
  if (!has_enough_bytes(decoder, bytes.size())) {
    return make_error(StatusCode::bad_input, "the JPEG image is damaged: too few bytes for " +
                                                 std::to_string(decoder.image_width) + " × " +
                                                 std::to_string(decoder.image_height) + " pixels");
  }
  const bool is_cmyk = decoder.num_components == 4;
  decoder.out_color_space = is_cmyk ? JCS_CMYK : JCS_RGB;
  const std::size_t channels = is_cmyk ? 4 : 3;
  const std::size_t pixel_count = std::size_t{decoder.image_width} * decoder.image_height;
  ScopedCharge charge;
  Status status =
      charge.add(context, kWorkingBytes + pixel_count * (kWorkingBytesPerPixel + channels + 4),
                 "a JPEG image");
  if (!status) return status;
  std::vector<std::uint8_t> pixels(pixel_count * channels);
  const bool inverted = decoder.saw_Adobe_marker != FALSE;
  if (!read_pixels(session, pixels.data(), channels * decoder.image_width)) {
    return failure(session);
  }
  RgbaImage image{static_cast<int>(decoder.image_width), static_cast<int>(decoder.image_height),
                  std::vector<std::uint8_t>(4 * pixel_count)};
  expand(pixels.data(), channels, inverted, image.rgba);
  return image;
}

}  // namespace

Result<RgbaImage> decode_jpeg(Context& context, std::span<const std::uint8_t> bytes) {
  Session session;
  return decode(context, session, bytes);
}

}  // namespace sfumato
