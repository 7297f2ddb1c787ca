#pragma once

#include <cstddef>
#include <cstdint>
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

/// The state of a document: a number for each curve, and one for everything else. Each edit gives a
/// new number to what it changes. Equal numbers mean equal content; 0 means unknown content.
struct Revisions {
  std::uint64_t frame = 0;                         ///< of everything but the curves
  std::vector<std::vector<std::uint64_t>> curves;  ///< per layer, per curve

  friend bool operator==(const Revisions&, const Revisions&) = default;
};

/// Returns the state of a document that is new.
Revisions revisions_of(const Document& document);

/// Returns the bytes of memory that the lists take.
std::size_t bytes_of(const Revisions& revisions);

/// Reserves memory for note(), which then cannot fail.
void make_room(const Change& change, Revisions& revisions);

/// Updates the state after a change of a curve, of which this is the inverse.
void note(const Change& inverse, Revisions& revisions);

/// Returns the curves that differ between two states, per layer. Returns none if anything else
/// differs, such as the number of curves.
std::optional<std::vector<LayerCurves>> changed_curves(const Revisions& from, const Revisions& to);

}  // namespace sfumato::capi
