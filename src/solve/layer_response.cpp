#include "solve/layer_response.hpp"

#include <algorithm>
#include <utility>

#include "base/charge.hpp"
#include "base/limit_error.hpp"
#include "base/no_throw.hpp"
#include "curves/flatten.hpp"
#include "curves/response.hpp"
#include "solve/layer_units.hpp"

namespace sfumato::solve {
namespace {

/// The layer on its visibility mesh, with the response as a channel of a field.
struct Prepared {
  PreparedFields fields;
  Box frame;
  double smallest_edge;
};

/// Per segment: 1 for those of the curve.
Result<std::vector<std::uint8_t>> segments_of(const Context& context,
                                              const curves::FlatCurves& flat, std::uint32_t curve,
                                              TableMemory& memory) {
  std::vector<std::uint8_t> marks;
  Status status = memory.resize(context, marks, flat.vertex.size());
  if (!status) return status;
  std::fill(marks.begin() + flat.curve_begin[curve], marks.begin() + flat.curve_begin[curve + 1],
            std::uint8_t{1});
  return marks;
}

/// Colour and opacity apart: one field has no room for a response beside both.
Result<SampledFields> sample(const Context& context, const curves::FlatCurves& flat,
                             const Document& document, const StopPlace& place,
                             const DiffuseOptions& options, double fine_radius) {
  const std::vector<Curve>& curves = document.layers[place.layer].curves;
  Result<SampledFields> sampled =
      sample_fields(context, {flat, curves, document.interpolation, false}, options, fine_radius);
  if (!sampled) return sampled;
  SampledField& field =
      place.attribute == StopAttribute::color ? sampled->color : *sampled->opacity;
  Status status = curves::add_response(context, flat, curves, place, field.attributes);
  if (!status) return status;
  return sampled;
}

Result<Prepared> prepare(Context& context, const Document& document, const StopPlace& place,
                         const LayerSight& sight, const DiffuseOptions& options) {
  const LayerUnits units(document.artboard, sight, options);
  const Result<curves::FlatCurves> flat =
      flatten_layer(context, document.layers[place.layer], sight, units);
  if (!flat) return flat.status();
  ScopedCharge charge;
  Status status = charge.add(context, curves::bytes_of(*flat), "flattening");
  if (!status) return status;
  Result<SampledFields> sampled =
      sample(context, *flat, document, place, options, units.smallest_radius());
  if (!sampled) return sampled.status();
  const mesh::MeshOptions meshing = units.mesh_options();
  Result<mesh::Mesher> mesher = mesh::Mesher::build(context, *flat, meshing);
  if (!mesher) return mesher.status();
  const Result<mesh::TriangleMesh> visibility = mesher->visibility_mesh(context);
  if (!visibility) return visibility.status();
  TableMemory memory("the response of a layer");
  const Result<std::vector<std::uint8_t>> answers =
      segments_of(context, *flat, place.curve, memory);
  if (!answers) return answers.status();
  const std::vector<Curve>& curves = document.layers[place.layer].curves;
  FieldEdits edits{.use = {*answers}};
  edits.is_parted = curves::opacity_goes_with_color(curves);
  Result<PreparedFields> fields =
      prepare_fields(context, *mesher, *visibility, std::move(*sampled), options.ends, edits);
  if (!fields) return fields.status();
  return Prepared{std::move(*fields), meshing.frame, units.smallest_edge()};
}

Status solve_first(Context& context, const Document& document, std::uint32_t layer,
                   const LayerSight& sight, const DiffuseOptions& options,
                   std::optional<RefinedLayer>& refined, DiffuseStats* stats) {
  Result<PreparedLayer> prepared =
      prepare_layer(context, document, layer, sight, options, stats, LayerUse::drags);
  if (!prepared) return prepared.status();
  const Result<PatchLayer> solved =
      LayerSolver(context, std::move(*prepared), options, stats).solve(&refined);
  if (!solved) return solved.status();
  if (refined) return ok_status();
  return make_limit_error("memory", "memory limit reached: a layer's nodes cannot be kept");
}

/// Takes the last base channel of the field apart.
Status split_factor(const Context& context, const curves::SegmentAttributes& attributes,
                    PatchField& field, LayerResponse& response) {
  Result<PatchField> split =
      split_channel(context, field, attributes.base_channels - 1, response.memory);
  if (!split) return split.status();
  response.memory.free(split->triangle_node);
  response.factor = std::move(split->node_value);
  return ok_status();
}

Result<LayerResponse> take(const Context& context, const StopPlace& place, LayerSolver& solver) {
  const bool is_color = place.attribute == StopAttribute::color;
  Result<PatchLayer> layer = solver.take();
  if (!layer) return layer.status();
  LayerResponse response{std::move(*layer), {}};
  const PreparedField& field = is_color ? solver.color() : *solver.opacity();
  Status status = split_factor(context, field.attributes,
                               is_color ? response.layer.color : response.layer.opacity, response);
  if (!status) return status;
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
  Status status;
  if (!refined) {
    status = solve_first(context, document, place.layer, sight, exact, refined, stats);
    if (!status) return status;
  }
  Result<Prepared> prepared = prepare(context, document, place, sight, exact);
  if (!prepared) return prepared.status();
  LayerSolver solver(
      context,
      PreparedLayer{std::move(refined->mesher), std::move(prepared->fields.color),
                    std::move(prepared->fields.opacity), prepared->frame, prepared->smallest_edge},
      exact, stats);
  Result<LayerResponse> response = no_throw([&]() -> Result<LayerResponse> {
    Status answered = solver.answer(refined->nodes);
    if (!answered) return answered;
    return take(context, place, solver);
  });
  refined->mesher = solver.release_mesher();
  refined->mesher.release_extracted();
  return response;
}

}  // namespace sfumato::solve
