#include <array>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>

#include "base/charge.hpp"
#include "base/native/folder.hpp"
#include "base/stopwatch.hpp"
#include "base/table_memory.hpp"
#include "base/text/json.hpp"
#include "base/text/number_text.hpp"
#include "base/try.hpp"
#include "cli/command_context.hpp"
#include "cli/commands/commands.hpp"
#include "cli/commands/stats.hpp"
#include "cli/files/document_input.hpp"
#include "cli/files/solved_input.hpp"
#include "codecs/file_kind.hpp"
#include "output/image_output.hpp"
#include "output/output_size.hpp"
#include "picture/checksum.hpp"
#include "sfumato/base/native/file.hpp"
#include "tiles/big_tiff.hpp"
#include "tiles/deep_zoom.hpp"

namespace sfumato::cli {
namespace {

std::string hexadecimal(std::uint64_t number) {
  std::array<char, 17> text{};
  std::snprintf(text.data(), text.size(), "%016llx", static_cast<unsigned long long>(number));
  return text.data();
}

class TilesJob {
 public:
  TilesJob(Context& context, const TilesArguments& arguments)
      : context_(context), arguments_(arguments), settings_(arguments.settings) {}

  /// Errors: as of reading and writing.
  Status run();

 private:
  Status read();
  Status choose_options();
  std::string fingerprint() const;
  Status write_deep_zoom();
  Status write_tiff();
  Status write_stats(double seconds) const;

  Context& context_;
  const TilesArguments& arguments_;
  const options::Settings& settings_;
  SolvedInput solved_;
  ScopedCharge charge_;
  std::uint64_t checksum_ = 0;
  tiles::Pyramid pyramid_;
  RasterOptions raster_;
  tiles::DeepZoomStats deep_zoom_;
  tiles::BigTiffStats tiff_;
};

Status TilesJob::read() {
  SFUMATO_TRY_ASSIGN(const std::string& bytes, read_any_text(context_, arguments_.input));
  ScopedCharge held;
  SFUMATO_TRY(held.add(context_, capacity_bytes(bytes), "the input"));
  if (!is_solved(bytes)) {
    const std::string_view kind = codecs::kind_text(codecs::file_kind(bytes));
    return make_error(StatusCode::bad_input,
                      (kind.empty() ? "" : "is " + std::string(kind) + "; ") +
                          "use a solved picture, which `sfumato solve` makes of a drawing",
                      {display_name(arguments_.input)});
  }
  SFUMATO_TRY_ASSIGN(
      const auto& checksum,
      picture::checksum(context_,
                        {reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()}));
  checksum_ = checksum;
  SFUMATO_TRY_ASSIGN(solved_, read_solved(context_, arguments_.input, bytes));
  return charge_.add(context_, bytes_of(solved_.picture), "the picture");
}

Status TilesJob::choose_options() {
  std::optional<Rgb>& background = solved_.picture.background;
  if (settings_.raster.background) background = settings_.raster.background;
  if (settings_.no_background) background.reset();
  if (arguments_.extension == "jpg" && !background) background = Rgb{1, 1, 1};
  raster_ = settings_.raster;
  raster_.format = background ? PixelFormat::rgb8 : PixelFormat::rgba8;
  const double scale = solved_.origin.pixels_per_unit;
  SFUMATO_TRY_ASSIGN(const output::OutputSize& size,
                     output::output_size(context_.limits, settings_.size, solved_.picture.viewport,
                                         {scale, scale}, true));
  raster_.width = size.width;
  raster_.height = size.height;
  pyramid_ = {size.width, size.height, arguments_.tile_side, arguments_.overlap};
  const std::string complaint = complaint_about_scale(scale, size.pixels_per_unit);
  if (!complaint.empty() && !arguments_.quiet) {
    report_warning({complaint, {display_name(arguments_.input)}});
  }
  return ok_status();
}

/// Returns a text of everything that affects the bytes of tiles and is not in the description.
std::string TilesJob::fingerprint() const {
  std::string text = "sfumato: picture " + hexadecimal(checksum_);
  if (solved_.picture.background) text += ", on " + color_text(*solved_.picture.background);
  if (raster_.dither) text += ", dithered";
  if (!raster_.antialias) text += ", hard edges";
  if (settings_.output.lossless) text += ", lossless";
  if (arguments_.extension != "png")
    text += ", quality " + std::to_string(*settings_.output.quality);
  return text;
}

Status TilesJob::write_deep_zoom() {
  tiles::DeepZoomOptions options;
  options.pyramid = pyramid_;
  options.raster = raster_;
  options.path = arguments_.output;
  options.format = arguments_.extension;
  options.fingerprint = fingerprint();
  options.shard = arguments_.shard;
  const OutputKind kind = *options::kind_of_extension(arguments_.extension);
  const auto encode = [&](Context& context, Image& tile) -> Result<std::vector<std::uint8_t>> {
    SFUMATO_TRY(output::drop_opaque_alpha(context, tile));
    return output::encode_image(context, tile, kind, settings_.output);
  };
  return tiles::write_deep_zoom(context_, solved_.picture, options, encode, &deep_zoom_);
}

Status TilesJob::write_tiff() {
  return tiles::write_big_tiff(context_, solved_.picture, {pyramid_, raster_, arguments_.output},
                               &tiff_);
}

Status TilesJob::write_stats(double seconds) const {
  if (arguments_.stats.empty()) return ok_status();
  JsonWriter json;
  json.begin_object()
      .member("width", pyramid_.width)
      .member("height", pyramid_.height)
      .member("levels", arguments_.is_tiff ? tiff_.levels : pyramid_.level_count())
      .member("tiles", arguments_.is_tiff ? tiff_.tiles : deep_zoom_.tiles);
  if (!arguments_.is_tiff) {
    json.member("blocks", deep_zoom_.blocks)
        .member("skipped_blocks", deep_zoom_.skipped_blocks)
        .member("bytes", deep_zoom_.bytes);
  }
  json.member("threads", context_.thread_count())
      .member("seconds", to_nanosecond(seconds))
      .end_object();
  const std::string text = json.text() + '\n';
  return write_file(arguments_.stats,
                    {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}, &context_);
}

Status TilesJob::run() {
  const Stopwatch watch;
  context_.deadline = deadline_of(arguments_.resources);
  Status status = read();
  if (status) status = choose_options();
  if (status && !arguments_.is_tiff) {
    const std::string folder = std::filesystem::path(arguments_.output).parent_path().string();
    if (!folder.empty()) status = make_folder(folder);
  }
  if (status) status = arguments_.is_tiff ? write_tiff() : write_deep_zoom();
  if (status) status = write_stats(watch.seconds());
  return naming(arguments_.input, std::move(status));
}

}  // namespace

int tiles(const TilesArguments& arguments) {
  CommandContext work(arguments, arguments.settings.threads);
  const Status status = TilesJob(work.context(), arguments).run();
  if (work.bar()) work.bar()->erase();
  return status ? kDone : fail(status);
}

}  // namespace sfumato::cli
