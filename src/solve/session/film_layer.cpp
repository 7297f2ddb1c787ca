#include "solve/session/film_layer.hpp"

#include <algorithm>
#include <span>
#include <utility>

#include "base/try.hpp"
#include "curves/attributes.hpp"
#include "solve/layers/placed_curves.hpp"

namespace sfumato::solve {
namespace {

/// Returns whether both lists of curves need the same fields.
bool have_same_fields(std::span<const Curve> a, std::span<const Curve> b) {
  return curves::opacity_goes_with_color(a) == curves::opacity_goes_with_color(b) &&
         std::ranges::any_of(a, curves::bears_opacity) ==
             std::ranges::any_of(b, curves::bears_opacity);
}

}  // namespace

Result<FilmLayer> FilmLayer::begin(Context& context, const Document& document, std::uint32_t layer,
                                   const LayerSight& sight, const DiffuseOptions& options,
                                   DiffuseStats* stats, PatchLayer& patches) {
  FilmLayer film(input_of(document, layer, sight, options));
  SFUMATO_TRY(
      film.charge_.add(context, bytes_of(film.first_.curves) + bytes_of(film.last_), "a film"));
  SFUMATO_TRY_ASSIGN(patches,
                     LayerSession::solve_with_room(context, film.first_, stats, film.refined_));
  return film;
}

bool FilmLayer::can_go_on(const Document& document, std::uint32_t layer,
                          const LayerSight& sight) const {
  const std::vector<Curve>& curves = document.layers[layer].curves;
  if (!refined_ || curves.size() != last_.size() || !(sight == first_.sight) ||
      !(document.artboard == first_.artboard) || document.interpolation != first_.interpolation) {
    return false;
  }
  std::size_t changed = 0;
  for (std::size_t i = 0; i < curves.size(); ++i) changed += !(curves[i] == last_[i]);
  return 2 * changed <= curves.size();
}

/// Returns the curves that ever moved, ascending.
std::vector<std::uint32_t> FilmLayer::moving(const std::vector<Curve>& now) const {
  std::vector<std::uint32_t> known, list;
  if (session_) known = session_->moving();
  for (std::uint32_t i = 0; i < now.size(); ++i) {
    if (std::ranges::binary_search(known, i) || !(now[i] == first_.curves[i])) list.push_back(i);
  }
  return list;
}

Result<std::optional<PatchLayer>> FilmLayer::next(Context& context, const Document& document,
                                                  std::uint32_t layer, DiffuseStats* stats) {
  const std::optional<PatchLayer> none;
  const std::vector<Curve>& now = document.layers[layer].curves;
  std::vector<std::uint32_t> which = moving(now);
  if (which.empty() || !have_same_fields(now, first_.curves)) return none;
  if (!session_ || session_->moving() != which) {
    session_.reset();
    SFUMATO_TRY_ASSIGN(auto&& session,
                       LayerSession::open(context, first_, std::move(which), refined_,
                                          {.most_missed = 0, .holds_bound = true}));
    session_.emplace(std::move(session));
  }
  std::vector<Curve> moved;
  for (const std::uint32_t curve : session_->moving()) moved.push_back(now[curve]);
  SFUMATO_TRY_ASSIGN(auto&& frame, session_->frame(context, moved, {.stats = stats}));
  if (!frame) return none;
  if (stats) stats->curves += moved.size();
  last_ = now;
  return std::optional(std::move(frame->layer));
}

}  // namespace sfumato::solve
