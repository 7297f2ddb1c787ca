#include "capi/documents/edits.hpp"

#include <algorithm>
#include <span>

namespace sfumato::capi {
namespace {

constexpr std::size_t kMostNoted = 256;

/// Returns the place of a curve after later edits; none if it was removed.
std::optional<CurvePlace> place_after(CurvePlace place, std::span<const Edit> later) {
  for (const Edit& edit : later) {
    if (edit.place.layer != place.layer) continue;
    if (edit.kind == Edit::Kind::inserted && edit.place.curve <= place.curve) ++place.curve;
    if (edit.kind != Edit::Kind::removed) continue;
    if (edit.place == place) return std::nullopt;
    if (edit.place.curve < place.curve) --place.curve;
  }
  return place;
}

/// Returns whether an inserted curve may be one that was removed.
bool may_come_back(const std::vector<Edit>& edits) {
  const auto has = [&](Edit::Kind kind) {
    return std::ranges::count(edits, kind, &Edit::kind) > 0;
  };
  return has(Edit::Kind::inserted) && has(Edit::Kind::removed);
}

Change change_of(const Edit& edit, const Curve& curve) {
  const auto [layer, index] = edit.place;
  if (edit.kind == Edit::Kind::inserted) return InsertCurve{layer, index, curve};
  return ReplaceCurve{layer, index, curve};
}

}  // namespace

std::optional<Edit> edit_of(const Change& change) {
  if (const auto* c = std::get_if<ReplaceCurve>(&change)) {
    return Edit{Edit::Kind::replaced, {c->layer, c->curve}};
  }
  if (const auto* c = std::get_if<InsertCurve>(&change)) {
    return Edit{Edit::Kind::inserted, {c->layer, c->curve}};
  }
  if (const auto* c = std::get_if<RemoveCurve>(&change)) {
    return Edit{Edit::Kind::removed, {c->layer, c->curve}};
  }
  return std::nullopt;
}

void Edits::note(std::optional<Edit> edit) {
  ++now_.edits;
  if (!edit) {
    noted_.clear();
    before_ = now_.edits;
    return;
  }
  const bool goes_on =
      edit->kind == Edit::Kind::replaced && !noted_.empty() && noted_.back().edit == *edit;
  if (goes_on) {
    noted_.back().last = now_.edits;
    return;
  }
  noted_.push_back({*edit, now_.edits});
  if (noted_.size() <= kMostNoted) return;
  before_ = noted_.front().last;
  noted_.pop_front();
}

std::optional<std::vector<Edit>> Edits::since(const Revision& then) const {
  if (then.document != now_.document || then.edits < before_) return std::nullopt;
  std::vector<Edit> edits;
  for (const Noted& noted : noted_) {
    if (noted.last > then.edits) edits.push_back(noted.edit);
  }
  return edits;
}

std::optional<LayerCurves> Edits::only_changes_since(const Revision& then) const {
  const std::optional<std::vector<Edit>> edits = since(then);
  if (!edits || edits->empty()) return std::nullopt;
  LayerCurves changed{edits->front().place.layer, {}};
  for (const Edit& edit : *edits) {
    if (edit.kind != Edit::Kind::replaced || edit.place.layer != changed.layer) return std::nullopt;
    changed.curves.push_back(edit.place.curve);
  }
  std::ranges::sort(changed.curves);
  const auto rest = std::ranges::unique(changed.curves);
  changed.curves.erase(rest.begin(), rest.end());
  return changed;
}

std::optional<std::vector<Change>> changes_of(const std::vector<Edit>& edits, const Document& now) {
  if (may_come_back(edits)) return std::nullopt;
  std::vector<Change> changes;
  changes.reserve(edits.size());
  for (std::size_t i = 0; i < edits.size(); ++i) {
    const auto [layer, index] = edits[i].place;
    if (edits[i].kind == Edit::Kind::removed) {
      changes.push_back(RemoveCurve{layer, index});
    } else if (const auto last = place_after(edits[i].place, std::span(edits).subspan(i + 1))) {
      changes.push_back(change_of(edits[i], now.layers[last->layer].curves[last->curve]));
    }
  }
  return changes;
}

}  // namespace sfumato::capi
