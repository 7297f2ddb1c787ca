#include "cli/commands/film.hpp"

#include <cstdio>

#include "cli/files/paths.hpp"

namespace sfumato::cli {
namespace {

std::string pixels_text(int width, int height) {
  return std::to_string(width) + 'x' + std::to_string(height);
}

}  // namespace

Status Film::add(const Context& context, const Job& job, std::span<const std::uint8_t> frame,
                 const RenderStats& stats) {
  if (first_.empty()) {
    first_ = display_name(job.input);
    width_ = stats.width;
    height_ = stats.height;
    if (hints_) {
      std::fprintf(
          stderr, "sfumato: note: for ffmpeg: -f rawvideo -pixel_format %s -video_size %s\n",
          std::string(options::name_of_frame(kind_)).c_str(), pixels_text(width_, height_).c_str());
    }
  } else if (stats.width != width_ || stats.height != height_) {
    return make_error(StatusCode::bad_input,
                      "the frame has " + pixels_text(stats.width, stats.height) +
                          " pixels, but the first, " + first_ + ", " +
                          pixels_text(width_, height_) + "; --width and --height give all the same",
                      {display_name(job.input)});
  }
  return stream_.write(frame, context);
}

Status Film::close(const Context& context) {
  Status status = first_.empty() ? stream_.write({}, context) : ok_status();
  return status ? stream_.close() : status;
}

}  // namespace sfumato::cli
