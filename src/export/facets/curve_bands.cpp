#include "export/facets/curve_bands.hpp"

#include <algorithm>
#include <cmath>

#include "base/try.hpp"
#include "export/facets/facet_patch.hpp"

namespace sfumato::outputs {
namespace {

constexpr double kLeastDifference = 2.0 / 255;
/// The largest share of the distance to a vertex on another curve that a band takes, so that the
/// bands of two curves hardly meet.
constexpr double kMostOfHeight = 0.6;
/// The width of the layer under a band, as a share of the band's width. Splash rounds a mesh's
/// vertices to pixels and paints everything between them, both ends included: up to two pixels
/// more, which the band must cover.
constexpr double kUnderShare = 2.0 / 7;
/// Bands narrower than this share of their width would show the layer under them elsewhere too.
constexpr double kLeastShare = 6.0 / 7;
/// The same for the triangle at the curve if the band continues in the triangles behind it.
constexpr double kLeastShareBefore = 3.0 / 7;
/// How far a band reaches around a curve's vertex, as a share of its width: it must cover the layer
/// under it.
constexpr double kCornerShare = 2;
constexpr int kMostColumns = 8;
/// The error allowed along a column; it shows in pixels that a curve cuts.
constexpr double kColumnError = 1.5 / 255;

/// The most triangles visited around a vertex. No vertex has so many, but a picture that is not a
/// mesh could loop for ever.
constexpr int kMostTurns = 1000;
/// Vertices, and facets, that an edge or a vertex adds to a mesh at most: three strips, and corners
/// around a vertex.
constexpr std::size_t kMostAdded = 3 * (2 * kMostColumns + 2) + 3 * kMostTurns;
/// A new vertex is searched for among this many earlier vertices.
constexpr std::size_t kLastVertices = 8;
/// Less than a step of the written numbers.
constexpr double kSameValue = 0.2 / 255;

using Value = FacetPatch::Value;

Barycentric along(std::uint32_t half_edge, double t, double inwards) {
  const std::uint32_t k = half_edge % 3;
  Barycentric at{};
  at[k] = (1 - t) * (1 - inwards);
  at[(k + 1) % 3] = t * (1 - inwards);
  at[(k + 2) % 3] = inwards;
  return at;
}

class BandBuilder {
 public:
  BandBuilder(const PatchLayer& layer, InterpolationSpace space, const FacetSource& source,
              const CurveEdges& edges, double width, CurveBands* bands)
      : layer_(layer), space_(space), source_(source), edges_(edges), width_(width), bands_(bands) {
    bands->under.channel_count = bands->over.channel_count = channel_count_of(source);
  }

  /// Paints the parts beyond curves before the bands of other curves, and over the ground of
  /// others.
  Status build(Context& context) {
    const std::size_t vertices = layer_.vertex_position.size();
    SFUMATO_TRY(memory_.resize_all(context, vertices, is_on_curve_, is_done_));
    SFUMATO_TRY(memory_.resize(context, is_whole_, layer_.triangle_count()));
    for (std::uint32_t side : edges_.side)
      for (std::uint32_t h : {side, next_half_edge(side)})
        is_on_curve_[layer_.triangle_vertex[h]] = 1;
    for (Part part : {Part::ground, Part::beyond, Part::band}) {
      std::ranges::fill(is_done_, std::uint8_t{0});
      std::ranges::fill(is_whole_, std::uint8_t{0});
      for (std::uint32_t side : edges_.side) {
        if (context.cancelled()) return context.cancel_status();
        SFUMATO_TRY(make_room(context));
        paint(side, part);
      }
      SFUMATO_TRY(paint_rest(context, band_of(part)));
    }
    return ok_status();
  }

 private:
  enum class Part { ground, beyond, band };

  /// Facets, and the path around them; null where nobody needs it.
  struct Band {
    FacetMesh* mesh;
    std::vector<std::array<Vec2, 4>>* clip;
  };
  /// A vertex behind low triangles, and how far from the curve.
  struct Reached {
    std::uint32_t leaving;  ///< a half-edge from the vertex
    double depth;
  };

  Band band_of(Part part) {
    return part == Part::band ? Band{&bands_->over, &bands_->clip} : Band{&bands_->under, nullptr};
  }
  FacetPatch patch(std::uint32_t half_edge) const {
    return {layer_, space_, source_, half_edge / 3, kColumnError};
  }
  Vec2 position(std::uint32_t half_edge) const {
    return layer_.vertex_position[layer_.triangle_vertex[half_edge]];
  }
  Status make_room(Context& context);
  bool is_mask() const { return !reads_color(source_); }
  bool is_seen(std::uint32_t half_edge) const;
  double height(std::uint32_t half_edge) const;
  double most_towards(std::uint32_t leaving) const;
  double inwards(std::uint32_t half_edge, double width) const;
  void paint(std::uint32_t side, Part part);
  void carry(std::uint32_t from, std::uint32_t into, double width, FacetMesh* mesh);
  void carry_strip(std::uint32_t from, std::uint32_t into, double width, FacetMesh* mesh);
  void carry_under(std::uint32_t from, std::uint32_t into);
  void carry_outside(std::uint32_t from, FacetMesh* mesh);
  void carry_nothing(std::uint32_t into);
  void paint_nothing(std::uint32_t beside);
  void paint_strip(std::uint32_t side, double width, FacetMesh* mesh);
  void paint_corner(std::uint32_t leaving, double width, Band* band);
  void paint_band(std::uint32_t side, Band band);
  void reach_vertex(std::uint32_t leaving, double depth);
  Status paint_rest(Context& context, Band band);
  void paint_end(std::uint32_t side, Part part);
  int columns(std::uint32_t half_edge) const;
  std::uint32_t add(Vec2 at, const Value& value, FacetMesh* mesh) const;
  template <class Corner>
  void add_columns(int count, FacetMesh* mesh, const Corner& corner) const;
  template <class Visit>
  void for_each_between(std::uint32_t side, const Visit& visit) const;
  double reach(std::uint32_t leaving, std::uint32_t corner, double width) const;
  void carry_corner(std::uint32_t leaving, double width, const Value& value, FacetMesh* mesh);
  Vec2 inner(std::uint32_t half_edge, double t, double share) const;
  Vec2 outer(std::uint32_t half_edge, double t, double distance) const;

  const PatchLayer& layer_;
  InterpolationSpace space_;
  const FacetSource& source_;
  const CurveEdges& edges_;
  double width_;
  CurveBands* bands_;
  TableMemory memory_{"bands along curves"};
  std::vector<std::uint8_t> is_on_curve_;  ///< per vertex
  std::vector<std::uint8_t> is_done_;      ///< per vertex: a band continues around it
  std::vector<std::uint8_t> is_whole_;     ///< per triangle: a band holds all of it
  std::vector<Reached> reached_;
};

/// The work for one edge, or for the area around one vertex.
Status BandBuilder::make_room(Context& context) {
  Status status = bands_->under.make_room(context, kMostAdded, kMostAdded);
  if (status) status = bands_->over.make_room(context, kMostAdded, kMostAdded);
  if (status) status = bands_->memory.make_room(context, bands_->clip, kMostTurns + 1);
  return status ? memory_.make_room(context, reached_, 2 * kMostTurns + 1) : status;
}

/// Returns whether a side has opacity at the middle of an edge or its ends.
bool BandBuilder::is_seen(std::uint32_t half_edge) const {
  if (half_edge == kNoHalfEdge) return false;
  if (layer_.opacity.channel_count == 0) return true;
  if (!layer_.opacity.shader.empty()) return true;
  const FacetPatch opacity(layer_, space_, {FacetSource::Kind::opacity, 0, {}}, half_edge / 3,
                           kColumnError);
  double most = 0;
  for (double t : {0.0, 0.5, 1.0}) most = std::max(most, opacity.shown(along(half_edge, t, 0))[0]);
  return most > kLeastDifference;
}

/// Geometry of a triangle over one of its edges.
double BandBuilder::height(std::uint32_t half_edge) const {
  const Vec2 a = position(half_edge), b = position(next_half_edge(half_edge));
  return cross(b - a, position(previous_half_edge(half_edge)) - a) / length(b - a);
}

/// How much of the way to a vertex bands may take.
double BandBuilder::most_towards(std::uint32_t leaving) const {
  return is_on_curve_[layer_.triangle_vertex[leaving]] ? kMostOfHeight : 1;
}

/// Returns the share of a triangle's height that a width is.
double BandBuilder::inwards(std::uint32_t half_edge, double width) const {
  return std::min(most_towards(previous_half_edge(half_edge)), width / height(half_edge));
}

Vec2 BandBuilder::inner(std::uint32_t half_edge, double t, double share) const {
  const Vec2 on_edge = lerp(position(half_edge), position(next_half_edge(half_edge)), t);
  return lerp(on_edge, position(previous_half_edge(half_edge)), share);
}

Vec2 BandBuilder::outer(std::uint32_t half_edge, double t, double distance) const {
  const Vec2 a = position(half_edge), b = position(next_half_edge(half_edge));
  return lerp(a, b, t) + left_of(b - a) * (distance / length(b - a));
}

/// A vertex, or one of the last few where it is the same: facets beside each other become strips.
std::uint32_t BandBuilder::add(Vec2 at, const Value& value, FacetMesh* mesh) const {
  const auto channels = static_cast<std::size_t>(mesh->channel_count);
  const std::size_t count = mesh->vertex_position.size();
  const auto is_same = [&](std::size_t vertex) {
    for (std::size_t c = 0; c < channels; ++c)
      if (std::fabs(mesh->vertex_value[channels * vertex + c] - value[c]) > kSameValue)
        return false;
    return mesh->vertex_position[vertex] == at;
  };
  for (std::size_t vertex = count; vertex > 0 && count - vertex < kLastVertices; --vertex)
    if (is_same(vertex - 1)) return static_cast<std::uint32_t>(vertex - 1);
  return mesh->add_vertex(at, value);
}

/// Columns of two facets between corner(t, false, mesh), on the edge, and corner(t, true, mesh).
template <class Corner>
void BandBuilder::add_columns(int count, FacetMesh* mesh, const Corner& corner) const {
  std::uint32_t low = corner(0.0, false), high = corner(0.0, true);
  for (int i = 1; i <= count; ++i) {
    const double t = 1.0 * i / count;
    const std::uint32_t next_low = corner(t, false), next_high = corner(t, true);
    for (std::uint32_t v : {high, low, next_low}) mesh->facet_vertex.push_back(v);
    for (std::uint32_t v : {high, next_low, next_high}) mesh->facet_vertex.push_back(v);
    low = next_low;
    high = next_high;
  }
}

int BandBuilder::columns(std::uint32_t half_edge) const {
  int count = 1;
  double bend = patch(half_edge).bend(along(half_edge, 0, 0), along(half_edge, 1, 0));
  for (; count < kMostColumns && bend > kColumnError; bend /= 4) count *= 2;
  return count;
}

/// The colours at an edge, from one side of it, into the triangle on the other.
void BandBuilder::carry(std::uint32_t from, std::uint32_t into, double width, FacetMesh* mesh) {
  carry_strip(from, into, width, mesh);
  // And on to the next edge of the curve, around their common vertex.
  const Value value = patch(from).shown(along(from, 1, 0));
  if (edges_.onward[from] == kNoHalfEdge) return;
  const std::uint32_t next = edges_.twin[edges_.onward[from]];
  if (next == kNoHalfEdge) return;
  for_each_between(next, [&](std::uint32_t leaving) { carry_corner(leaving, width, value, mesh); });
}

void BandBuilder::carry_strip(std::uint32_t from, std::uint32_t into, double width,
                              FacetMesh* mesh) {
  const FacetPatch source = patch(from);
  const double share = inwards(into, width);
  add_columns(columns(from), mesh, [&](double t, bool is_inner) {
    return add(inner(into, 1 - t, is_inner ? share : 0), source.shown(along(from, t, 0)), mesh);
  });
}

/// Does the same under the band that covers it, but narrower. This happens only if the band is wide
/// enough, because uncovered parts would show.
void BandBuilder::carry_under(std::uint32_t from, std::uint32_t into) {
  const double room = inwards(into, width_) * height(into);
  const bool goes_on = most_towards(previous_half_edge(into)) == 1;
  if (room < (goes_on ? kLeastShareBefore : kLeastShare) * width_) return;
  carry_strip(from, into, kUnderShare * width_, &bands_->under);
}

/// The same where no triangle is.
void BandBuilder::carry_outside(std::uint32_t from, FacetMesh* mesh) {
  const FacetPatch source = patch(from);
  add_columns(columns(from), mesh, [&](double t, bool is_outer) {
    return add(outer(from, t, is_outer ? width_ : 0), source.shown(along(from, t, 0)), mesh);
  });
}

/// An opacity of 0 into the last triangle before nothing.
void BandBuilder::carry_nothing(std::uint32_t into) {
  const double share = inwards(into, kUnderShare * width_);
  FacetMesh* mesh = &bands_->under;
  add_columns(1, mesh, [&](double t, bool is_inner) {
    return add(inner(into, t, is_inner ? share : 0), Value{}, mesh);
  });
}

/// An opacity of 0 where no triangle is.
void BandBuilder::paint_nothing(std::uint32_t beside) {
  FacetMesh* mesh = &bands_->under;
  add_columns(1, mesh, [&](double t, bool is_outer) {
    return add(outer(beside, t, is_outer ? kUnderShare * width_ : 0), Value{}, mesh);
  });
}

/// How far bands reach along the side of a triangle that leaves a curve's vertex.
double BandBuilder::reach(std::uint32_t leaving, std::uint32_t corner, double width) const {
  return std::min(most_towards(corner), width / length(position(corner) - position(leaving)));
}

/// One colour in the corner of a triangle.
void BandBuilder::carry_corner(std::uint32_t leaving, double width, const Value& value,
                               FacetMesh* mesh) {
  const Vec2 v = position(leaving);
  mesh->facet_vertex.push_back(add(v, value, mesh));
  for (std::uint32_t end : {next_half_edge(leaving), previous_half_edge(leaving)}) {
    const Vec2 at = lerp(v, position(end), reach(leaving, end, width));
    mesh->facet_vertex.push_back(add(at, value, mesh));
  }
}

/// Visits the triangles at the end of an edge up to the next curve, on its side, by their
/// half-edges that leave the common vertex. Triangles on either curve have their own bands, and
/// PDFium adds up coverage where parts of a path overlap.
template <class Visit>
void BandBuilder::for_each_between(std::uint32_t side, const Visit& visit) const {
  std::uint32_t leaving = next_half_edge(side);
  for (int turns = 0; layer_.edge_is_curve[leaving] == 0 && turns < kMostTurns; ++turns) {
    const std::uint32_t across = edges_.twin[leaving];
    if (across == kNoHalfEdge) return;
    leaving = next_half_edge(across);
    if (layer_.edge_is_curve[leaving] == 0) visit(leaving);
  }
}

/// The colours of a side next to its edge.
void BandBuilder::paint_strip(std::uint32_t side, double width, FacetMesh* mesh) {
  const FacetPatch source = patch(side);
  const double share = inwards(side, width);
  add_columns(columns(side), mesh, [&](double t, bool is_inner) {
    const double depth = is_inner ? share : 0;
    return add(inner(side, t, depth), source.shown(along(side, t, depth)), mesh);
  });
}

/// The corner of a triangle, as far as `width` reaches along its two sides.
void BandBuilder::paint_corner(std::uint32_t leaving, double width, Band* band) {
  const FacetPatch corner = patch(leaving);
  const std::uint32_t end[3] = {leaving, next_half_edge(leaving), previous_half_edge(leaving)};
  std::array<Vec2, 3> at;
  bool is_whole = true;
  for (std::size_t i = 0; i < 3; ++i) {
    const double far = i == 0 ? 0 : reach(leaving, end[i], width);
    Barycentric place{};
    place[leaving % 3] = 1 - far;
    if (i > 0) place[end[i] % 3] = far;
    is_whole &= i == 0 || far == 1;
    at[i] = lerp(position(leaving), position(end[i]), far);
    band->mesh->facet_vertex.push_back(add(at[i], corner.shown(place), band->mesh));
  }
  if (band->clip) band->clip->push_back({at[0], at[1], at[2], at[2]});
  is_whole_[leaving / 3] = is_whole ? 1 : 0;
}

/// The colours of a side along its edge and around the edge's end.
void BandBuilder::paint_band(std::uint32_t side, Band band) {
  paint_strip(side, width_, band.mesh);
  const double share = inwards(side, width_);
  if (band.clip) {
    band.clip->push_back(
        {inner(side, 0, 0), inner(side, 1, 0), inner(side, 1, share), inner(side, 0, share)});
  }
  if (share == 1) reach_vertex(previous_half_edge(side), height(side));
  for_each_between(side, [&](std::uint32_t leaving) {
    paint_corner(leaving, kCornerShare * width_, &band);
    for (std::uint32_t end : {next_half_edge(leaving), previous_half_edge(leaving)}) {
      const double way = length(position(end) - position(leaving));
      if (way < width_) reach_vertex(end, way);
    }
  });
}

/// Keeps a vertex near the curve, at the end of a way of `depth` from it, for paint_rest.
void BandBuilder::reach_vertex(std::uint32_t leaving, double depth) {
  const std::uint32_t vertex = layer_.triangle_vertex[leaving];
  if (is_on_curve_[vertex] || is_done_[vertex]) return;
  is_done_[vertex] = 1;
  reached_.push_back({leaving, depth});
}

/// On from the vertices that were reached, where triangles at the curve are low: their corners, up
/// to where the band would end.
Status BandBuilder::paint_rest(Context& context, Band band) {
  while (!reached_.empty()) {
    const auto [leaving, depth] = reached_.back();
    reached_.pop_back();
    if (context.cancelled()) return context.cancel_status();
    SFUMATO_TRY(make_room(context));
    std::uint32_t h = leaving;
    for (int turns = 0; h != kNoHalfEdge && turns < kMostTurns; ++turns) {
      const std::uint32_t ends[2] = {next_half_edge(h), previous_half_edge(h)};
      const bool is_at_curve = is_on_curve_[layer_.triangle_vertex[ends[0]]] ||
                               is_on_curve_[layer_.triangle_vertex[ends[1]]];
      if (!is_at_curve && !is_whole_[h / 3]) paint_corner(h, width_, &band);
      for (std::uint32_t end : ends) {
        const double way = depth + length(position(end) - position(h));
        if (way < width_) reach_vertex(end, way);
      }
      h = edges_.twin[previous_half_edge(h)];
      if (h == leaving) break;
    }
  }
  return ok_status();
}

/// An edge that has no other side.
void BandBuilder::paint_end(std::uint32_t side, Part part) {
  if (!is_mask()) return;  // make_end_band
  if (part == Part::band) return paint_band(side, band_of(part));
  if (part == Part::ground) return paint_nothing(side);
  carry_nothing(side);
  carry_outside(side, &bands_->over);
}

void BandBuilder::paint(std::uint32_t side, Part part) {
  const std::uint32_t across = edges_.twin[side];
  if (across == kNoHalfEdge) return paint_end(side, part);
  if (!is_mask() && is_seen(side) != is_seen(across)) {
    if (part != Part::beyond) return;
    return is_seen(side) ? carry(side, across, width_, &bands_->under)
                         : carry(across, side, width_, &bands_->under);
  }
  const FacetPatch here = patch(side), there = patch(across);
  double difference = 0;
  for (double t : {0.0, 0.5, 1.0}) {
    const Value a = here.shown(along(side, t, 0)), b = there.shown(along(across, 1 - t, 0));
    for (std::size_t c = 0; c < a.size(); ++c)
      difference = std::max(difference, std::fabs(a[c] - b[c]));
  }
  if (difference < kLeastDifference) return;
  if (part == Part::band) return paint_band(side, band_of(part));
  // Splash lets this side's triangles come over the curve: the other side's colours are painted
  // there again.
  if (part == Part::ground) return paint_band(across, band_of(part));
  carry_under(across, side);
  carry(side, across, width_, &bands_->over);
}

}  // namespace

Result<CurveBands> make_curve_bands(Context& context, const PatchLayer& layer,
                                    InterpolationSpace space, const FacetSource& source,
                                    const CurveEdges& edges, double width) {
  CurveBands bands;
  for (FacetMesh* mesh : {&bands.under, &bands.over})
    mesh->memory = TableMemory("bands along curves");
  SFUMATO_TRY(BandBuilder(layer, space, source, edges, width, &bands).build(context));
  return bands;
}

}  // namespace sfumato::outputs
