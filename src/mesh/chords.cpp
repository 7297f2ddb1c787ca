#include "mesh/chords.hpp"

#include <algorithm>

#include "base/try.hpp"

namespace sfumato::mesh {

Status ChordStore::copy_from(const Context& context, const ChordStore& other) {
  SFUMATO_TRY(charge_.raise_to(
      context, room_bytes(other.chord_) + room_bytes(other.owner_) + room_bytes(other.free_chord_),
      "curve pieces"));
  chord_ = other.chord_;
  owner_ = other.owner_;
  free_chord_ = other.free_chord_;
  free_owner_ = other.free_owner_;
  live_owners_ = other.live_owners_;
  return context.check();
}

std::int32_t ChordStore::new_owner(Owner owner) {
  ++live_owners_;
  if (free_owner_ == kNone) {
    owner_.push_back(owner);
    return static_cast<std::int32_t>(owner_.size()) - 1;
  }
  const std::int32_t index = free_owner_;
  free_owner_ = owner_[index].next;
  owner_[index] = owner;
  return index;
}

Load ChordStore::whole(std::uint32_t segment) {
  return {new_owner({segment, 0, 1, kNone}), 1, false};
}

std::pair<Load, Load> ChordStore::split(Load load, double s) {
  Load second{kNone, load.count, load.frame};
  for (std::int32_t i = load.first; i != kNone; i = owner_[i].next) {
    const double from = owner_[i].u_from;
    const double to = owner_[i].u_to;
    const float middle = static_cast<float>(from + (to - from) * s);
    const std::int32_t copy = new_owner({owner_[i].segment, middle, owner_[i].u_to, second.first});
    owner_[i].u_to = middle;
    second.first = copy;
  }
  return {load, second};
}

std::int32_t ChordStore::add(Vertex from, Vertex to, Load load) {
  if (free_chord_.empty()) {
    chord_.push_back({from, to, load});
    return static_cast<std::int32_t>(chord_.size()) - 1;
  }
  const std::int32_t index = free_chord_.back();
  free_chord_.pop_back();
  chord_[index] = {from, to, load};
  return index;
}

void ChordStore::merge(std::int32_t chord_index, Vertex from, Load load) {
  Chord& chord = chord_[chord_index];
  const bool reversed = chord.from != from;
  std::int32_t i = load.first;
  while (i != kNone) {
    const std::int32_t after = owner_[i].next;
    if (reversed) std::swap(owner_[i].u_from, owner_[i].u_to);
    owner_[i].next = chord.load.first;
    chord.load.first = i;
    i = after;
  }
  chord.load.count += load.count;
  chord.load.frame ^= load.frame;
}

Load ChordStore::remove(std::int32_t chord_index) {
  const Load load = chord_[chord_index].load;
  chord_[chord_index] = {};
  free_chord_.push_back(chord_index);
  return load;
}

void ChordStore::discard(Load load) {
  std::int32_t i = load.first;
  while (i != kNone) {
    const std::int32_t after = owner_[i].next;
    owner_[i].next = free_owner_;
    free_owner_ = i;
    --live_owners_;
    i = after;
  }
}

bool ChordStore::take_off(std::int32_t chord_index, std::span<const std::uint8_t> is_removed) {
  Load& load = chord_[chord_index].load;
  Load removed, kept{kNone, 0, load.frame};
  for (std::int32_t i = load.first; i != kNone;) {
    const std::int32_t after = owner_[i].next;
    Load& list = is_removed[owner_[i].segment] ? removed : kept;
    owner_[i].next = std::exchange(list.first, i);
    ++list.count;
    i = after;
  }
  load = kept;
  discard(removed);
  return removed.count > 0;
}

std::int32_t ChordStore::add_part(const ChordStore& other, const Chord& whole, Vertex from,
                                  Vertex to, double at_from, double at_to) {
  Load load{kNone, 0, whole.load.frame};
  for (std::int32_t i = whole.load.first; i != kNone; i = other.owner_[i].next) {
    const Owner& owner = other.owner_[i];
    const double u0 = owner.u_from, u1 = owner.u_to;
    load.first = new_owner({owner.segment, static_cast<float>(u0 * (1 - at_from) + u1 * at_from),
                            static_cast<float>(u0 * (1 - at_to) + u1 * at_to), load.first});
    ++load.count;
  }
  return add(from, to, load);
}

Status ChordStore::seal(const Context& context) {
  TableMemory memory("curve pieces");
  std::vector<Owner> sorted;
  SFUMATO_TRY(memory.reserve(context, sorted, live_owners_));
  for (Chord& chord : chord_) {
    const auto first = static_cast<std::int32_t>(sorted.size());
    for (std::int32_t i = chord.load.first; i != kNone; i = owner_[i].next) {
      sorted.push_back(owner_[i]);
    }
    if (chord.load.count > 0) chord.load.first = first;
    // One segment can lie on a chord twice, if it was snapped to a vertex and back.
    const auto drawn_before = [](const Owner& a, const Owner& b) {
      if (a.segment != b.segment) return a.segment < b.segment;
      return std::min(a.u_from, a.u_to) < std::min(b.u_from, b.u_to);
    };
    if (chord.load.count > 1) std::sort(sorted.begin() + first, sorted.end(), drawn_before);
    const auto end = static_cast<std::int32_t>(sorted.size());
    for (std::int32_t i = first; i < end; ++i) sorted[i].next = i + 1 < end ? i + 1 : kNone;
  }
  owner_ = std::move(sorted);
  free_owner_ = kNone;
  return ok_status();
}

}  // namespace sfumato::mesh
