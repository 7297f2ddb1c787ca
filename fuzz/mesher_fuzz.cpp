// Segment sets to meshes: the exact checker finds the mesh valid after every step, and its
// constraints cover their source segments.
#include <algorithm>
#include <cmath>
#include <vector>

#include "fuzz.hpp"
#include "mesh/arrangement_check.hpp"
#include "mesh/is_valid.hpp"
#include "mesh/lattice.hpp"
#include "mesh/mesher.hpp"

using namespace sfumato;

namespace {

constexpr double kSide = 64;
/// A larger run would take too long, and show nothing that a smaller one does not.
constexpr std::uint32_t kManyTriangles = 20'000;
/// Reserved while a mesh is refined, so that a mesh at a limit can still be extracted and checked.
constexpr std::size_t kRoomOfPatchMesh = fuzz::kBudgetBytes;

/// Reads points from bytes: on a grid, near or between earlier points, on the frame, far away.
class DrawingReader {
 public:
  explicit DrawingReader(fuzz::Bytes bytes) : reader_(bytes) {}

  mesh::MeshOptions options() {
    mesh::MeshOptions options;
    options.frame = {{0, 0}, {kSide, kSide}};
    if (reader_.below(4) == 0) options.frame.max.y = 1 + reader_.below(64);
    options.unit_size = std::ldexp(1.0, static_cast<int>(reader_.below(4)) - 4);
    constexpr double kAngles[] = {22, 0, 30, 33};
    const unsigned quality = reader_.below(8);
    options.min_angle_deg = kAngles[quality % 4];
    if (quality >= 4) options.small_edge = 2;
    constexpr double kAreas[] = {0, 200, 50, 1000};
    options.max_area = kAreas[reader_.below(4)];
    return options;
  }

  curves::FlatCurves curves() {
    flat_.curve_begin.push_back(0);
    while (!reader_.at_end()) add_curve();
    return std::move(flat_);
  }

  fuzz::ByteReader& reader() { return reader_; }

 private:
  Vec2 known_point() {
    if (flat_.vertex.empty()) return {kSide / 2, kSide / 2};
    return flat_.vertex[reader_.below(256) % flat_.vertex.size()];
  }

  double grid() { return kSide * (static_cast<int>(reader_.byte()) - 32) / 192; }
  /// Returns a number from 2^-40 to 2^7, of either sign.
  double small() {
    const unsigned code = reader_.byte();
    return std::ldexp(code & 1 ? 1.0 : -1.0, static_cast<int>((code >> 1) % 48) - 40);
  }

  Vec2 point() {
    switch (reader_.below(8)) {
      case 0:
        return known_point();
      case 1: {
        const Vec2 near = known_point();
        return {near.x + small(), near.y + small()};
      }
      case 2: {
        // Nearly on the line through two other points.
        const Vec2 a = known_point(), b = known_point();
        const double t = grid() / kSide * 1.5;
        const Vec2 on = lerp(a, b, t);
        return reader_.below(2) == 0 ? on : Vec2{on.x + small(), on.y};
      }
      case 3:
        return {reader_.below(2) * kSide, grid()};
      case 4: {
        const double x = grid() * 1000, y = grid() * 1000;
        return {x, y};
      }
      default: {
        const double x = grid(), y = grid();
        return {x, y};
      }
    }
  }

  void add_curve() {
    const unsigned count = 1 + reader_.below(6);
    const auto curve = static_cast<std::uint32_t>(flat_.curve_begin.size() - 1);
    double arc = 0;
    Vec2 last;
    for (unsigned i = 0; i <= count; ++i) {
      const Vec2 p = point();
      if (i > 0) arc += length(p - last);
      last = p;
      flat_.vertex.push_back(p);
      flat_.parameter.push_back(i);
      flat_.arc_length.push_back(arc);
      flat_.vertex_curve.push_back(curve);
    }
    flat_.curve_begin.push_back(static_cast<std::uint32_t>(flat_.vertex.size()));
  }

  fuzz::ByteReader reader_;
  curves::FlatCurves flat_;
};

void check_thinned(Context& context, const mesh::Mesher& mesher, const mesh::TriangleMesh& whole) {
  std::vector<std::uint8_t> keep(whole.constraint.size());
  for (std::size_t c = 0; c < keep.size(); ++c) {
    keep[c] = c % 3 != 0 && !whole.pieces(whole.constraint[c]).empty();
  }
  TableMemory memory("a test");
  const Result<mesh::TriangleMesh> thinned = mesher.thinned_mesh(context, whole, keep, memory);
  fuzz::require_ok(thinned.status(), "a mesh cannot be thinned");
  fuzz::require_ok(is_valid(*thinned), "the thinned mesh is not valid");
}

/// Runs `step` without the memory that extracting its result will need.
template <class Step>
Status refine_by(Context& context, Step step) {
  fuzz::require_ok(context.budget.charge(kRoomOfPatchMesh, "a patch mesh"), "room to extract");
  Status status = step();
  context.budget.release(kRoomOfPatchMesh);
  return status;
}

/// Returns the patch mesh, which must be valid.
mesh::TriangleMesh patch_mesh(Context& context, mesh::Mesher& mesher, std::string_view name) {
  Result<mesh::TriangleMesh> patch = mesher.patch_mesh(context);
  fuzz::require_ok(patch.status(), name);
  fuzz::require_ok(is_valid(*patch), name);
  return std::move(*patch);
}

/// Refines every third triangle. A limit may stop that; the mesh stays valid.
void check_refinement(Context& context, mesh::Mesher& mesher, double smallest_edge) {
  const Status refined = refine_by(context, [&] { return mesher.refine(context); });
  const mesh::TriangleMesh patch = patch_mesh(context, mesher, "the patch mesh");
  if (!refined) return fuzz::require_honest(refined);
  if (patch.triangle_count() > kManyTriangles) return;
  std::vector<std::uint32_t> every_third;
  for (std::uint32_t t = 0; t < patch.triangle_count(); t += 3) every_third.push_back(t);
  const Status finer = refine_by(
      context, [&] { return mesher.refine_triangles(context, every_third, smallest_edge); });
  if (!finer) fuzz::require_honest(finer);
  patch_mesh(context, mesher, "the finer patch mesh");
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  DrawingReader drawing({data, size});
  const mesh::MeshOptions options = drawing.options();
  const curves::FlatCurves flat = drawing.curves();
  Context context{.budget = Budget(fuzz::kBudgetBytes + kRoomOfPatchMesh)};
  {
    Result<mesh::Mesher> mesher = mesh::Mesher::build(context, flat, options);
    if (!mesher) {
      fuzz::require_honest(mesher.status());
      return 0;
    }
    const Result<mesh::TriangleMesh> extracted = mesher->visibility_mesh(context);
    fuzz::require_ok(extracted.status(), "the visibility mesh");
    const mesh::TriangleMesh& whole = *extracted;
    fuzz::require_ok(is_valid(whole), "the visibility mesh is not valid");
    const double weld =
        std::max(options.weld_px * options.unit_size, mesh::kLeastWeldSteps * whole.lattice_step);
    const mesh::test::ArrangementFacts facts = mesh::test::check_arrangement(whole, flat, weld);
    fuzz::require(facts.broken.empty(), facts.broken);
    check_thinned(context, *mesher, whole);
    check_refinement(context, *mesher, options.unit_size);
  }
  fuzz::require(context.budget.used() == 0, "a mesher keeps what it charged");
  return 0;
}
