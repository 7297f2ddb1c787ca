#include "sfumato/codecs/jpeg_encode.hpp"

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
#include "base/no_throw.hpp"
#include "base/public_verb.hpp"
#include "base/table_memory.hpp"
#include "base/try.hpp"

namespace sfumato {
namespace {

/// The library's own memory: coefficients of a progressive file (16 bits, three channels), rows,
/// tables. The library allocates this memory, so the figure is an estimate.
constexpr std::size_t kJpegEncoderBytesPerPixel = 6;
constexpr std::size_t kJpegEncoderBytes = std::size_t{1} << 20;
constexpr std::size_t kFirstFileBytes = std::size_t{16} << 10;

/// Holds the library's state of one encoding. Errors jump to `write_image`, with only C code
/// between. The file grows here, because the library's own destination loses the file when memory
/// runs out.
struct Session {
  explicit Session(const Context& of);
  ~Session() { jpeg_destroy_compress(&encoder); }
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  const Context& context;
  jpeg_compress_struct encoder{};
  jpeg_error_mgr errors{};
  jpeg_progress_mgr progress{};
  jpeg_destination_mgr destination{};
  std::jmp_buf failed;
  char message[JMSG_LENGTH_MAX] = "";
  bool no_memory = false;
  bool cancelled = false;
  TableMemory memory{"a JPEG image"};
  std::vector<std::uint8_t> file;
  Status grown{};  ///< why the file could not grow
};

[[noreturn]] void fail(j_common_ptr library) {
  auto* session = static_cast<Session*>(library->client_data);
  session->no_memory = library->err->msg_code == JERR_OUT_OF_MEMORY;
  library->err->format_message(library, session->message);
  std::longjmp(session->failed, 1);
}

void keep_quiet(j_common_ptr) {}

/// Called for every row of blocks in each pass.
void watch(j_common_ptr library) {
  auto* session = static_cast<Session*>(library->client_data);
  if (!session->context.cancelled()) return;
  session->cancelled = true;
  std::longjmp(session->failed, 1);
}

/// Called when the file's buffer is full.
boolean enlarge_file(j_compress_ptr encoder) {
  auto* session = static_cast<Session*>(encoder->client_data);
  const std::size_t used = session->file.size();
  session->grown = no_throw([&] {
    return session->memory.resize(session->context, session->file,
                                  std::max(kFirstFileBytes, 2 * used));
  });
  if (!session->grown) std::longjmp(session->failed, 1);
  session->destination.next_output_byte = session->file.data() + used;
  session->destination.free_in_buffer = session->file.size() - used;
  return TRUE;
}

void begin_file(j_compress_ptr encoder) {
  enlarge_file(encoder);
}

void end_file(j_compress_ptr encoder) {
  auto* session = static_cast<Session*>(encoder->client_data);
  session->file.resize(session->file.size() - session->destination.free_in_buffer);
}

Session::Session(const Context& of) : context(of) {
  encoder.err = jpeg_std_error(&errors);
  errors.error_exit = fail;
  errors.output_message = keep_quiet;
  encoder.client_data = this;
  destination.init_destination = begin_file;
  destination.empty_output_buffer = enlarge_file;
  destination.term_destination = end_file;
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

bool write_image(Session& session, const Image& image, int quality) {
  if (setjmp(session.failed) != 0) return false;
  jpeg_compress_struct& encoder = session.encoder;
  jpeg_create_compress(&encoder);
  encoder.dest = &session.destination;
  set_up(encoder, image, quality);
  encoder.progress = &session.progress;
  session.progress.progress_monitor = watch;
  jpeg_start_compress(&encoder, TRUE);
  while (encoder.next_scanline < encoder.image_height) {
    watch(reinterpret_cast<j_common_ptr>(&encoder));
    const std::uint8_t* row = &image.bytes[image.row_bytes() * encoder.next_scanline];
    JSAMPROW rows = const_cast<JSAMPROW>(row);
    jpeg_write_scanlines(&encoder, &rows, 1);
  }
  jpeg_finish_compress(&encoder);
  return true;
}

Status failure(const Session& session) {
  if (session.cancelled) return session.context.cancel_status();
  if (session.no_memory || session.grown.code == StatusCode::out_of_memory) {
    return make_error(StatusCode::out_of_memory, "no memory to write the JPEG image");
  }
  if (!session.grown) return session.grown;
  return make_error(StatusCode::internal, std::string("writing a JPEG: ") + session.message);
}

Result<std::vector<std::uint8_t>> encode(Context& context, const Image& image, int quality) {
  SFUMATO_TRY(validate(context.limits, image));
  if (quality < 1 || quality > 100) {
    return make_error(StatusCode::bad_input, "the quality of a JPEG must be from 1 to 100");
  }
  if (image.format != PixelFormat::rgb8) {
    return make_error(StatusCode::bad_input, "JPEG holds 8 bits per channel and no alpha");
  }
  ScopedCharge charge;
  const std::size_t pixel_count = static_cast<std::size_t>(image.width) * image.height;
  SFUMATO_TRY(charge.add(context, kJpegEncoderBytes + kJpegEncoderBytesPerPixel * pixel_count,
                         "writing a JPEG image"));
  Session session(context);
  if (!write_image(session, image, quality)) return failure(session);
  return std::move(session.file);
}

}  // namespace

Result<std::vector<std::uint8_t>> encode_jpeg(Context& context, const Image& image, int quality) {
  return public_verb(context, [&] { return encode(context, image, quality); });
}

}  // namespace sfumato
