#include "solve/layers/prepare_layer.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "base/boxes.hpp"
#include "base/largest_scale.hpp"
#include "base/parallel.hpp"
#include "base/poll.hpp"
#include "base/stopwatch.hpp"
#include "base/try.hpp"
#include "sfumato/base/limits.hpp"
#include "solve/fields/field_mesh.hpp"
#include "solve/layers/layer_units.hpp"
#include "solve/layers/pixel_cost.hpp"
#include "solve/layers/rough.hpp"

namespace sfumato::solve {
namespace {

/// Unites the view with views of about the same scale.
void add_view(const LayerView& view, std::vector<LayerView>& views) {
  const auto same = std::ranges::find(views, std::ilogb(view.scale),
                                      [](const LayerView& v) { return std::ilogb(v.scale); });
  if (same == views.end()) return views.push_back(view);
  same->window = united(same->window, view.window);
  same->scale = std::max(same->scale, view.scale);
}

/// The part of FieldEdits for one of the two fields.
struct OneEdit {
  const PreparedField* before;
  std::optional<PreparedField>* used;
  const curves::SegmentAttributes* beside;  ///< of the other field
};

Result<PreparedField> prepare_field(Context& context, const mesh::TriangleMesh& visibility,
                                    const FieldMesh& mesh, SampledField sampled, gather::Ends ends,
                                    const FieldEdits& edits, const OneEdit& edit) {
  gather::MeshChange change;
  if (edit.before && !edit.before->is_thinned && !mesh.is_thinned) {
    change = {&edit.before->gatherer, edits.is_same, nullptr, edits.whole};
    if (edit.used && edit.used->has_value()) change.used = &(*edit.used)->gatherer;
  }
  gather::GatherUse use = edits.use;
  if (edits.whole)
    use.is_watched = change.before ? use.is_watched : std::span<const std::uint8_t>();
  if (edits.is_parted) use.beside = edit.beside;
  SFUMATO_TRY_ASSIGN(auto&& gatherer,
                     gather::Gatherer::create(context, mesh.of(visibility), sampled.attributes,
                                              ends, use, change));
  return PreparedField{std::move(sampled.attributes), std::move(sampled.memory),
                       std::move(gatherer), mesh.is_thinned};
}

struct FieldMeshes {
  FieldMesh color;
  std::optional<FieldMesh> opacity;
};

Result<FieldMeshes> mesh_fields(const Context& context, const mesh::Mesher& mesher,
                                const mesh::TriangleMesh& visibility, const SampledFields& sampled,
                                const FieldEdits& edits) {
  SFUMATO_TRY_ASSIGN(auto&& color, mesh_field(context, mesher, visibility, sampled.color.attributes,
                                              edits.color_before, edits));
  FieldMeshes meshes{std::move(color), {}};
  if (!sampled.opacity) return meshes;
  SFUMATO_TRY_ASSIGN(auto&& opacity,
                     mesh_field(context, mesher, visibility, sampled.opacity->attributes,
                                edits.opacity_before, edits));
  meshes.opacity.emplace(std::move(opacity));
  return meshes;
}

Result<PreparedFields> prepare_meshed(Context& context, const mesh::TriangleMesh& visibility,
                                      const FieldMeshes& meshes, SampledFields sampled,
                                      gather::Ends ends, const FieldEdits& edits) {
  const curves::SegmentAttributes* const opacities =
      sampled.opacity ? &sampled.opacity->attributes : nullptr;
  SFUMATO_TRY_ASSIGN(
      auto&& color, prepare_field(context, visibility, meshes.color, std::move(sampled.color), ends,
                                  edits, {edits.color_before, edits.color_used, opacities}));
  PreparedFields fields{std::move(color), {}};
  if (!sampled.opacity) return fields;
  SFUMATO_TRY_ASSIGN(
      auto&& opacity,
      prepare_field(context, visibility, *meshes.opacity, std::move(*sampled.opacity), ends, edits,
                    {edits.opacity_before, edits.opacity_used, &fields.color.attributes}));
  fields.opacity.emplace(std::move(opacity));
  return fields;
}

/// Checks the visible region: the triangles' vertices are coordinates like any others.
Status check_sight(const LayerSight& sight, const Layer& layer) {
  const Box& seen = sight.viewport;
  const double reach = std::max({-seen.min.x, -seen.min.y, seen.max.x, seen.max.y});
  if (reach <= limits::kCoordinate) return ok_status();
  const std::string name = layer.id.empty() ? "a layer" : "layer \"" + layer.id + '"';
  return make_error(StatusCode::limit,
                    "the picture shows coordinates of " + name + " beyond the limit of " +
                        std::to_string(static_cast<std::int64_t>(limits::kCoordinate)) +
                        ": a transform or the viewport reaches too far");
}

void add_instance(const LayerInstance& instance, const Box& viewport, LayerSight& sight) {
  const Affine& map = instance.artboard_from_layer;
  const LayerView view{mapped_box(inverse(map), viewport), largest_scale(map)};
  sight.viewport = united(sight.viewport, view.window);
  sight.instance_count += !view.window.empty();
  if (!(view.scale > 0)) return;
  sight.scale = sight.views.empty() ? view.scale : std::max(sight.scale, view.scale);
  add_view(view, sight.views);
}

}  // namespace

Status validate(const DiffuseOptions& options) {
  const auto wrong = [](const char* what) { return make_error(StatusCode::bad_input, what); };
  const auto positive = [](double x) { return std::isfinite(x) && x > 0; };
  if (!positive(options.pixels_per_unit)) return wrong("pixels per unit must be above 0");
  if (options.tolerance && !positive(*options.tolerance)) {
    return wrong("the flattening tolerance must be above 0");
  }
  if (!(options.min_angle_deg >= 0 && options.min_angle_deg <= 33)) {
    return wrong("the minimum angle must be from 0 to 33 degrees");
  }
  if (!(options.max_area_fraction > 0 && options.max_area_fraction <= 1)) {
    return wrong("the maximum area must be above 0 and at most 1 (100%) of the artboard");
  }
  if (!(std::isfinite(options.max_error) && options.max_error >= 0)) {
    return wrong("the maximum error must be 0 (off) or more code values");
  }
  if (options.order > PatchOrder::cubic) return wrong("an unknown order of patches");
  if (options.gather.method > gather::Method::rays) return wrong("an unknown method to gather by");
  if (options.ends > gather::Ends::paper) return wrong("ends must be soft or paper");
  if (options.gather.rays_per_node < 1 || options.gather.rays_per_node > limits::kRays) {
    return wrong("the number of rays must be from 1 to 4096");
  }
  if (options.viewport) {
    const Box& box = *options.viewport;
    if (!is_finite(box.min) || !is_finite(box.max) || !(box.width() > 0 && box.height() > 0)) {
      return wrong("the viewport must have a width and a height above 0");
    }
  }
  return ok_status();
}

LayerSight sight_of_layer(const Document& document, std::uint32_t layer, const Box& viewport) {
  LayerSight sight;
  for (const StackItem& item : document.stack) {
    const auto* instance = std::get_if<LayerInstance>(&item);
    if (instance && instance->layer == layer) add_instance(*instance, viewport, sight);
  }
  return sight;
}

Result<std::vector<LayerSight>> sights_of_layers(const Context& context, const Document& document,
                                                 const Box& viewport) {
  std::vector<LayerSight> sights;
  TableMemory memory("layers");
  SFUMATO_TRY(memory.resize(context, sights, document.layers.size()));
  RarePoll<1024> poll(context);
  for (const StackItem& item : document.stack) {
    if (poll.cancelled()) return context.cancel_status();
    const auto* instance = std::get_if<LayerInstance>(&item);
    if (instance) add_instance(*instance, viewport, sights[instance->layer]);
  }
  return sights;
}

Result<curves::FlatCurves> flatten_layer(Context& context, const Layer& layer,
                                         const LayerSight& sight, const LayerUnits& units) {
  SFUMATO_TRY(check_sight(sight, layer));
  return curves::flatten(context, layer.curves, units.flatten_options());
}

Result<SampledFields> sample_fields(const Context& context, const FlatLayer& layer,
                                    const DiffuseOptions& options,
                                    std::optional<double> fine_radius) {
  const auto drop_blur = [&](curves::SegmentAttributes& attributes) {
    if (options.ignore_blur) curves::remove_blur(attributes);
    if (fine_radius) curves::set_fine_blur(attributes, *fine_radius);
  };
  const auto sample = layer.is_joint ? curves::sample_colors_and_opacities : curves::sample_colors;
  TableMemory memory("attributes");
  SFUMATO_TRY_ASSIGN(auto&& colors,
                     sample(context, layer.flat, layer.curves, layer.interpolation, memory));
  drop_blur(colors);
  SampledFields fields{{std::move(colors), std::move(memory)}, {}};
  const bool has_opacity =
      layer.has_opacity || std::ranges::any_of(layer.curves, curves::bears_opacity);
  if (layer.is_joint || !has_opacity) return fields;
  TableMemory opacity_memory("attributes");
  SFUMATO_TRY_ASSIGN(auto&& opacities,
                     curves::sample_opacities(context, layer.flat, layer.curves, opacity_memory));
  drop_blur(opacities);
  fields.opacity.emplace(SampledField{std::move(opacities), std::move(opacity_memory)});
  return fields;
}

Result<PreparedFields> prepare_fields(Context& context, const mesh::Mesher& mesher,
                                      const mesh::TriangleMesh& visibility, SampledFields sampled,
                                      gather::Ends ends, const FieldEdits& edits) {
  SFUMATO_TRY_ASSIGN(const FieldMeshes& meshes,
                     mesh_fields(context, mesher, visibility, sampled, edits));
  return prepare_meshed(context, visibility, meshes, std::move(sampled), ends, edits);
}

namespace {

/// Returns a copy of the mesher if curves of the layer will be dragged.
Result<std::optional<mesh::Mesher>> kept_mesher(Context& context, const mesh::Mesher& mesher,
                                                LayerUse use) {
  std::optional<mesh::Mesher> kept;
  if (use != LayerUse::drags) return kept;
  SFUMATO_TRY_ASSIGN(auto&& copy, mesher.copy(context));
  kept.emplace(std::move(copy));
  return kept;
}

/// The seconds that the parts of a preparation took.
struct Seconds {
  double geometry, mesh, gather;
};

void add_to(DiffuseStats* stats, const curves::FlatCurves& flat, std::size_t curve_count,
            const Seconds& seconds) {
  if (!stats) return;
  stats->curves += curve_count;
  stats->segments += flat.segment_count();
  stats->geometry_seconds += seconds.geometry;
  stats->triangulation_seconds += seconds.mesh;
  stats->gather_seconds += seconds.gather;
}

}  // namespace

Result<PreparedLayer> prepare_layer(Context& context, const Document& document, std::uint32_t layer,
                                    const LayerSight& sight, const DiffuseOptions& options,
                                    DiffuseStats* stats, LayerUse use, bool side_by_side) {
  const Stopwatch geometry_watch;
  const std::vector<Curve>& curves = document.layers[layer].curves;
  const LayerUnits units(document.artboard, sight, options);
  SFUMATO_TRY_ASSIGN(auto&& flat, flatten_layer(context, document.layers[layer], sight, units));
  ScopedCharge flat_charge;
  SFUMATO_TRY(flat_charge.add(context, curves::bytes_of(flat), "flattening"));
  const bool for_patches = use != LayerUse::points;
  const FlatLayer flat_layer{flat, curves, document.interpolation,
                             for_patches && curves::opacity_goes_with_color(curves)};
  std::optional<double> smallest_radius;
  if (for_patches) smallest_radius = units.smallest_radius();
  SFUMATO_TRY_ASSIGN(auto&& sampled, sample_fields(context, flat_layer, options, smallest_radius));
  const bool is_exact =
      options.exact_pixels ||
      (use == LayerUse::patches && may_gather_pixels(options) && sight.instance_count == 1 &&
       has_plain_colors(sampled) && pixels_cost_less(flat, sight.viewport, units.pixel()));
  const double geometry_seconds = geometry_watch.seconds();

  const Stopwatch mesh_watch;
  SFUMATO_TRY_ASSIGN(auto&& mesher, mesh::Mesher::build(context, flat, units.mesh_options()));
  SFUMATO_TRY_ASSIGN(auto&& copy, kept_mesher(context, mesher, use));
  std::optional<mesh::Mesher>& kept = copy;
  SFUMATO_TRY_ASSIGN(auto&& visibility, (kept ? *kept : mesher).visibility_mesh(context));
  const double mesh_seconds = mesh_watch.seconds();

  const Stopwatch gather_watch;
  SFUMATO_TRY_ASSIGN(const FieldMeshes& meshes,
                     mesh_fields(context, mesher, visibility, sampled, {}));
  std::optional<PreparedFields> fields;
  const auto prepare = [&] {
    Result<PreparedFields> prepared =
        prepare_meshed(context, visibility, meshes, std::move(sampled), options.ends,
                       {.use = {.may_be_changed = kept.has_value(),
                                .negligible = is_for_pixel_grid(options) ? gather::kGridNegligible
                                                                         : gather::kNegligible}});
    if (prepared) fields.emplace(std::move(*prepared));
    return prepared.status();
  };
  const bool refines = for_patches && side_by_side && !is_exact;
  SFUMATO_TRY(refines ? run_both(context, prepare, [&] { return mesher.refine(context); })
                      : prepare());
  add_to(stats, flat, curves.size(), {geometry_seconds, mesh_seconds, gather_watch.seconds()});
  PreparedLayer prepared{std::move(mesher),
                         std::move(fields->color),
                         std::move(fields->opacity),
                         units.mesh_options().frame,
                         units.smallest_edges(),
                         refines,
                         is_exact};
  if (kept) {
    prepared.flat_mesh.emplace(
        FlatMesh{std::move(flat), std::move(flat_charge), std::move(*kept), std::move(visibility)});
  } else if (!flat.bow.empty()) {
    prepared.bowed.emplace(ChargedCurves{std::move(flat), std::move(flat_charge)});
  }
  return prepared;
}

}  // namespace sfumato::solve
