#include <algorithm>
#include <limits>
#include <span>
#include <utility>

#include "base/charge.hpp"
#include "base/try.hpp"
#include "capi/documents/document.hpp"
#include "capi/pictures/picture.hpp"
#include "options/option_reader.hpp"
#include "options/tables.hpp"
#include "output/output_size.hpp"

namespace sfumato::capi {
namespace {

/// Changed rows with at most this many rows between them form one range, with the rows between.
constexpr std::uint32_t kMostBetween = 16;

constexpr double kNoHurry = std::numeric_limits<double>::infinity();

/// Returns the range from a row to the end of a table.
RowRanges ranges_from(std::uint32_t first, std::uint32_t count) {
  if (first >= count) return {};
  return {{first, count}};
}

/// Returns the ranges of ascending rows, without rows beyond the end of a table.
RowRanges ranges_of(std::span<const std::uint32_t> rows, std::uint32_t count) {
  RowRanges ranges;
  for (const std::uint32_t row : rows) {
    if (row >= count) break;
    if (ranges.empty() || row > ranges.back()[1] + kMostBetween) ranges.push_back({row, row});
    ranges.back()[1] = row + 1;
  }
  return ranges;
}

RowRanges new_rows(const LayerRows& rows, std::uint32_t table, std::uint32_t count) {
  switch (table) {
    case SFUMATO_VERTICES:
      return ranges_from(rows.first_vertex, count);
    case SFUMATO_TRIANGLES:
    case SFUMATO_CURVE_EDGES:
    case SFUMATO_COLOR_NODES:
    case SFUMATO_OPACITY_NODES:
      return ranges_of(rows.triangles, count);
    case SFUMATO_COLOR_VALUES:
      return ranges_of(rows.nodes, count);
    case SFUMATO_OPACITY_VALUES:
      return ranges_of(rows.opacity_nodes, count);
    default:
      return {};
  }
}

/// A way to update a picture to its document. Only films use FrameLayers.
using Solve = Status (*)(Context&, const DiffuseOptions&, DiffuseStats&, FrameLayers&, Solution&);

Status solve_exactly(Context& context, const DiffuseOptions& options, DiffuseStats& stats,
                     FrameLayers&, Solution& solution) {
  return solution.solve(context, options, &stats);
}

Status solve_roughly(Context& context, const DiffuseOptions& options, DiffuseStats& stats,
                     FrameLayers&, Solution& solution) {
  return solution.solve_roughly(context, options, &stats);
}

Status solve_frame(Context& context, const DiffuseOptions& options, DiffuseStats& stats,
                   FrameLayers& frame, Solution& solution) {
  return solution.solve_next(context, options, &frame, &stats);
}

/// Updates the picture to the document of its solution. All steps that may fail precede the changes
/// of the handle.
Status bring_up(Context& context, Solve solve, sfumato_picture& handle) {
  const Document& document = handle.solution->document();
  std::vector<ChangedRows> changed(document.layers.size());
  const DiffuseOptions options = solve_options(handle.settings, document);
  DiffuseStats stats;
  FrameLayers frame;
  SFUMATO_TRY(solve(context, options, stats, frame, *handle.solution));
  handle.count(stats, frame);
  note_changes(handle.picture(), handle.solution->take_delta(), changed);
  handle.changed = std::move(changed);
  handle.own_scale = output::own_scale(document);
  handle.pixels_per_unit = options.pixels_per_unit;
  return ok_status();
}

/// Copies a document. Errors: limit if there is no memory for the copy.
Result<Document> copy_of(const Context& context, const Document& document) {
  ScopedCharge charge;
  SFUMATO_TRY(charge.add(context, bytes_of(document), "a document"));
  return document;
}

Outcome solve(Workshop& workshop, sfumato_context* context, const sfumato_document& document,
              const char* text, sfumato_picture** out) {
  options::Settings settings;
  options::PictureSettings own;
  SFUMATO_TRY(read_solve_options(text, options::kSolve, settings, &own));
  settings.diffuse.pixel_grid = own.pixel_grid;
  SFUMATO_TRY_ASSIGN(auto&& copy, copy_of(workshop.context, document.document));
  SFUMATO_TRY_ASSIGN(auto&& solution, Solution::create(workshop.context, std::move(copy)));
  auto handle = std::make_unique<sfumato_picture>(context->workshop, std::move(solution), settings);
  if (own.drag_triangles) handle->solution->expect_drags(*own.drag_triangles);
  SFUMATO_TRY(bring_up(workshop.context, settings.coherent ? solve_frame : solve_exactly, *handle));
  handle->shown = handle->applied = document.revisions;
  *out = handle.release();
  return {};
}

/// Replaces the changed curves, except by equal ones.
Status replace_curves(Context& context, const std::vector<LayerCurves>& changed,
                      const Document& document, Solution& solution) {
  for (const auto& [layer, curves] : changed) {
    for (const std::uint32_t curve : curves) {
      const Curve& now = document.layers[layer].curves[curve];
      if (solution.document().layers[layer].curves[curve] == now) continue;
      ScopedCharge charge;
      SFUMATO_TRY(charge.add(context, bytes_of(now), "changes of a document"));
      SFUMATO_TRY(solution.apply(context, ReplaceCurve{layer, curve, now}));
    }
  }
  return ok_status();
}

Status replace_all(Context& context, const Document& document, Solution& solution) {
  SFUMATO_TRY_ASSIGN(auto&& copy, copy_of(context, document));
  return solution.apply(context, ReplaceDocument{std::move(copy)}).status();
}

/// Makes the solution's document equal to the other one.
Status follow(Context& context, const sfumato_document& document, sfumato_picture& handle) {
  const auto changed = changed_curves(handle.applied, document.revisions);
  Revisions applied = document.revisions;
  handle.applied = {};  // until all changes are applied
  SFUMATO_TRY(changed ? replace_curves(context, *changed, document.document, *handle.solution)
                      : replace_all(context, document.document, *handle.solution));
  handle.applied = std::move(applied);
  return ok_status();
}

/// Updates the picture after any changes of the document.
Outcome solve_all(Workshop& workshop, const sfumato_document& document, Solve solve,
                  sfumato_picture& handle) {
  handle.solution->end_drag();
  handle.dragged.reset();
  handle.colored.reset();
  handle.has_moved = false;
  handle.drag_workshop.reset();
  Revisions shown = document.revisions;
  handle.shown = {};  // until the picture is updated
  SFUMATO_TRY(follow(workshop.context, document, handle));
  SFUMATO_TRY(bring_up(workshop.context, solve, handle));
  handle.shown = std::move(shown);
  return ok_status();
}

/// Gathers nodes that wait, drags the changed curves, or changes the colour of a stop. Returns
/// false if more changed.
Result<bool> solve_changes(sfumato_context& context, const sfumato_document& document,
                           double seconds, sfumato_picture& handle) {
  const auto changed = changed_curves(handle.shown, document.revisions);
  if (changed && changed->empty() && handle.solution->waiting_nodes() == 0) {
    for (ChangedRows& rows : handle.changed) rows = {};
    handle.count({});
  } else if (changed && changed->empty()) {
    SFUMATO_TRY(show_more(context, seconds, handle));
  } else if (changed && changed->size() == 1 &&
             may_be_dragged(changed->front(), document.document)) {
    SFUMATO_TRY(show_changes(context, changed->front(), document, seconds, handle));
  } else {
    return false;
  }
  return true;
}

Outcome solve_quickly(sfumato_context& context, const sfumato_document& document, double seconds,
                      sfumato_picture& handle) {
  const Result<bool> is_shown = solve_changes(context, document, seconds, handle);
  if (is_shown && *is_shown) return {};
  // The tables of a drag may exceed a limit that the layer alone does not exceed.
  const StatusCode code = is_shown.status().code;
  const bool is_refused = code == StatusCode::bad_input || code == StatusCode::limit;
  if (!is_shown && !is_refused) return is_shown.status();
  return solve_all(*context.workshop, document, solve_roughly, handle);
}

Outcome expect_pair(const sfumato_document* document, const sfumato_picture* handle) {
  if (!document || !handle) return bad_usage("NULL given; pass a document and a picture");
  return handle->solution ? Outcome() : no_solution();
}

Outcome solve_again(sfumato_context& context, const sfumato_document* document, std::int32_t quick,
                    sfumato_picture* handle) {
  SFUMATO_TRY(expect_pair(document, handle));
  return quick != 0 ? solve_quickly(context, *document, kNoHurry, *handle)
                    : solve_all(*context.workshop, *document, solve_exactly, *handle);
}

Outcome solve_next(Workshop& workshop, const sfumato_document* document, sfumato_picture* handle) {
  SFUMATO_TRY(expect_pair(document, handle));
  if (!handle->settings.coherent) {
    return bad_usage(
        "a picture that is not a frame of a film; pass one of sfumato_solve() with coherent");
  }
  return solve_all(workshop, *document, solve_frame, *handle);
}

Outcome solve_within(sfumato_context& context, const sfumato_document* document, double seconds,
                     sfumato_picture* handle) {
  SFUMATO_TRY(expect_pair(document, handle));
  if (!(seconds >= 0)) return bad_usage("seconds: use at least 0");
  return solve_quickly(context, *document, seconds, *handle);
}

}  // namespace

Outcome no_solution() {
  return bad_usage(
      "a picture that was read from a file follows no document; pass one of sfumato_solve()");
}

void note_changes(const Picture& picture, const PictureDelta& delta,
                  std::vector<ChangedRows>& changed) {
  for (const std::uint32_t layer : delta.layers) {
    if (layer >= changed.size()) continue;
    const auto known = std::ranges::lower_bound(delta.rows, layer, {}, &LayerRows::layer);
    const bool knows_rows = known != delta.rows.end() && known->layer == layer;
    for (std::uint32_t table = 0; table < changed[layer].size(); ++table) {
      const auto count = static_cast<std::uint32_t>(table_of(picture.layers[layer], table).rows);
      changed[layer][table] = knows_rows ? new_rows(*known, table, count) : ranges_from(0, count);
    }
  }
}

DiffuseOptions solve_options(const options::Settings& settings, const Document& document) {
  DiffuseOptions options = settings.diffuse;
  const Box viewport = options.viewport.value_or(document.artboard);
  options.viewport = viewport;
  options.pixels_per_unit =
      output::output_scale(settings.size, viewport, output::own_scale(document)) *
      settings.output.detail.value_or(1);
  return options;
}

Outcome read_solve_options(const char* text, options::Call call, options::Settings& settings,
                           options::PictureSettings* picture) {
  options::OptionReader reader(call);
  reader.take(options::render_options(), settings);
  if (picture) reader.take(options::picture_options(), *picture);
  if (Status status = reader.read(text ? text : ""); !status) return bad_usage(std::move(status));
  if (settings.size.scale && (settings.size.width || settings.size.height)) {
    return bad_usage("scale: cannot be combined with width and height");
  }
  if (settings.method == options::Method::pixels) {
    return bad_usage("method: \"pixels\" given, which makes no picture; use exact or rays");
  }
  if (settings.coherent && settings.method != options::Method::exact) {
    return bad_usage("coherent: works with method=exact only");
  }
  return {};
}

}  // namespace sfumato::capi

int32_t sfumato_solve(sfumato_context* context, const sfumato_document* document,
                      const char* options, sfumato_picture** picture) {
  using sfumato::capi::Outcome;
  const auto body = [&](sfumato::capi::Workshop& workshop) -> Outcome {
    if (!document) return sfumato::capi::bad_usage("NULL given; pass a document");
    return sfumato::capi::solve(workshop, context, *document, options, picture);
  };
  return sfumato::capi::make(context, picture, body);
}

int32_t sfumato_solve_again(sfumato_context* context, const sfumato_document* document,
                            int32_t quick, sfumato_picture* picture) {
  return sfumato::capi::call(context, [&](sfumato::capi::Workshop&) {
    return sfumato::capi::solve_again(*context, document, quick, picture);
  });
}

int32_t sfumato_solve_within(sfumato_context* context, const sfumato_document* document,
                             double seconds, sfumato_picture* picture) {
  return sfumato::capi::call(context, [&](sfumato::capi::Workshop&) {
    return sfumato::capi::solve_within(*context, document, seconds, picture);
  });
}

int32_t sfumato_solve_next(sfumato_context* context, const sfumato_document* document,
                           sfumato_picture* picture) {
  return sfumato::capi::call(context, [&](sfumato::capi::Workshop& workshop) {
    return sfumato::capi::solve_next(workshop, document, picture);
  });
}

void sfumato_picture_free(sfumato_picture* picture) {
  delete picture;
}
