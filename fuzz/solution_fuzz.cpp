// A document, then bytes that choose changes to it. After each solve the picture equals diffuse's
// picture of the changed document, the value that a change returned takes it back, and exactly the
// memory in use is charged. Some solves are cancelled.
#include <algorithm>
#include <utility>

#include "base/limit_error.hpp"
#include "drawn_document.hpp"
#include "fuzz.hpp"
#include "sfumato/solve/solution.hpp"
#include "support/cancel_at.hpp"
#include "support/same_document.hpp"
#include "support/same_picture.hpp"

using namespace sfumato;

namespace {

constexpr int kMostSteps = 6;
/// Bytes before the document.
constexpr std::size_t kStepBytes = 4 * kMostSteps;

/// Returns a curve of the document, moved.
Curve moved_curve(fuzz::ByteReader& bytes, const Document& document, std::uint32_t layer) {
  const std::vector<Curve>& curves = document.layers[layer].curves;
  if (curves.empty()) return {};
  Curve curve = curves[bytes.byte() % curves.size()];
  const Vec2 by = {bytes.unit() * document.artboard.width() / 4,
                   bytes.unit() * document.artboard.height() / 4};
  for (Vec2& point : curve.control_points) point = point + by;
  return curve;
}

Change next_change(fuzz::ByteReader& bytes, const Document& document, const Document& first) {
  const unsigned kind = bytes.below(6);
  if (kind == 0 || document.layers.empty()) return ReplaceDocument{first};
  if (kind == 1) {
    std::vector<StackItem> stack = document.stack;
    if (!stack.empty()) std::swap(stack.front(), stack[bytes.byte() % stack.size()]);
    return ReplaceStack{std::move(stack)};
  }
  const auto layer = static_cast<std::uint32_t>(bytes.byte() % document.layers.size());
  const std::size_t count = document.layers[layer].curves.size();
  const auto curve = static_cast<std::uint32_t>(bytes.byte() % (count + 1));  // or sometimes none
  if (kind == 2) return InsertCurve{layer, curve, moved_curve(bytes, document, layer)};
  if (kind == 3) return RemoveCurve{layer, curve};
  return ReplaceCurve{layer, curve, moved_curve(bytes, document, layer)};
}

/// Applies a change, takes it back, and applies it again.
void apply(Context& context, Solution& solution, const Change& change) {
  const Document before = solution.document();
  const Result<Change> inverse = solution.apply(context, change);
  if (!inverse) fuzz::require_honest(inverse.status());
  if (inverse) {
    const Result<Change> again = solution.apply(context, *inverse);
    fuzz::require_ok(again.status(), "a change cannot be taken back");
  }
  fuzz::require(test::same_document(solution.document(), before), "a change was not taken back");
  if (inverse) fuzz::require_ok(solution.apply(context, change).status(), "once, but not twice");
}

void solve(Context& context, Solution& solution, unsigned cancelled_at) {
  const DiffuseOptions options = fuzz::coarse_options(solution.document());
  if (cancelled_at > 0) {
    Context hurried{.budget = Budget(fuzz::kBudgetBytes)};
    test::CancelAt watch(cancelled_at, hurried.cancel);
    hurried.poll_watch = &watch;
    const Status status = solution.solve(hurried, options);
    fuzz::require(
        status.ok() || status.code == StatusCode::cancelled || status.code == StatusCode::limit,
        "a cancelled solve says another thing");
  }
  const Status status = solution.solve(context, options);
  Context fresh{.budget = Budget(fuzz::kBudgetBytes)};
  const Result<Picture> expected = diffuse(fresh, solution.document(), options);
  if (!status || !expected) {
    if (!status) fuzz::require_honest(status);
    const bool is_memory = is_lack_of_memory(status) || is_lack_of_memory(expected.status());
    fuzz::require(status.ok() == expected.ok() || is_memory, "a solution and diffuse do not agree");
    return;
  }
  fuzz::require(test::difference_of(solution.picture(), *expected).empty(),
                "a solution has another picture than diffuse");
  fuzz::require(
      context.budget.used() == bytes_of(solution.document()) + bytes_of(solution.picture()),
      "what is charged is not what is held");
}

void run(Context& context, fuzz::ByteReader steps, const Document& document) {
  Result<Solution> solution = Solution::create(context, document);
  if (!solution) return fuzz::require_honest(solution.status());
  solve(context, *solution, steps.byte());
  while (!steps.at_end()) {
    apply(context, *solution, next_change(steps, solution->document(), document));
    if (steps.below(2) == 0 && fuzz::is_small(solution->document())) {
      solve(context, *solution, 8 * steps.byte());
    }
  }
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Context context{.budget = Budget(fuzz::kBudgetBytes)};
  const fuzz::Bytes bytes(data, size);
  const fuzz::Bytes steps = bytes.first(std::min(size, kStepBytes));
  const std::optional<Document> document =
      fuzz::drawn_document(context, bytes.subspan(steps.size()));
  if (!document || !fuzz::is_small(*document)) return 0;
  run(context, fuzz::ByteReader(steps), *document);
  fuzz::require(context.budget.used() == 0, "a solution keeps what it charged");
  return 0;
}
