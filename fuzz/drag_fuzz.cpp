// A document, then bytes that drag some of its curves, or change values of their stops. Every frame
// is a valid picture of the document with the curve at its place or the stop at its value, and the
// same place gives the same picture. A failed frame changes nothing. Afterwards the picture equals
// the picture of diffuse, and exactly the memory in use is charged.
#include <algorithm>
#include <utility>

#include "drawn_document.hpp"
#include "fuzz.hpp"
#include "picture/check_picture.hpp"
#include "sfumato/solve/solution.hpp"
#include "support/cancel_at.hpp"
#include "support/same_document.hpp"
#include "support/same_picture.hpp"

using namespace sfumato;

namespace {

constexpr int kMostDrags = 3;
constexpr int kFrames = 3;
/// Bytes before the document.
constexpr std::size_t kStepBytes = kMostDrags * (2 + 4 * kFrames);

void require_told(const Status& status) {
  if (status.code != StatusCode::cancelled) fuzz::require_honest(status);
}

/// Makes a frame without time, and then the rest, a little at a time.
Status drag_in_steps(Context& context, Solution& solution, const Curve& curve) {
  Status status = solution.drag(context, {curve}, nullptr, 0);
  while (const std::size_t left = status ? solution.waiting_nodes() : 0) {
    fuzz::require_ok(picture::check_picture(context, solution.picture()), "a frame is no picture");
    if (!solution.drag_more(context, nullptr, 0)) break;  // the frame is complete
    fuzz::require(solution.waiting_nodes() < left, "nothing was gathered");
  }
  return status;
}

/// Drags a curve; some frames are cancelled, or made in steps.
Status drag(Context& context, Solution& solution, const Curve& curve, unsigned cancelled_at) {
  if (cancelled_at == 0) return solution.drag(context, {curve});
  if (cancelled_at % 3 == 0) return drag_in_steps(context, solution, curve);
  Context hurried{.budget = Budget(fuzz::kBudgetBytes)};
  test::CancelAt watch(8 * cancelled_at, hurried.cancel);
  hurried.poll_watch = &watch;
  return solution.drag(hurried, {curve});
}

void require_frame(Context& context, Solution& solution, std::uint32_t layer, std::uint32_t curve,
                   const Curve& moved, unsigned cancelled_at) {
  const Document document = solution.document();
  const Picture picture = solution.picture();
  const Status status = drag(context, solution, moved, cancelled_at);
  if (status) {
    fuzz::require(solution.document().layers[layer].curves[curve] == moved,
                  "the curve is not there");
    fuzz::require_ok(picture::check_picture(context, solution.picture()), "a frame is no picture");
    return;
  }
  require_told(status);
  fuzz::require(test::same_document(solution.document(), document), "a failure moved a curve");
  fuzz::require(test::difference_of(solution.picture(), picture).empty(), "a failure drew");
}

Curve at_next_place(fuzz::ByteReader& bytes, const Document& document, Curve curve) {
  const Vec2 by = {bytes.unit() * document.artboard.width(),
                   bytes.unit() * document.artboard.height()};
  const unsigned only = bytes.byte();
  for (std::size_t i = 0; i < curve.control_points.size(); ++i) {
    if (only >= 128 || only % curve.control_points.size() == i) {
      curve.control_points[i] = curve.control_points[i] + by;
    }
  }
  return curve;
}

/// Returns a stop of a curve that bytes choose; the stop may not exist.
StopPlace next_stop(fuzz::ByteReader& bytes, std::uint32_t layer, std::uint32_t curve) {
  const unsigned choice = bytes.byte();
  StopPlace place{layer, curve, choice % 2 == 0 ? CurveSide::left : CurveSide::right,
                  choice / 2 % 2 == 0 ? StopAttribute::color : StopAttribute::opacity,
                  choice / 4 % 4};
  if (place.index == 3u) place.index.reset();
  return place;
}

/// Returns a value that is sometimes outside the range of a stop.
StopValue next_value(fuzz::ByteReader& bytes, StopAttribute attribute) {
  const auto number = [&] { return static_cast<float>(1.05 * bytes.unit()); };
  if (attribute == StopAttribute::opacity) return number();
  const float r = number(), g = number(), b = number();
  return Rgb{r, g, b};
}

/// Gives the stop a value. A failure must change nothing.
bool require_color(Context& context, Solution& solution, const StopPlace& place,
                   const StopValue& value) {
  const Document document = solution.document();
  const Picture picture = solution.picture();
  const Status status = solution.color(context, value);
  if (status) {
    const PatchLayer& shown = solution.picture().layers[place.layer];
    const PatchField& field = place.attribute == StopAttribute::color ? shown.color : shown.opacity;
    fuzz::require(
        solution.color_response().size() * static_cast<std::size_t>(field.channel_count) ==
            field.node_value.size(),
        "a response is not of the nodes that are shown");
    fuzz::require_ok(picture::check_picture(context, solution.picture()), "colours are no picture");
    return true;
  }
  require_told(status);
  fuzz::require(test::same_document(solution.document(), document), "a failure changed a stop");
  fuzz::require(test::difference_of(solution.picture(), picture).empty(), "a failure drew");
  return false;
}

void color_one(Context& context, fuzz::ByteReader& bytes, Solution& solution, std::uint32_t layer,
               std::uint32_t curve) {
  const StopPlace place = next_stop(bytes, layer, curve);
  if (Status status = solution.begin_color(context, place); !status) return require_told(status);
  const StopValue first = next_value(bytes, place.attribute);
  if (!require_color(context, solution, place, first)) return;
  const Picture picture = solution.picture();
  require_color(context, solution, place, next_value(bytes, place.attribute));
  if (!require_color(context, solution, place, first)) return;
  fuzz::require(test::difference_of(solution.picture(), picture).empty(),
                "a colour depends on those before it");
}

void drag_one(Context& context, fuzz::ByteReader& bytes, Solution& solution) {
  const auto layer = static_cast<std::uint32_t>(bytes.byte() % solution.document().layers.size());
  const auto count = solution.document().layers[layer].curves.size();
  const unsigned choice = bytes.byte();
  if (count == 0) return;
  if (choice >= 128) {
    return color_one(context, bytes, solution, layer, static_cast<std::uint32_t>(choice % count));
  }
  const auto curve = static_cast<std::uint32_t>(choice % count);
  if (Status status = solution.begin_drag(context, layer, {curve}); !status) {
    return require_told(status);
  }
  const Curve before = solution.document().layers[layer].curves[curve];
  for (int i = 0; i < kFrames; ++i) {
    const Curve moved = at_next_place(bytes, solution.document(), before);
    const unsigned cancelled_at = bytes.below(4) == 0 ? bytes.byte() : 0u;
    require_frame(context, solution, layer, curve, moved, cancelled_at);
  }
  if (!solution.drag(context, {before})) return;
  const Picture first = solution.picture();
  (void)solution.drag(context, {at_next_place(bytes, solution.document(), before)});
  if (!solution.drag(context, {before})) return;
  fuzz::require(test::difference_of(solution.picture(), first).empty(),
                "a frame depends on those before it");
}

bool solve(Context& context, Solution& solution, const DiffuseOptions& options) {
  const Status status = solution.solve(context, options);
  if (!status) require_told(status);
  return status.ok();
}

void run(Context& context, fuzz::ByteReader bytes, const Document& document) {
  const DiffuseOptions options = fuzz::coarse_options(document);
  Result<Solution> solution = Solution::create(context, document);
  if (!solution) return fuzz::require_honest(solution.status());
  while (!bytes.at_end() && solve(context, *solution, options)) {
    drag_one(context, bytes, *solution);
  }
  solution->end_drag();
  if (!solve(context, *solution, options)) return;
  Context fresh{.budget = Budget(fuzz::kBudgetBytes)};
  const Result<Picture> expected = diffuse(fresh, solution->document(), options);
  if (!expected) return require_told(expected.status());
  fuzz::require(test::difference_of(solution->picture(), *expected).empty(),
                "after a drag a solution has another picture than diffuse");
  // The data for the begin of drags depends on the options, and is reserved only for the owner.
  Context visitor{.budget = Budget(fuzz::kBudgetBytes)};
  DiffuseOptions other = options;
  other.max_error += 1;
  if (!solve(visitor, *solution, other)) return;
  fuzz::require(
      context.budget.used() == bytes_of(solution->document()) + bytes_of(solution->picture()),
      "what is charged is not what is held");
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Context context{.budget = Budget(fuzz::kBudgetBytes)};
  const fuzz::Bytes bytes(data, size);
  const fuzz::Bytes steps = bytes.first(std::min(size, kStepBytes));
  const std::optional<Document> document =
      fuzz::drawn_document(context, bytes.subspan(steps.size()));
  if (!document || document->layers.empty() || !fuzz::is_small(*document)) return 0;
  run(context, fuzz::ByteReader(steps), *document);
  fuzz::require(context.budget.used() == 0, "a solution keeps what it charged");
  return 0;
}
