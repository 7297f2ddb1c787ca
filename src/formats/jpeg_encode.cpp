#include "formats/jpeg_encode.hpp"

#include <cstddef>
#include <cstdio>
// jpeglib.h needs size_t and FILE before it.
#include <jerror.h>
#include <jpeglib.h>

#include <csetjmp>
#include <cstdlib>
#include <string>

namespace sfumato {
namespace {

/// The library's own memory: coefficients of a progressive file (16 bits, three channels), rows,
/// tables; and the file, which is never longer than its pixels by much.
constexpr std::size_t kWorkingBytesPerPixel = 6 + 4;
constexpr std::size_t kWorkingBytes = std::size_t{1} << 20;

/// The library's view of one encoding; errors jump to `write_image`, with only C code between.
struct Session {
  jpeg_compress_struct encoder;
  jpeg_error_mgr errors;
  std::jmp_buf failed;
  char message[JMSG_LENGTH_MAX];
  bool no_memory;
  bool cancelled;
  unsigned char* file;  ///< malloc's
  unsigned long file_bytes;
};

[[noreturn]] void fail(j_common_ptr library) {
  auto* session = static_cast<Session*>(library->client_data);
  session->no_memory = library->err->msg_code == JERR_OUT_OF_MEMORY;
  library->err->format_message(library, session->message);
  std::longjmp(session->failed, 1);
}

void keep_quiet(j_common_ptr) {}

void open(Session& session) {
  session.encoder.err = jpeg_std_error(&session.errors);
  session.errors.error_exit = fail;
  session.errors.output_message = keep_quiet;
  session.encoder.client_data = &session;
}

void set_up(jpeg_compress_struct& encoder, const Image& image, int quality) {
  encoder.image_width = static_cast<JDIMENSION>(image.width);
  encoder.image_height = static_cast<JDIMENSION>(image.height);
  encoder.input_components = 3;
  encoder.in_color_space = JCS_RGB;
  jpeg_set_defaults(&encoder);
  jpeg_set_quality(&encoder, quality, TRUE);
  encoder.dct_method = JDCT_ISLOW;
  encoder.optimize_coding = TRUE;
  for (int i = 0; i < encoder.num_components; ++i) {
    encoder.comp_info[i].h_samp_factor = 1;
    encoder.comp_info[i].v_samp_factor = 1;
  }
  jpeg_simple_progression(&encoder);
}

bool write_image(Session& session, const Context& context, const Image& image, int quality) {
  if (setjmp(session.failed) != 0) return false;
  jpeg_compress_struct& encoder = session.encoder;
  jpeg_create_compress(&encoder);
  jpeg_mem_dest(&encoder, &session.file, &session.file_bytes);
  set_up(encoder, image, quality);
  jpeg_start_compress(&encoder, TRUE);
  while (encoder.next_scanline < encoder.image_height) {
    if (context.cancelled()) {
      session.cancelled = true;
      return false;
    }
    const std::uint8_t* row = &image.bytes[image.row_bytes() * encoder.next_scanline];
    JSAMPROW rows = const_cast<JSAMPROW>(row);
    jpeg_write_scanlines(&encoder, &rows, 1);
  }
  jpeg_finish_compress(&encoder);
  return true;
}

Status failure(const Session& session) {
  if (session.cancelled) return make_error(StatusCode::cancelled, "cancelled");
  if (session.no_memory) {
    return make_error(StatusCode::out_of_memory, "no memory to write the JPEG image");
  }
  return make_error(StatusCode::internal, std::string("writing a JPEG: ") + session.message);
}

}  // namespace

Result<std::vector<std::uint8_t>> encode_jpeg(Context& context, const Image& image, int quality) {
  if (image.format != PixelFormat::rgb8) {
    return make_error(StatusCode::bad_input, "JPEG holds 8 bits per channel and no alpha");
  }
  ScopedCharge charge;
  const std::size_t pixel_count = static_cast<std::size_t>(image.width) * image.height;
  const Status status = charge.add(context, kWorkingBytes + kWorkingBytesPerPixel * pixel_count,
                                   "writing a JPEG image");
  if (!status) return status;
  Session session{};
  open(session);
  const bool written = write_image(session, context, image, quality);
  Result<std::vector<std::uint8_t>> file = failure(session);
  if (written) file = std::vector<std::uint8_t>(session.file, session.file + session.file_bytes);
  jpeg_destroy_compress(&session.encoder);
  std::free(session.file);
  return file;
}

}  // namespace sfumato
