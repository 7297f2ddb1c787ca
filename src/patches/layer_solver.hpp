#pragma once

#include <cstdint>
#include <vector>

#include "base/context.hpp"
#include "base/status.hpp"
#include "patches/diffuse.hpp"
#include "patches/layer_scene.hpp"
#include "patches/nodes.hpp"
#include "patches/picture.hpp"

namespace sfumato::patches {

/// Solves one layer: patch mesh, node values, error-driven refinement.
///
/// A round lays out the nodes of the present mesh, keeps the values of triangles that did not
/// change, gathers the rest, and compares the new patches with the exact gather at probe points;
/// triangles that miss by more than `max_error` are made smaller for the next round.
class LayerSolver {
 public:
  LayerSolver(Context& context, LayerScene scene, const DiffuseOptions& options,
              DiffuseStats* stats)
      : context_(context), scene_(std::move(scene)), options_(options), stats_(stats) {}

  Result<PatchLayer> solve();

 private:
  Status next_mesh();
  Status gather_free_nodes(const gather::GatherOptions& options, bool all);
  Status find_misses(std::vector<std::uint32_t>& missed);
  void drop_unseen_triangles();
  void color_unseen_nodes();
  PatchLayer take_patches();

  Context& context_;
  LayerScene scene_;
  const DiffuseOptions& options_;
  DiffuseStats* stats_;
  mesh::TriangleMesh mesh_;
  NodeLayout layout_;
  std::vector<std::uint8_t> node_known_;         ///< value gathered in an earlier round
  std::vector<std::uint8_t> node_hit_;           ///< 0 where a free node sees no curve
  std::vector<std::int32_t> previous_triangle_;  ///< as Mesher::patch_mesh gives it
};

}  // namespace sfumato::patches
