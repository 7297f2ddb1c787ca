#include "sfumato/picture/picture_file.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <string>
#include <string_view>
#include <utility>

#include "base/limit_error.hpp"
#include "base/output_buffer.hpp"
#include "base/parallel.hpp"
#include "base/public_verb.hpp"
#include "base/table_memory.hpp"
#include "base/try.hpp"
#include "document/rules.hpp"
#include "picture/check_picture.hpp"
#include "picture/checksum.hpp"
#include "picture/picture_reader.hpp"
#include "picture/picture_writer.hpp"

namespace sfumato {
namespace {

using Bytes = std::span<const std::uint8_t>;

constexpr std::string_view kMagic = "SFPICT\x1a";
constexpr std::uint32_t kByteOrder = 0x01020304;
constexpr std::uint32_t kOtherOrder = 0x04030201;
constexpr double kMostError = 255;

// The places of the parts of the header. The checksum covers all bytes after it.
constexpr std::size_t kVersionAt = 7;
constexpr std::size_t kOrderAt = 8;
constexpr std::size_t kSizeAt = 12;
constexpr std::size_t kChecksumAt = 20;
constexpr std::size_t kHeaderBytes = 28;

Status bad(std::string message) {
  return make_error(StatusCode::bad_input, std::move(message));
}

Status damaged(const char* what) {
  return bad(std::string("damaged: ") + what);
}

template <class Number>
Number number_at(Bytes file, std::size_t at) {
  Number number;
  std::memcpy(&number, file.data() + at, sizeof number);
  return number;
}

bool are_finite(const std::vector<float>& values) {
  constexpr std::uint32_t kExponent = 0x7f800000;
  std::uint32_t others = 0;  // without an early exit, so that several are compared at once
  for (const float value : values) {
    others |= (std::bit_cast<std::uint32_t>(value) & kExponent) == kExponent ? 1 : 0;
  }
  return others == 0;
}

bool are_flags(const std::vector<std::uint8_t>& values) {
  std::uint8_t bits = 0;
  for (const std::uint8_t value : values) bits |= value;
  return bits <= 1;
}

/// Returns whether a box can be a frame. The frame of a layer that no instance shows is empty.
bool is_frame(const Box& box) {
  const double sides[] = {box.min.x, box.min.y, box.max.x, box.max.y};
  return box == Box{} || std::ranges::all_of(sides, [](double s) { return std::isfinite(s); });
}

bool is_scale(double scale) {
  return scale > 0 && std::isfinite(scale);
}

Status check_origin(const PictureOrigin& origin) {
  const bool is_good = is_scale(origin.own_scale.x) && is_scale(origin.own_scale.y) &&
                       is_scale(origin.pixels_per_unit) && origin.max_error >= 0 &&
                       origin.max_error <= kMostError;
  return is_good ? ok_status() : bad("a scale or an error that no picture is made with");
}

Status check_layer(const Context& context, const PatchLayer& layer) {
  const Limits& limits = context.limits;
  if (layer.triangle_count() > limits.triangles) {
    return limit_error(limits, &Limits::triangles, "triangles in a layer");
  }
  for (const PatchField* field : {&layer.color, &layer.opacity}) {
    const auto channels = static_cast<std::size_t>(std::max(field->channel_count, 1));
    if (field->node_value.size() / channels > limits.nodes) {
      return limit_error(limits, &Limits::nodes, "nodes in a layer");
    }
    if (context.cancelled()) return context.cancel_status();
    if (!are_finite(field->node_value)) return bad("a layer of the picture with no finite values");
  }
  if (!is_frame(layer.frame) || !are_flags(layer.edge_is_curve)) {
    return bad("a layer of the picture with a wrong frame or edges");
  }
  return ok_status();
}

/// Checks the conditions that hold for a picture in every file.
Status check_content(const Context& context, const Picture& picture, const PictureOrigin& origin) {
  SFUMATO_TRY(check_origin(origin));
  if (!rules::has_area(picture.artboard) || !rules::has_area(picture.viewport)) {
    return bad("a picture without an area");
  }
  if (!picture::can_be_drawn(picture.viewport)) {
    return bad("a viewport too small or too far away to be drawn");
  }
  if (picture.layers.size() > context.limits.layers) {
    return limit_error(context.limits, &Limits::layers, "layers");
  }
  for (const PatchLayer& layer : picture.layers) {
    SFUMATO_TRY(check_layer(context, layer));
  }
  return picture::check_picture(context, picture);
}

Status check_length(const Limits& limits, std::size_t bytes) {
  if (bytes / kPictureFileFactor < limits.input_bytes) return ok_status();
  return make_limit_error(&Limits::input_bytes,
                          "a solved picture of more than " + std::to_string(kPictureFileFactor) +
                              " times the limit of " + std::to_string(limits.input_bytes) +
                              " bytes of input");
}

template <class Sink>
void write_parts(const Picture& picture, const PictureOrigin& origin, Sink& sink) {
  picture::PartWriter<Sink> writer(sink);
  pass(writer, origin);
  pass(writer, picture);
}

Result<std::vector<std::uint8_t>> write(const Context& context, const Picture& picture,
                                        const PictureOrigin& origin) {
  SFUMATO_TRY(check_content(context, picture, origin));
  picture::ByteCount count(kHeaderBytes);
  write_parts(picture, origin, count);
  // A file that no reader could read is not written.
  SFUMATO_TRY(check_length(context.limits, count.position()));
  OutputBuffer file(context, "the picture file");
  file.reserve(count.position());
  picture::BufferSink sink(file);
  const std::uint64_t size = count.position(), no_checksum = 0;
  file += kMagic;
  file.push_back(kPictureFileVersion);
  sink.append(&kByteOrder, sizeof kByteOrder);
  sink.append(&size, sizeof size);
  sink.append(&no_checksum, sizeof no_checksum);
  write_parts(picture, origin, sink);
  SFUMATO_TRY_ASSIGN(auto&& bytes, file.finish());
  SFUMATO_TRY_ASSIGN(const std::uint64_t sum,
                     picture::checksum(context, Bytes(bytes).subspan(kHeaderBytes)));
  std::memcpy(bytes.data() + kChecksumAt, &sum, sizeof sum);
  return std::move(bytes);
}

Status check_header(const Context& context, Bytes file) {
  SFUMATO_TRY(check_length(context.limits, file.size()));
  if (!is_picture_file(file)) return bad("not a solved picture");
  if (file.size() < kHeaderBytes) return bad("a solved picture that is cut off");
  if (file[kVersionAt] != kPictureFileVersion) {
    return bad("a solved picture of version " + std::to_string(file[kVersionAt]) +
               "; only version " + std::to_string(kPictureFileVersion) + " can be read");
  }
  const auto order = number_at<std::uint32_t>(file, kOrderAt);
  if (order == kOtherOrder) return bad("a solved picture of a machine with the other byte order");
  if (order != kByteOrder) return damaged("the mark of its byte order is none");
  const auto size = number_at<std::uint64_t>(file, kSizeAt);
  if (size != file.size()) {
    return bad("a solved picture of " + std::to_string(size) + " bytes, " +
               std::to_string(file.size()) + " are here");
  }
  return ok_status();
}

Status check_sum(const Context& context, Bytes file) {
  SFUMATO_TRY_ASSIGN(const std::uint64_t sum,
                     picture::checksum(context, file.subspan(kHeaderBytes)));
  if (sum == number_at<std::uint64_t>(file, kChecksumAt)) return ok_status();
  return damaged("the checksum of its bytes is another");
}

Status read_parts(const Context& context, Bytes file, TableMemory& memory, Picture& picture,
                  PictureOrigin& origin) {
  picture::PartReader reader(context, file, kHeaderBytes, memory);
  pass(reader, origin);
  pass(reader, picture);
  if (!reader.ok()) return reader.status();
  if (!reader.at_end()) return damaged("there is something behind its end");
  return check_content(context, picture, origin);
}

/// Reads the parts as if the checksum was right; it is checked at the same time.
Result<Picture> read(const Context& context, Bytes file, PictureOrigin* origin) {
  SFUMATO_TRY(check_header(context, file));
  TableMemory memory("the picture");
  PictureOrigin found;
  Picture picture;
  SFUMATO_TRY(run_both(
      context, [&] { return check_sum(context, file); },
      [&] { return read_parts(context, file, memory, picture, found); }));
  if (origin) *origin = found;
  return picture;
}

}  // namespace

bool is_picture_file(std::span<const std::uint8_t> bytes) {
  return bytes.size() >= kMagic.size() &&
         std::memcmp(bytes.data(), kMagic.data(), kMagic.size()) == 0;
}

Result<std::vector<std::uint8_t>> write_picture(const Context& context, const Picture& picture,
                                                const PictureOrigin& origin) {
  return public_verb(context, [&] { return write(context, picture, origin); });
}

Result<Picture> read_picture(const Context& context, std::span<const std::uint8_t> bytes,
                             PictureOrigin* origin) {
  return public_verb(context, [&] { return read(context, bytes, origin); });
}

}  // namespace sfumato
