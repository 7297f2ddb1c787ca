#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "base/charge.hpp"
#include "capi/context.hpp"
#include "capi/edits.hpp"
#include "options/option.hpp"
#include "options/settings.hpp"
#include "sfumato/base/vec2.hpp"
#include "sfumato/solve/solution.hpp"

namespace sfumato::capi {

/// Rows from and up to, ascending and apart.
using RowRanges = std::vector<std::array<std::uint32_t, 2>>;

/// For each table of a layer.
using ChangedRows = std::array<RowRanges, SFUMATO_OPACITY_VALUES + 1>;

/// What the options of a solution say for a document.
DiffuseOptions solve_options(const options::Settings& settings, const Document& document);

/// Reads the options by which a document is solved, and those of a picture unless `picture` is
/// null. Errors: bad usage, also where options do not go together.
Outcome read_solve_options(const char* text, options::Call call, options::Settings& settings,
                           options::PictureSettings* picture = nullptr);

/// The rows that are new, which are all of them in layers that are so as a whole.
void note_changes(const Picture& picture, const PictureDelta& delta,
                  std::vector<ChangedRows>& changed);

/// Brings a picture nearer to what a document is, where one curve is all that differs, in a time as
/// Solution::drag(). Errors: bad input where it has to be solved, others as drag() and color().
Status show_change(sfumato_context& context, CurvePlace place, const sfumato_document& document,
                   double seconds, sfumato_picture& handle);

/// Prepares the picture, which is one of what the document is, for a curve to be moved.
Status expect_drag(sfumato_context& context, CurvePlace place, sfumato_picture& handle);

/// What is wrong with a picture that was read from a file, where it is to follow a document.
Outcome no_solution();

/// Gathers nodes that wait, of a picture of what the document is. Errors: as
/// Solution::drag_more().
Status show_more(sfumato_context& context, double seconds, sfumato_picture& handle);

/// A table of a layer; false where there is no such table.
bool find_table(const PatchLayer& layer, std::uint32_t table, sfumato_view& view);

}  // namespace sfumato::capi

struct sfumato_picture {
  sfumato_picture(std::shared_ptr<sfumato::capi::Workshop> w, sfumato::Solution s,
                  const sfumato::options::Settings& asked)
      : workshop(std::move(w)), solution(std::move(s)), settings(asked) {}

  /// Of a picture that was read from a file, which is charged as long as it is held.
  sfumato_picture(std::shared_ptr<sfumato::capi::Workshop> w, sfumato::ScopedCharge charge,
                  sfumato::Picture p)
      : workshop(std::move(w)), read_charge(std::move(charge)), read(std::move(p)) {}

  const sfumato::Picture& picture() const { return solution ? solution->picture() : read; }
  /// What was done to make it what it is.
  void count(const sfumato::DiffuseStats& done, const sfumato::FrameLayers& made = {}) {
    stats = done;
    frame = made;
  }

  std::shared_ptr<sfumato::capi::Workshop> workshop;         ///< first: it outlives the rest
  std::shared_ptr<sfumato::capi::Workshop> drag_workshop{};  ///< so does that of its drag
  sfumato::ScopedCharge read_charge{};
  sfumato::Picture read{};  ///< what it is where there is no solution
  std::optional<sfumato::Solution> solution{};
  sfumato::options::Settings settings{};  ///< that it is solved with
  double pixels_per_unit = 1;             ///< the same, of the last time
  sfumato::Vec2 own_scale{1, 1};          ///< pixels per user unit at the document's own size
  std::vector<sfumato::capi::ChangedRows> changed{};  ///< of each layer
  sfumato::DiffuseStats stats{};                      ///< of the last time that it was solved
  sfumato::FrameLayers frame{};                       ///< the same, where it is one of a film
  sfumato::capi::Revision shown{};                    ///< what it is a picture of
  sfumato::capi::Revision applied{};                  ///< what its solution's document is
  std::optional<sfumato::capi::CurvePlace> dragged{};
  bool has_moved = false;  ///< the curve that is dragged, which may only be expected to be
  std::optional<sfumato::StopPlace> colored{};  ///< the stop that its solution is prepared for
};
