#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "sfumato/document/change.hpp"
#include "sfumato/document/document.hpp"

namespace sfumato::capi {

/// Some curves of a layer.
struct LayerCurves {
  std::uint32_t layer = 0;
  std::vector<std::uint32_t> curves{};  ///< ascending, at least one

  friend bool operator==(const LayerCurves&, const LayerCurves&) = default;
};

/// The state of a document: the number of the last edit of each curve, and of everything else.
struct Revisions {
  std::shared_ptr<const char> document{};  ///< identifies the document; not read
  std::uint64_t last = 0;                  ///< number of the last edit
  std::uint64_t frame = 0;                 ///< of everything but the curves
  /// Per layer, per curve; 0: unknown.
  std::vector<std::vector<std::uint64_t>> curves{};
};

/// Returns the state of a document that is new.
Revisions revisions_of(const Document& document);

/// Returns the bytes of memory that the lists take.
std::size_t bytes_of(const Revisions& revisions);

/// Reserves memory for note(), which then cannot fail.
void make_room(const Change& change, Revisions& revisions);

/// Updates the state after a curve was replaced, inserted or removed.
/// inverse   the change that undoes this
void note(const Change& inverse, Revisions& revisions);

/// Returns the curves that differ between two states, per layer. Returns none if anything else
/// differs, such as the number of curves.
std::optional<std::vector<LayerCurves>> changed_curves(const Revisions& from, const Revisions& to);

}  // namespace sfumato::capi
