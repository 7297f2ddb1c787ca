#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "base/table_memory.hpp"
#include "mesh/triangulation.hpp"
#include "sfumato/base/limits.hpp"

namespace sfumato::mesh {

/// A stretch of a flattened segment on a chord: its fractions at the chord's two ends.
struct Owner {
  std::uint32_t segment = 0;
  float u_from = 0;
  float u_to = 1;
  std::int32_t next = kNone;  ///< the next owner of the same chord
};

/// The load of a stretch of a constraint: a list of owners, and whether the frame runs here. Where
/// the frame runs twice over one edge it cancels out: the frame is a cycle modulo 2.
struct Load {
  std::int32_t first = kNone;
  std::int32_t count = 0;
  bool frame = false;

  bool empty() const { return count == 0 && !frame; }
};

/// A straight constrained edge of the arrangement. Refinement cuts its edge, never the chord.
struct Chord {
  Vertex from = kNone;
  Vertex to = kNone;
  Load load;
};

/// Limit of live owners in one arrangement, per segment that a layer may have. Each crossing of
/// overlapping curves multiplies their owners.
inline constexpr std::size_t kOwnersPerSegment = 4;

/// All chords and their owners. Slots of removed ones are reused.
class ChordStore {
 public:
  ChordStore() = default;
  /// Makes an empty store. Charges its memory to `budget`, whichever Context it grows in.
  explicit ChordStore(Budget& budget) : charge_(budget) {}

  const Chord& operator[](std::int32_t index) const { return chord_[index]; }
  std::size_t size() const { return chord_.size(); }
  std::size_t live_owner_count() const { return live_owners_; }
  /// Charges the growth of the tables. A table that is nearly full counts as if it had grown
  /// already. Error: limit (memory).
  Status charge(const Context& context) {
    return charge_.raise_to(
        context, room_bytes(chord_) + room_bytes(owner_) + room_bytes(free_chord_), "curve pieces");
  }

  /// Copies another store. Errors: limit (memory), cancelled.
  Status copy_from(const Context& context, const ChordStore& other);

  const Owner& owner(std::int32_t index) const { return owner_[index]; }

  /// Makes a load of one whole segment.
  Load whole(std::uint32_t segment);

  /// Splits a load at fraction s (0 to 1) of its stretch. The first half keeps the slots of `load`.
  std::pair<Load, Load> split(Load load, double s);

  std::int32_t add(Vertex from, Vertex to, Load load);

  /// Adds `load`, which starts at `from`, to the load of a chord.
  void merge(std::int32_t chord_index, Vertex from, Load load);

  /// Frees the chord and returns its load, in the direction from its `from` to its `to`.
  Load remove(std::int32_t chord_index);

  void discard(Load load);

  /// Removes the owners whose segment s has is_removed[s] from a chord. Returns whether any was
  /// removed.
  bool take_off(std::int32_t chord_index, std::span<const std::uint8_t> is_removed);

  /// Adds a chord from one vertex to another. They lie at these fractions of `whole`, a chord of
  /// `other`; the new chord gets its part of the owners.
  std::int32_t add_part(const ChordStore& other, const Chord& whole, Vertex from, Vertex to,
                        double at_from, double at_to);

  /// Ends an arrangement: stores the owners of each chord consecutively, in drawing order, until
  /// the next change. Errors: limit (memory; a second table of owners exists meanwhile), cancelled.
  Status seal(const Context& context);

  /// Returns the owners of a chord. Call it after `seal`.
  const Owner* begin(const Chord& c) const {
    return c.load.count > 0 ? owner_.data() + c.load.first : nullptr;
  }

 private:
  template <class Item>
  static std::size_t room_bytes(const std::vector<Item>& table) {
    return table.size() > table.capacity() / 4 * 3 ? 2 * capacity_bytes(table)
                                                   : capacity_bytes(table);
  }

  std::int32_t new_owner(Owner owner);

  std::vector<Chord> chord_;
  std::vector<Owner> owner_;
  std::vector<std::int32_t> free_chord_;
  std::int32_t free_owner_ = kNone;
  std::size_t live_owners_ = 0;
  ScopedCharge charge_;
};

}  // namespace sfumato::mesh
