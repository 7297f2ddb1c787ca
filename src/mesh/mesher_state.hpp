#pragma once

#include <cmath>
#include <limits>
#include <string_view>
#include <vector>

#include "base/table_memory.hpp"
#include "mesh/chords.hpp"
#include "mesh/extract.hpp"
#include "mesh/lattice.hpp"
#include "mesh/mesher.hpp"
#include "mesh/numbering.hpp"
#include "mesh/refiner.hpp"
#include "mesh/triangulation.hpp"

namespace sfumato::mesh {

struct Mesher::State {
  explicit State(Budget& account)
      : budget(account),
        refiner(mesh, chords, account),
        numbering{{}, {}, 0, 0, {kPurpose, account}},
        memory(kPurpose, account),
        extracted(kPurpose, account),
        drawn_memory(kPurpose, account) {}

  static constexpr std::string_view kPurpose = "the triangle mesh";

  Budget& budget;
  MeshOptions options;
  Lattice lattice;
  Triangulation mesh;
  ChordStore chords;
  Refiner refiner;
  Numbering numbering;                   ///< for the patch mesh, as it was made or updated last
  std::vector<Refiner::Target> patched;  ///< per triangle of the patch mesh: slot and stamp
  TableMemory memory;                    ///< for `patched`, and for lists of changes
  TableMemory extracted;                 ///< for the mesh that was returned last
  std::vector<Point> drawn;              ///< after an edit: per vertex of the polylines
  TableMemory drawn_memory;
  bool has_cut_chords = false;     ///< refinement may have cut edges, so that chords are not edges
  std::uint32_t change_count = 0;  ///< number of refinements and edits
  const State* copied_from = nullptr;      ///< last source of a copy; never dereferenced
  std::uint32_t change_count_of_copy = 0;  ///< the change_count of that source

  /// Sets the refiner's options from lattice and mesh options.
  void set_quality() {
    const double step = lattice.step;
    refiner.set_quality(options.min_angle_deg,
                        options.max_area > 0 ? 2 * options.max_area / (step * step)
                                             : std::numeric_limits<double>::infinity(),
                        std::sqrt(static_cast<double>(lattice.weld_squared)),
                        options.small_edge / step);
  }

  /// Forgets the numbers: the patch mesh must be extracted again.
  void forget_numbers() { numbering = Numbering{{}, {}, 0, 0, {kPurpose, budget}}; }

  /// Returns the mesh with these numbers; the charge of the last mesh ends.
  Result<TriangleMesh> extract_anew(const Context& context, const Numbering& numbers) {
    extracted = TableMemory(kPurpose, budget);
    return extract(context, {mesh, chords, refiner.origins(), lattice, numbers}, extracted);
  }
};

}  // namespace sfumato::mesh
