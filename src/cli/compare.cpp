#include <array>
#include <cstdio>
#include <string>

#include "base/charge.hpp"
#include "base/json.hpp"
#include "base/table_memory.hpp"
#include "cli/commands.hpp"
#include "cli/difference.hpp"
#include "cli/document_input.hpp"
#include "cli/interrupt.hpp"
#include "cli/paths.hpp"
#include "sfumato/base/native/file.hpp"
#include "sfumato/base/native/thread_pool.hpp"
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

Result<Image> read_png(Context& context, const std::string& path, const std::string& bytes) {
  if (is_solved(bytes)) return no_solved_picture("a PNG", path);
  return decode_png(context, {reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()},
                    display_name(path));
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
  const Result<Image> picture = difference_image(context, first, second, arguments.scale, memory);
  if (!picture) return picture.status();
  const auto png = encode_png(context, *picture);
  if (!png) return png.status();
  return write_file(arguments.output, *png, &context);
}

Status compare_files(Context& context, const CompareArguments& arguments,
                     const std::string& first_bytes, const std::string& second_bytes) {
  ScopedCharge charge;
  Status status = charge.add(context, capacity_bytes(first_bytes, second_bytes), "the input");
  if (!status) return status;
  const Result<Image> first = read_png(context, arguments.first, first_bytes);
  if (!first) return first.status();
  const Result<Image> second = read_png(context, arguments.second, second_bytes);
  if (!second) return second.status();
  status = charge.add(context, capacity_bytes(first->bytes, second->bytes), "the pictures");
  if (!status) return status;
  if (first->width != second->width || first->height != second->height) {
    return make_error(StatusCode::bad_input,
                      "this picture is " + image_size_text(*second) + " pixels, expected " +
                          image_size_text(*first) + " as " + display_name(arguments.first),
                      {display_name(arguments.second)});
  }
  if (!arguments.output.empty()) {
    status = write_difference(context, arguments, *first, *second);
    if (!status) return status;
  }
  const Result<Difference> difference = Difference::of(context, *first, *second);
  if (!difference) return difference.status();
  return print(arguments.json ? as_json(*difference) : as_table(*difference), &context);
}

}  // namespace

int compare(const CompareArguments& arguments) {
  if (!arguments.output.empty()) {
    const Status writable = check_output(arguments.output);
    if (!writable) return fail(writable);
  }
  ThreadPool executor;
  Context context{.executor = &executor,
                  .budget = Budget(arguments.resources.memory_bytes),
                  .limits = arguments.resources.limits,
                  .deadline = deadline_of(arguments.resources)};
  const CancelOnSignal cancel_on_signal(context.cancel);
  const Result<std::string> first = read_input(context, arguments.first, limits::kPngBytes);
  if (!first) return fail(first.status());
  const Result<std::string> second = read_input(context, arguments.second, limits::kPngBytes);
  if (!second) return fail(second.status());
  const Status status = compare_files(context, arguments, *first, *second);
  return status ? kDone : fail(status);
}

}  // namespace sfumato::cli
