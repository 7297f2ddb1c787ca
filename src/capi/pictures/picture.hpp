#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "base/charge.hpp"
#include "capi/context.hpp"
#include "capi/documents/revisions.hpp"
#include "options/option.hpp"
#include "options/settings.hpp"
#include "sfumato/base/vec2.hpp"
#include "sfumato/solve/solution.hpp"

namespace sfumato::capi {

/// Ranges of rows [from, to), ascending and disjoint.
using RowRanges = std::vector<std::array<std::uint32_t, 2>>;

/// The ranges for each table of a layer.
using ChangedRows = std::array<RowRanges, SFUMATO_OPACITY_VALUES + 1>;

/// Returns the settings of a solution of a document.
DiffuseOptions solve_options(const options::Settings& settings, const Document& document);

/// Reads the options for solving a document, and the options of a picture unless `picture` is null.
/// Errors: bad usage, also if options conflict.
Outcome read_solve_options(const char* text, options::Call call, options::Settings& settings,
                           options::PictureSettings* picture = nullptr);

/// Notes the new rows; in a new layer these are all rows.
void note_changes(const Picture& picture, const PictureDelta& delta,
                  std::vector<ChangedRows>& changed);

/// Returns whether frames of a drag of these curves take less time than rough pictures.
bool may_be_dragged(const LayerCurves& changed, const Document& document);

/// Updates a picture to its document if only these curves differ, within a time as
/// Solution::drag(). Errors: as drag() and color().
Status show_changes(sfumato_context& context, const LayerCurves& changed,
                    const sfumato_document& document, double seconds, sfumato_picture& handle);

/// Returns the error for a picture that was read from a file and therefore cannot follow a
/// document.
Outcome no_solution();

/// Gathers waiting nodes of a picture that matches its document. Errors: as Solution::drag_more().
Status show_more(sfumato_context& context, double seconds, sfumato_picture& handle);

/// Returns a table of a layer; an empty view if there is no such table.
sfumato_view table_of(const PatchLayer& layer, std::uint32_t table);

}  // namespace sfumato::capi

struct sfumato_picture {
  sfumato_picture(std::shared_ptr<sfumato::capi::Workshop> w, sfumato::Solution s,
                  const sfumato::options::Settings& asked)
      : workshop(std::move(w)), solution(std::move(s)), settings(asked) {}

  /// A picture that was read from a file; it is charged while it is held.
  sfumato_picture(std::shared_ptr<sfumato::capi::Workshop> w, sfumato::ScopedCharge charge,
                  sfumato::Picture p)
      : workshop(std::move(w)), read_charge(std::move(charge)), read(std::move(p)) {}

  const sfumato::Picture& picture() const { return solution ? solution->picture() : read; }
  /// The work that made the picture.
  void count(const sfumato::DiffuseStats& done, const sfumato::FrameLayers& made = {}) {
    stats = done;
    frame = made;
  }

  std::shared_ptr<sfumato::capi::Workshop> workshop;         ///< first: it outlives the rest
  std::shared_ptr<sfumato::capi::Workshop> drag_workshop{};  ///< so does that of its drag
  sfumato::ScopedCharge read_charge{};
  sfumato::Picture read{};  ///< the picture if there is no solution
  std::optional<sfumato::Solution> solution{};
  sfumato::options::Settings settings{};  ///< the settings that it is solved with
  double pixels_per_unit = 1;             ///< the same, of the last time
  sfumato::Vec2 own_scale{1, 1};          ///< pixels per user unit at the document's own size
  std::vector<sfumato::capi::ChangedRows> changed{};    ///< of each layer
  sfumato::DiffuseStats stats{};                        ///< from the last time that it was solved
  sfumato::FrameLayers frame{};                         ///< the same, where it is one of a film
  sfumato::capi::Revisions shown{};                     ///< the state that it is a picture of
  sfumato::capi::Revisions applied{};                   ///< the state of its solution's document
  std::optional<sfumato::capi::LayerCurves> dragged{};  ///< or that may be dragged next
  bool has_moved = false;                               ///< whether they were dragged
  std::optional<sfumato::StopPlace> colored{};  ///< the stop that its solution is prepared for
};
