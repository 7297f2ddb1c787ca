#pragma once

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "curves/attributes.hpp"
#include "curves/flatten.hpp"
#include "gather/scene/scene.hpp"
#include "mesh/mesher.hpp"
#include "sfumato/document/document.hpp"
#include "solve/fields/nodes.hpp"

namespace sfumato::bench {

/// A drawing of one layer with its mesh, and the free nodes of the paper's mesh (no error-driven
/// refinement).
struct Prepared {
  Context context;  // charged with the other members
  mesh::TriangleMesh visibility;
  curves::SegmentAttributes attributes;
  std::vector<Vec2> points;
  gather::Scene scene;
};

inline solve::NodeLayout lay_out(const mesh::TriangleMesh& mesh,
                                 const curves::SegmentAttributes& attributes) {
  const Context context;
  const Result<solve::Seams> seams = solve::Seams::create(context, mesh, attributes);
  TableMemory memory("a benchmark");
  return *solve::lay_out_nodes(context, mesh, attributes, *seams, memory);
}

inline std::unique_ptr<Prepared> prepare(const Document& document) {
  auto prepared = std::make_unique<Prepared>();
  Context& context = prepared->context;
  const std::vector<Curve>& curves = document.layers[0].curves;
  const double side = std::max(document.artboard.width(), document.artboard.height());
  const double tolerance = side * 0.1 / 512;
  Result<curves::FlatCurves> flat = curves::flatten(context, curves, {.tolerance = tolerance});
  mesh::MeshOptions options;
  options.frame = document.artboard;
  options.unit_size = side / 1024;
  options.max_area = 0.04 * document.artboard.width() * document.artboard.height();
  Result<mesh::Mesher> mesher = mesh::Mesher::build(context, *flat, options);
  TableMemory memory("a benchmark");
  prepared->attributes =
      *curves::sample_colors(context, *flat, curves, InterpolationSpace::srgb, memory);
  prepared->visibility = *mesher->visibility_mesh({});
  if (!mesher->refine(context)) return nullptr;
  const solve::NodeLayout layout = lay_out(*mesher->patch_mesh({}), prepared->attributes);
  for (std::uint32_t i = 0; i < layout.node_count(); ++i) {
    if (!layout.is_fixed[i]) prepared->points.push_back(layout.position[i]);
  }
  Result<gather::Scene> scene =
      gather::build_scene(context, prepared->visibility, prepared->attributes);
  prepared->scene = std::move(*scene);
  return prepared;
}

}  // namespace sfumato::bench
