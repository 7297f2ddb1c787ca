// The option strings of the C interface, after a byte that chooses the call: settings within their
// ranges, or an error with a message; two reads give the same result.
#include <cmath>
#include <limits>
#include <optional>

#include "fuzz.hpp"
#include "options/option_reader.hpp"
#include "options/tables.hpp"
#include "sfumato/base/limits.hpp"

using namespace sfumato;

namespace {

constexpr options::Call kCalls[] = {options::kContext, options::kNewDocument, options::kSolve,
                                    options::kRaster,  options::kExport,      options::kEncode,
                                    options::kField};

/// All settings that strings can change.
struct Targets {
  options::Resources resources{};
  options::ContextSettings context{};
  options::DocumentSettings document{};
  options::Settings settings{};
};

Status read(options::Call call, std::string_view text, Targets& targets) {
  options::OptionReader reader(call);
  reader.take(options::resource_options(), targets.resources);
  reader.take(options::context_options(), targets.context);
  reader.take(options::document_options(), targets.document);
  reader.take(options::render_options(), targets.settings);
  if (call == options::kContext) reader.take_limits(targets.resources.limits);
  return reader.read(text);
}

constexpr int kAny = std::numeric_limits<int>::max();

bool is_within(const std::optional<int>& value, int least, int most) {
  return !value || (*value >= least && *value <= most);
}

void require_ranges(const Targets& targets) {
  const options::Settings& s = targets.settings;
  fuzz::require(is_within(s.size.width, 1, kAny) && is_within(s.size.height, 1, kAny),
                "a size of no image");
  fuzz::require(!s.size.scale || (std::isfinite(*s.size.scale) && *s.size.scale > 0), "no scale");
  fuzz::require(is_within(s.output.quality, 0, 100), "a quality beyond 100");
  fuzz::require(s.depth == 8 || s.depth == 16, "a depth of no PNG");
  fuzz::require(std::isfinite(s.diffuse.max_error) && s.diffuse.max_error >= 0, "no error bound");
  fuzz::require(
      s.diffuse.gather.rays_per_node >= 1 && s.diffuse.gather.rays_per_node <= limits::kRays,
      "rays beyond their range");
  fuzz::require(!targets.resources.seconds ||
                    (std::isfinite(*targets.resources.seconds) && *targets.resources.seconds >= 0),
                "a time that is none");
  if (targets.document.artboard) {
    const Box& box = *targets.document.artboard;
    fuzz::require(box.width() > 0 && box.height() > 0, "an artboard without area");
  }
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::ByteReader bytes({data, size});
  const options::Call call = kCalls[bytes.byte() % std::size(kCalls)];
  const std::string_view text = fuzz::as_text(bytes.rest());
  Targets targets;
  const Status status = read(call, text, targets);
  require_ranges(targets);
  Targets again;
  const Status other = read(call, text, again);
  fuzz::require(status.code == other.code && status.message == other.message,
                "a string is read in two ways");
  if (!status) fuzz::require_honest(status);
  return 0;
}
