#include "sfumato/trace/trace.hpp"

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/table_memory.hpp"
#include "base/try.hpp"
#include "capi/documents/document.hpp"
#include "capi/documents/read_options.hpp"
#include "capi/pictures/pixels.hpp"
#include "options/curve_list.hpp"
#include "options/tables.hpp"

namespace sfumato::capi {
namespace {

std::uint32_t counted(std::size_t count) {
  return static_cast<std::uint32_t>(count);
}

/// Reports to a function of C.
class ForeignWatch final : public TraceWatch {
 public:
  ForeignWatch(sfumato_context* context, const sfumato_trace_watch& watch)
      : context_(context), watch_(watch) {}

  void reached(const TraceState& state, const Document& drawing) override {
    Context& work = context_->workshop->context;
    ScopedCharge charge;
    if (!charge.add(work, bytes_of(drawing), "a document")) return;
    sfumato_document handle(context_->workshop);
    handle.document = drawing;
    const sfumato_trace_state told{state.psnr_db,
                                   state.seconds,
                                   counted(static_cast<std::size_t>(state.round)),
                                   counted(static_cast<std::size_t>(state.round_count)),
                                   counted(state.curves),
                                   counted(state.control_points),
                                   counted(state.stops)};
    // Calls that the function makes with the context have their own time.
    const std::optional<Deadline> deadline = work.deadline;
    watch_.reached(watch_.user, &told, &handle);
    work.deadline = deadline;
  }

 private:
  sfumato_context* context_;
  const sfumato_trace_watch& watch_;
};

Outcome read_settings(const char* text, options::Call call, options::TraceSettings& settings) {
  SFUMATO_TRY(read_options(text, call, options::trace_options(), settings));
  if (!settings.detail) return {};
  if (settings.trace.points > 0) return bad_usage("detail: cannot be combined with points");
  settings.trace.points = options::points_of_detail(*settings.detail);
  return {};
}

/// Reads the list of the only curves to fit.
Outcome read_choice(const Context& context, const options::TraceSettings& settings,
                    TableMemory& memory, std::vector<CurveOfLayer>& only) {
  if (!settings.only) return {};
  SFUMATO_TRY(memory.reserve(context, only, options::most_curves(*settings.only)));
  if (!options::parse_curves(*settings.only, only)) {
    return bad_usage(std::string("only: use ") + options::kCurveList);
  }
  return {};
}

/// Holds the caller's pixels and the settings.
struct Wish {
  TableMemory memory{"a picture to trace"};
  Image image{};
  options::TraceSettings settings{};
};

Outcome read_wish(const Context& context, const sfumato_image* given, const char* text,
                  options::Call call, Wish& wish) {
  const std::optional<PixelFormat> format = format_of(given);
  if (!format) return bad_usage(kNoImage);
  SFUMATO_TRY(read_settings(text, call, wish.settings));
  SFUMATO_TRY_ASSIGN(wish.image, copy_image(context, *given, *format, wish.memory));
  return {};
}

Outcome trace_image(sfumato_context* context, const sfumato_image* given, const char* text,
                    const sfumato_trace_watch* watch, sfumato_document** out) {
  if (watch && !watch->reached) return bad_usage("a watch without a function");
  Context& work = context->workshop->context;
  Wish wish;
  SFUMATO_TRY(read_wish(work, given, text, options::kTrace, wish));
  std::optional<ForeignWatch> told;
  if (watch) wish.settings.trace.watch = &told.emplace(context, *watch);
  SFUMATO_TRY_ASSIGN(auto&& drawing, trace(work, wish.image, wish.settings.trace));
  return hand_out(context, std::move(drawing), {}, out);
}

Outcome fit_image(sfumato_context* context, const sfumato_document* handle,
                  const sfumato_image* given, const char* text, sfumato_document** out) {
  if (!handle) return bad_usage("NULL given; pass a document");
  Context& work = context->workshop->context;
  Wish wish;
  SFUMATO_TRY(read_wish(work, given, text, options::kFitColors, wish));
  ColorFit fit = options::color_fit_of(wish.settings);
  TableMemory only_memory("the curves to be fitted");
  SFUMATO_TRY(read_choice(work, wish.settings, only_memory, fit.only));
  SFUMATO_TRY_ASSIGN(auto&& drawing, fit_colors(work, handle->document, wish.image, fit));
  ScopedCharge charge;
  SFUMATO_TRY(charge.add(work, bytes_of(handle->origin), "a document"));
  Origin origin = handle->origin;
  charge = {};
  return hand_out(context, std::move(drawing), std::move(origin), out);
}

}  // namespace
}  // namespace sfumato::capi

int32_t sfumato_trace(sfumato_context* context, const sfumato_image* image, const char* options,
                      const sfumato_trace_watch* watch, sfumato_document** document) {
  return sfumato::capi::make(context, document, [&](sfumato::capi::Workshop&) {
    return sfumato::capi::trace_image(context, image, options, watch, document);
  });
}

int32_t sfumato_fit_colors(sfumato_context* context, const sfumato_document* drawing,
                           const sfumato_image* image, const char* options,
                           sfumato_document** document) {
  return sfumato::capi::make(context, document, [&](sfumato::capi::Workshop&) {
    return sfumato::capi::fit_image(context, drawing, image, options, document);
  });
}
