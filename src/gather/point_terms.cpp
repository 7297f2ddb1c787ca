#include "gather/point_terms.hpp"

#include <algorithm>
#include <cmath>

#include "gather/kernels/end_tree.hpp"

namespace sfumato::gather {

void PointTerms::add_varied(std::uint32_t source, double k, double from, double to,
                            const PartMoment& part) {
  const RowEdge& edge = sources_->edge[source];
  const RowSource& of = sources_->source[source];
  if (is_one_term(of, edge.distance(p_))) return add(source, part);
  const Vec2 a = edge.from - p_;
  split_by_radius(of, {a, a + edge.along, from, to}, [&](const PartMoment& m) {
    if (m.weight > 0) edge_.push_back({source, {k * m.weight, k * m.moment}});
  });
}

void PointTerms::add_ends() {
  const std::span<const FreeEnd> ends = sources_->ends.all();
  const auto x = static_cast<float>(p_.x), y = static_cast<float>(p_.y);
  visit_leaves(sources_->ends.view(), {x, y, x, y}, [&](std::uint32_t leaf) {
    const std::size_t first = std::size_t{kEndsPerLeaf} * leaf;
    for (std::size_t i = first; i < std::min(first + kEndsPerLeaf, ends.size()); ++i) {
      const EndShare share = end_share(ends[i], p_ - ends[i].position);
      if (share.weight > 0) end_.push_back({sources_->of_end(i, share.is_positive()), share});
    }
    return true;
  });
}

void PointTerms::store(float negligible, std::vector<RowTerm>& out) const {
  double all = 0, kept = 0;
  for (const OfEdge& e : edge_) all += e.part.weight;
  for (const OfEnd& e : end_) all += e.share.weight;
  const double least = negligible * all;
  for (const OfEdge& e : edge_) kept += e.part.weight >= least ? e.part.weight : 0;
  for (const OfEnd& e : end_) kept += e.share.weight >= least ? e.share.weight : 0;
  // All terms of a crowd of small ones stay.
  const double bound = kept > 0 ? least : 0, unit = 1 / (kept > 0 ? kept : all);
  for (const auto& [source, part] : edge_) {
    if (part.weight < bound) continue;
    out.push_back({source, static_cast<float>(part.weight * unit),
                   static_cast<float>(std::clamp(part.moment / part.weight, 0.0, 1.0)),
                   static_cast<float>(sources_->edge[source].distance(p_)), 1});
  }
  for (const auto& [source, share] : end_) {
    if (share.weight < bound) continue;
    out.push_back({source, static_cast<float>(share.weight * unit), 0,
                   static_cast<float>(std::fabs(share.across)),
                   static_cast<float>(std::fabs(share.half_sine))});
  }
}

}  // namespace sfumato::gather
