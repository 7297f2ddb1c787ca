#include "trace/curves/crossings.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "base/poll.hpp"
#include "base/try.hpp"
#include "gather/ends/meetings.hpp"
#include "trace/curves/curve_mesh.hpp"
#include "trace/curves/drawing.hpp"

namespace sfumato::tracing {
namespace {

/// Colours that face each other and differ less fit; the last fit, to all pixels, brings no more
/// between them than `lint` allows.
constexpr float kClash = 36 / 255.f;

class CrossingFinder {
 public:
  CrossingFinder(Context& context, std::span<const TracedCurve> curves, const MeshedCurves& meshed,
                 const curves::SegmentAttributes& colors)
      : context_(context), curves_(curves), meshed_(meshed), colors_(colors) {}

  Result<Crossings> run() {
    TableMemory memory("crossings of curves");
    std::vector<gather::Meeting> meetings;
    SFUMATO_TRY(gather::find_meetings(context_, meshed_.mesh, memory, meetings));
    RarePoll<4096> poll(context_);
    for (const gather::Meeting& meeting : meetings) {
      if (poll.cancelled()) return context_.cancel_status();
      const std::optional<gather::Cross> cross = gather::cross_at(meshed_.mesh, colors_, meeting);
      if (!cross) continue;
      if (cross->is_of_one_curve()) add_self(*cross);
      if (cross->is_of_two_curves() && gather::clashes(meshed_.mesh, colors_, *cross, kClash)) {
        add_clash(*cross);
      }
    }
    return std::move(out_);
  }

 private:
  /// At a crossing opposite strands are one passage, and neighbours are two.
  void add_self(const gather::Cross& cross) {
    const std::uint32_t curve = cross.strand[0].curve;
    const auto [first, second] =
        std::minmax({parameter_of(cross.strand[0]), parameter_of(cross.strand[1])});
    const auto [third, fourth] =
        std::minmax({parameter_of(cross.strand[2]), parameter_of(cross.strand[3])});
    if (is_same(curve, first, second) || !is_same(curve, first, third)) return;
    if (is_same(curve, second, fourth)) out_.self.push_back({curve, first, second});
  }

  void add_clash(const gather::Cross& cross) {
    out_.clash.push_back({{cross.strand[0].curve, cross.strand[1].curve},
                          {parameter_of(cross.strand[0]), parameter_of(cross.strand[1])}});
  }

  bool is_same(std::uint32_t curve, double a, double b) const {
    const double whole = static_cast<double>((curves_[curve].control_points.size() - 1) / 3);
    const double way = std::fabs(a - b);
    constexpr double kSame = 1e-3;
    return std::min(way, whole - way) < kSame;
  }

  /// Where the strand's curve passes the vertex.
  double parameter_of(const gather::Cross::Strand& strand) const {
    const mesh::TriangleMesh& mesh = meshed_.mesh;
    const auto index = static_cast<std::size_t>(mesh.half_edge_constraint[strand.half_edge]);
    const mesh::Constraint& edge = mesh.constraint[index];
    const mesh::SegmentPiece& piece = mesh.pieces(edge).back();
    const double u = edge.from == mesh.origin(strand.half_edge) ? piece.u_from : piece.u_to;
    const std::vector<double>& parameter = meshed_.flat.parameter;
    return std::lerp(parameter[piece.segment], parameter[std::size_t{piece.segment} + 1], u);
  }

  Context& context_;
  std::span<const TracedCurve> curves_;
  const MeshedCurves& meshed_;
  const curves::SegmentAttributes& colors_;
  Crossings out_;
};

}  // namespace

Result<Crossings> find_crossings(Context& context, std::span<const TracedCurve> curves, int width,
                                 int height) {
  const std::vector<Curve> drawn = document_curves(curves, {1, 1}, false);
  SFUMATO_TRY_ASSIGN(const MeshedCurves& meshed, mesh_curves(context, drawn, width, height));
  TableMemory memory("crossings of curves");
  SFUMATO_TRY_ASSIGN(
      const curves::SegmentAttributes& colors,
      curves::sample_colors(context, meshed.flat, drawn, InterpolationSpace::srgb, memory));
  return CrossingFinder(context, curves, meshed, colors).run();
}

}  // namespace sfumato::tracing
