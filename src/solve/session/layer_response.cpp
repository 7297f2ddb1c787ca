#include "solve/session/layer_response.hpp"

#include <algorithm>
#include <utility>

#include "base/limit_error.hpp"
#include "base/no_throw.hpp"
#include "base/try.hpp"
#include "curves/response.hpp"
#include "solve/layers/layer_units.hpp"

namespace sfumato::solve {
namespace {

/// The fields of a layer, one of them with the response as a channel.
struct Prepared {
  PreparedFields fields;
  Box frame;
  SmallestEdges smallest_edges;
};

/// Returns a mark per segment: 1 for the segments of the curve.
Result<std::vector<std::uint8_t>> segments_of(const Context& context,
                                              const curves::FlatCurves& flat, std::uint32_t curve,
                                              TableMemory& memory) {
  std::vector<std::uint8_t> marks;
  SFUMATO_TRY(memory.resize(context, marks, flat.vertex.size()));
  std::fill(marks.begin() + flat.curve_begin[curve], marks.begin() + flat.curve_begin[curve + 1],
            std::uint8_t{1});
  return marks;
}

/// Samples colour and opacity as two fields: one field has no room for both and a response.
Result<SampledFields> sample(const Context& context, const curves::FlatCurves& flat,
                             const Document& document, const StopPlace& place,
                             const DiffuseOptions& options, double fine_radius) {
  const std::vector<Curve>& curves = document.layers[place.layer].curves;
  SFUMATO_TRY_ASSIGN(
      auto&& sampled,
      sample_fields(context, {flat, curves, document.interpolation, false}, options, fine_radius));
  SampledField& field = place.attribute == StopAttribute::color ? sampled.color : *sampled.opacity;
  SFUMATO_TRY(curves::add_response(context, flat, curves, place, field.attributes));
  return std::move(sampled);
}

Result<Prepared> prepare(Context& context, const Document& document, const StopPlace& place,
                         const LayerSight& sight, const DiffuseOptions& options,
                         const FlatMesh& flat_mesh) {
  const LayerUnits units(document.artboard, sight, options);
  SFUMATO_TRY_ASSIGN(auto&& sampled, sample(context, flat_mesh.flat, document, place, options,
                                            units.smallest_radius()));
  TableMemory memory("the response of a layer");
  SFUMATO_TRY_ASSIGN(const std::vector<std::uint8_t>& answers,
                     segments_of(context, flat_mesh.flat, place.curve, memory));
  const std::vector<Curve>& curves = document.layers[place.layer].curves;
  FieldEdits edits{.use = {answers}};
  edits.is_parted = curves::opacity_goes_with_color(curves);
  SFUMATO_TRY_ASSIGN(auto&& fields, prepare_fields(context, flat_mesh.mesher, flat_mesh.mesh,
                                                   std::move(sampled), options.ends, edits));
  return Prepared{std::move(fields), units.mesh_options().frame, units.smallest_edges()};
}

Status solve_first(Context& context, const Document& document, std::uint32_t layer,
                   const LayerSight& sight, const DiffuseOptions& options,
                   std::optional<RefinedLayer>& refined, DiffuseStats* stats) {
  SFUMATO_TRY_ASSIGN(auto&& prepared, prepare_layer(context, document, layer, sight, options, stats,
                                                    LayerUse::drags));
  SFUMATO_TRY(LayerSolver(context, std::move(prepared), options, stats).solve(&refined));
  if (refined) return ok_status();
  return make_limit_error("memory", "memory limit reached: a layer's nodes cannot be kept");
}

/// Moves the last base channel of the field into the response.
Status split_factor(const Context& context, const curves::SegmentAttributes& attributes,
                    PatchField& field, LayerResponse& response) {
  SFUMATO_TRY_ASSIGN(auto&& split,
                     split_channel(context, field, attributes.base_channels - 1, response.memory));
  response.memory.free(split.triangle_node);
  response.factor = std::move(split.node_value);
  return ok_status();
}

Result<LayerResponse> take(const Context& context, const StopPlace& place, LayerSolver& solver) {
  const bool is_color = place.attribute == StopAttribute::color;
  SFUMATO_TRY_ASSIGN(auto&& layer, solver.take());
  LayerResponse response{std::move(layer), {}};
  const PreparedField& field = is_color ? solver.color() : *solver.opacity();
  SFUMATO_TRY(split_factor(context, field.attributes,
                           is_color ? response.layer.color : response.layer.opacity, response));
  return response;
}

}  // namespace

Status LayerSolver::answer(const RefinedNodes& known) {
  Status status = take_mesh();
  if (status) status = lay_out();
  const bool was_joint = opacity_ && !known.opacity;
  const int colors = was_joint ? kOpacityChannel + 1 : kOpacityChannel;
  if (status) status = color_.take_over(context_, known.color, 0, colors);
  if (status && opacity_) {
    status = was_joint ? opacity_->take_over(context_, known.color, kOpacityChannel, colors)
                       : opacity_->take_over(context_, *known.opacity, 0, 1);
  }
  return status ? gather(gather::GatherOptions{}, false) : status;
}

Result<LayerResponse> respond(Context& context, const Document& document, const StopPlace& place,
                              const LayerSight& sight, const DiffuseOptions& options,
                              std::optional<RefinedLayer>& refined, DiffuseStats* stats) {
  DiffuseOptions exact = options;
  exact.gather = {};

  if (!refined) {
    SFUMATO_TRY(solve_first(context, document, place.layer, sight, exact, refined, stats));
  }
  SFUMATO_TRY_ASSIGN(auto&& prepared,
                     prepare(context, document, place, sight, exact, refined->flat_mesh));
  LayerSolver solver(
      context,
      PreparedLayer{std::move(refined->mesher), std::move(prepared.fields.color),
                    std::move(prepared.fields.opacity), prepared.frame, prepared.smallest_edges},
      exact, stats);
  Result<LayerResponse> response = no_throw([&]() -> Result<LayerResponse> {
    SFUMATO_TRY(solver.answer(refined->nodes));
    return take(context, place, solver);
  });
  refined->mesher = solver.release_mesher();
  refined->mesher.release_extracted();
  return response;
}

}  // namespace sfumato::solve
