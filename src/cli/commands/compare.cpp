#include <array>
#include <cstdio>
#include <string>
#include <utility>

#include "base/charge.hpp"
#include "base/table_memory.hpp"
#include "base/text/json.hpp"
#include "base/try.hpp"
#include "cli/command_context.hpp"
#include "cli/commands/commands.hpp"
#include "cli/commands/difference.hpp"
#include "cli/files/document_input.hpp"
#include "cli/files/paths.hpp"
#include "sfumato/base/native/file.hpp"
#include "sfumato/codecs/png.hpp"

namespace sfumato::cli {
namespace {

struct Percentile {
  const char* label;
  const char* key;
  int per_mille;
};

constexpr std::array<Percentile, 4> kPercentiles{
    {{"50%", "p50", 500}, {"90%", "p90", 900}, {"99%", "p99", 990}, {"99.9%", "p99.9", 999}}};

/// Reads a PNG and charges the picture. The bytes of the file are charged only while it is read.
Result<Image> read_png(Context& context, const std::string& path, ScopedCharge& charge) {
  const Result<std::string> bytes = read_up_to(context, path, limits::kPngBytes);
  if (!bytes) return naming(path, bytes.status());
  ScopedCharge held;
  Status status = held.add(context, capacity_bytes(*bytes), "the input");
  if (!status) return naming(path, std::move(status));
  if (is_solved(*bytes)) return no_solved_picture("a PNG", path);
  Result<Image> image =
      decode_png(context, {reinterpret_cast<const std::uint8_t*>(bytes->data()), bytes->size()},
                 display_name(path));
  if (image) status = charge.add(context, capacity_bytes(image->bytes), "the picture");
  if (!status) return naming(path, std::move(status));
  return image;
}

std::string image_size_text(const Image& image) {
  return std::to_string(image.width) + " x " + std::to_string(image.height);
}

std::string as_table(const Difference& difference) {
  std::string table;
  const auto row = [&table](const char* label, double number, const char* unit) {
    char line[80];
    std::snprintf(line, sizeof line, "%-8s %10.4f%s\n", label, number, unit);
    table += line;
  };
  row("rms", difference.rms(), "");
  row("psnr", difference.psnr_db(), " dB");
  row("maximum", difference.maximum(), "");
  for (const Percentile& p : kPercentiles) row(p.label, difference.percentile(p.per_mille), "");
  return table;
}

std::string as_json(const Difference& difference) {
  JsonWriter json;
  json.begin_object()
      .member("rms", difference.rms())
      .member("psnr_db", difference.psnr_db())
      .member("maximum", difference.maximum());
  json.key("percentiles").begin_object();
  for (const Percentile& p : kPercentiles) json.member(p.key, difference.percentile(p.per_mille));
  json.end_object().end_object();
  return json.text() + '\n';
}

Status write_difference(Context& context, const CompareArguments& arguments, const Image& first,
                        const Image& second) {
  TableMemory memory("the difference picture");
  SFUMATO_TRY_ASSIGN(const Image& picture,
                     difference_image(context, first, second, arguments.scale, memory));
  SFUMATO_TRY_ASSIGN(const auto& png, encode_png(context, picture));
  return write_file(arguments.output, png, &context);
}

Status compare_files(Context& context, const CompareArguments& arguments) {
  ScopedCharge charge;
  SFUMATO_TRY_ASSIGN(const Image& first, read_png(context, arguments.first, charge));
  SFUMATO_TRY_ASSIGN(const Image& second, read_png(context, arguments.second, charge));
  if (first.width != second.width || first.height != second.height) {
    return make_error(StatusCode::bad_input,
                      "the picture has " + image_size_text(second) + " pixels, but " +
                          display_name(arguments.first) + " has " + image_size_text(first) +
                          "; compare pictures of the same size",
                      {display_name(arguments.second)});
  }
  if (!arguments.output.empty()) {
    SFUMATO_TRY(write_difference(context, arguments, first, second));
  }
  SFUMATO_TRY_ASSIGN(const Difference& difference, Difference::of(context, first, second));
  return print(arguments.json ? as_json(difference) : as_table(difference), &context);
}

}  // namespace

int compare(const CompareArguments& arguments) {
  if (!arguments.output.empty()) {
    const Status writable = check_output(arguments.output);
    if (!writable) return fail(writable);
  }
  CommandContext command(arguments.resources);
  command.context().deadline = deadline_of(arguments.resources);
  const Status status = compare_files(command.context(), arguments);
  return status ? kDone : fail(naming(arguments.first, status));
}

}  // namespace sfumato::cli
