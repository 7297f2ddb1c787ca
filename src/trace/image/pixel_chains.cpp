#include "trace/image/pixel_chains.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>
#include <tuple>
#include <utility>

#include "base/poll.hpp"
#include "base/try.hpp"
#include "sfumato/base/vec2.hpp"

namespace sfumato::tracing {
namespace {

constexpr std::size_t kLeastChainPixels = 4;
/// Pixels over which the direction of a chain is taken.
constexpr std::size_t kDirectionPixels = 6;
/// cos 60°: how directly an end must face the other end, or the chain that it joins.
constexpr double kFacing = 0.5;

constexpr std::array<PixelPlace, 8> kNeighbours{
    {{0, -1}, {-1, 0}, {1, 0}, {0, 1}, {-1, -1}, {1, -1}, {-1, 1}, {1, 1}}};
constexpr std::array<PixelPlace, 8> kRing{
    {{0, -1}, {1, -1}, {1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}}};

Vec2 center(PixelPlace p) {
  return {static_cast<double>(p.x), static_cast<double>(p.y)};
}

class ChainWalker {
 public:
  ChainWalker(const Context& context, const EdgeMap& edges)
      : context_(context), poll_(context), edges_(edges) {}

  Result<PixelChains> run() {
    SFUMATO_TRY(memory_.resize(context_, is_used_, edges_.pixel.size()));
    SFUMATO_TRY(make_room());
    for (const bool from_ends : {true, false}) {
      for (int y = 0; y < edges_.height; ++y) {
        for (int x = 0; x < edges_.width; ++x) {
          if (poll_.cancelled()) return context_.cancel_status();
          const PixelPlace p{x, y};
          if (!is_free(p) || (from_ends && crossings(p) != 1)) continue;
          begin_at(p, !from_ends);
        }
      }
    }
    return std::move(chains_);
  }

 private:
  std::size_t index(PixelPlace p) const {
    return static_cast<std::size_t>(p.y) * static_cast<std::size_t>(edges_.width) +
           static_cast<std::size_t>(p.x);
  }
  bool is_edge(PixelPlace p) const {
    return p.x >= 0 && p.y >= 0 && p.x < edges_.width && p.y < edges_.height &&
           edges_.pixel[index(p)].scale > 0;
  }
  bool is_free(PixelPlace p) const { return is_edge(p) && !is_used_[index(p)]; }

  /// Reserves memory for chains of all edge pixels; each pixel is in at most one chain.
  Status make_room() {
    std::size_t count = 0;
    for (const EdgePixel& pixel : edges_.pixel) {
      if (poll_.cancelled()) return context_.cancel_status();
      count += pixel.scale > 0;
    }
    SFUMATO_TRY(chains_.memory.reserve(context_, chains_.place, count));
    return chains_.memory.reserve(context_, chains_.end, count / kLeastChainPixels);
  }

  /// Returns how many lines leave the pixel.
  int crossings(PixelPlace p) const {
    int count = 0;
    for (std::size_t i = 0; i < kRing.size(); ++i) {
      const PixelPlace a = kRing[i], b = kRing[(i + 1) % kRing.size()];
      count += !is_edge({p.x + a.x, p.y + a.y}) && is_edge({p.x + b.x, p.y + b.y});
    }
    return count;
  }

  void begin_at(PixelPlace p, bool both_ways) {
    std::vector<PixelPlace>& places = chains_.place;
    const std::size_t begin = places.size();
    walk(p);
    if (both_ways) {
      const auto ahead = static_cast<std::ptrdiff_t>(places.size() - begin);
      if (const std::optional<PixelPlace> other = next(PixelChain(&p, 1))) {
        walk(*other);
        // The part that was walked backwards comes first, from its end to its beginning.
        std::reverse(places.begin() + static_cast<std::ptrdiff_t>(begin), places.end());
        std::reverse(places.end() - ahead, places.end());
      }
    }
    if (places.size() - begin >= kLeastChainPixels) return chains_.end_chain();
    places.resize(begin);
  }

  /// Adds the places of a walk from p on.
  void walk(PixelPlace p) {
    std::vector<PixelPlace>& places = chains_.place;
    const std::size_t begin = places.size();
    places.push_back(p);
    is_used_[index(p)] = 1;
    while (const std::optional<PixelPlace> to = next(std::span(places).subspan(begin))) {
      use_step(places.back(), *to);
      places.push_back(*to);
    }
  }

  /// A diagonal step also passes the pixel in its corner: thin lines at 45° are staircases, and
  /// their remaining pixels would make a second chain beside the first.
  void use_step(PixelPlace from, PixelPlace to) {
    is_used_[index(to)] = 1;
    for (const PixelPlace corner : {PixelPlace{from.x, to.y}, PixelPlace{to.x, from.y}}) {
      if (is_edge(corner)) is_used_[index(corner)] = 1;
    }
  }

  /// Returns the free neighbour of the chain's end that lies most nearly straight ahead.
  std::optional<PixelPlace> next(PixelChain chain) const {
    const PixelPlace at = chain.back();
    const PixelPlace from = chain[chain.size() - std::min<std::size_t>(chain.size(), 5)];
    const Vec2 ahead = center(at) - center(from);
    std::optional<PixelPlace> best;
    double most = 0;
    for (const PixelPlace step : kNeighbours) {
      const PixelPlace to{at.x + step.x, at.y + step.y};
      if (!is_free(to)) continue;
      const double straight = dot(ahead, center(step)) / length(center(step));
      if (!best || straight > most) best = to, most = straight;
    }
    return best;
  }

  const Context& context_;
  RarePoll<1024> poll_;
  const EdgeMap& edges_;
  TableMemory memory_{"the edges of a picture"};
  std::vector<std::uint8_t> is_used_;
  PixelChains chains_;
};

PixelPlace end_of(PixelChain chain, bool is_last) {
  return is_last ? chain.back() : chain.front();
}

/// Returns the direction of a chain at an end, outwards; (0, 0) if it has none.
Vec2 outwards(PixelChain chain, bool is_last) {
  const std::size_t back = std::min(chain.size() - 1, kDirectionPixels);
  const PixelPlace inner = is_last ? chain[chain.size() - 1 - back] : chain[back];
  const Vec2 direction = center(end_of(chain, is_last)) - center(inner);
  const double far = length(direction);
  return far > 0 ? direction / far : direction;
}

bool is_loop(PixelChain chain) {
  return length(center(chain.front()) - center(chain.back())) < 2;
}

/// Something at each pixel of a picture, at most one.
class PixelTable {
 public:
  /// Errors: limit (memory), cancelled.
  Status create(const Context& context, const EdgeMap& edges) {
    width_ = edges.width;
    height_ = edges.height;
    return memory_.resize(context, entry_, edges.pixel.size(), -1);
  }

  std::int32_t& at(PixelPlace p) {
    return entry_[static_cast<std::size_t>(p.y) * static_cast<std::size_t>(width_) +
                  static_cast<std::size_t>(p.x)];
  }

  /// visit(place, entry) for entries within `reach` of p, row by row.
  template <class Visit>
  void near(PixelPlace p, double reach, Visit visit) {
    const int far = static_cast<int>(reach);
    for (int y = std::max(p.y - far, 0); y <= std::min(p.y + far, height_ - 1); ++y) {
      for (int x = std::max(p.x - far, 0); x <= std::min(p.x + far, width_ - 1); ++x) {
        const PixelPlace q{x, y};
        if (at(q) >= 0 && length(center(q) - center(p)) <= reach) visit(q, at(q));
      }
    }
  }

 private:
  int width_ = 0, height_ = 0;
  TableMemory memory_{"the edges of a picture"};
  std::vector<std::int32_t> entry_;
};

/// Ends of chains, and which of them are to be joined.
class GapJoiner {
 public:
  GapJoiner(const Context& context, PixelChains& chains, double gap)
      : context_(context), poll_(context), chains_(chains), gap_(gap) {}

  Status run(const EdgeMap& edges) {
    constexpr int kPasses = 3;
    SFUMATO_TRY(table_.create(context_, edges));
    for (int pass = 0; pass < kPasses; ++pass) {
      SFUMATO_TRY_ASSIGN(const bool is_joined, join_once());
      if (!is_joined) break;
    }
    return ok_status();
  }

 private:
  struct End {
    std::uint32_t chain;
    bool is_last;
    PixelPlace place;
  };
  struct Pair {
    std::uint32_t a, b;
    double distance;
  };

  /// Returns whether any were joined.
  Result<bool> join_once() {
    SFUMATO_TRY(list_ends());
    SFUMATO_TRY(list_pairs());
    SFUMATO_TRY(choose_pairs());
    if (pairs_.empty()) return false;
    SFUMATO_TRY(join_pairs());
    for (const End& end : ends_) table_.at(end.place) = -1;
    return true;
  }

  Status list_ends() {
    ends_.clear();
    SFUMATO_TRY(memory_.reserve(context_, ends_, 2 * chains_.size()));
    for (std::uint32_t i = 0; i < chains_.size(); ++i) {
      if (poll_.cancelled()) return context_.cancel_status();
      if (chains_[i].size() < 3 || is_loop(chains_[i])) continue;
      for (const bool is_last : {false, true}) {
        const PixelPlace place = end_of(chains_[i], is_last);
        if (table_.at(place) >= 0) continue;
        table_.at(place) = static_cast<std::int32_t>(ends_.size());
        ends_.push_back({i, is_last, place});
      }
    }
    return ok_status();
  }

  /// The nearest first.
  Status list_pairs() {
    pairs_.clear();
    const auto across = 2 * static_cast<std::size_t>(gap_) + 1;
    for (std::uint32_t i = 0; i < ends_.size(); ++i) {
      if (poll_.cancelled()) return context_.cancel_status();
      SFUMATO_TRY(memory_.make_room(context_, pairs_, across * across));
      table_.near(ends_[i].place, gap_, [&](PixelPlace q, std::int32_t other) {
        const auto j = static_cast<std::uint32_t>(other);
        if (j > i) pairs_.push_back({i, j, length(center(q) - center(ends_[i].place))});
      });
    }
    const auto rank = [this](const Pair& pair) {
      const PixelPlace b = ends_[pair.b].place;
      return std::tuple(pair.distance, pair.a, b.y, b.x);
    };
    return TableMemory::sort(context_, pairs_,
                             [rank](const Pair& p, const Pair& q) { return rank(p) < rank(q); });
  }

  /// Keeps the pairs to join, with each chain once.
  Status choose_pairs() {
    is_joined_.clear();
    SFUMATO_TRY(memory_.resize(context_, is_joined_, chains_.size()));
    std::size_t chosen = 0;
    for (const Pair& pair : pairs_) {
      if (poll_.cancelled()) return context_.cancel_status();
      const End &a = ends_[pair.a], &b = ends_[pair.b];
      if (a.chain == b.chain || is_joined_[a.chain] || is_joined_[b.chain] || !face(a, b)) continue;
      is_joined_[a.chain] = is_joined_[b.chain] = 1;
      pairs_[chosen++] = pair;
    }
    pairs_.resize(chosen);
    return ok_status();
  }

  /// Others keep their order, and stand first.
  Status join_pairs() {
    PixelChains joined;
    Status status = joined.memory.reserve(context_, joined.place, chains_.place.size());
    if (status) status = joined.memory.reserve(context_, joined.end, chains_.size());
    for (std::size_t i = 0; i < chains_.size() && status; ++i) {
      if (poll_.cancelled()) return context_.cancel_status();
      if (is_joined_[i]) continue;
      status = add(i, false, joined);
      joined.end_chain();
    }
    for (const Pair& pair : pairs_) {
      if (poll_.cancelled()) return context_.cancel_status();
      const End &a = ends_[pair.a], &b = ends_[pair.b];
      if (status) status = add(a.chain, !a.is_last, joined);
      if (status) status = add(b.chain, b.is_last, joined);
      joined.end_chain();
    }
    if (status) chains_ = std::move(joined);
    return status;
  }

  Status add(std::size_t chain, bool is_reversed, PixelChains& to) const {
    const PixelChain places = chains_[chain];
    SFUMATO_TRY(to.memory.append(context_, places, to.place));
    if (is_reversed) {
      std::reverse(to.place.end() - std::ssize(places), to.place.end());
    }
    return ok_status();
  }

  bool face(const End& a, const End& b) const {
    const Vec2 out_a = outwards(chains_[a.chain], a.is_last);
    const Vec2 out_b = outwards(chains_[b.chain], b.is_last);
    const Vec2 between = center(b.place) - center(a.place);
    const double far = length(between);
    return -dot(out_a, out_b) >= kFacing && (far <= 1.5 || dot(out_a, between) >= kFacing * far);
  }

  const Context& context_;
  RarePoll<64> poll_;
  PixelChains& chains_;
  PixelTable table_;
  double gap_;
  TableMemory memory_{"the edges of a picture"};
  std::vector<End> ends_;
  std::vector<Pair> pairs_;
  std::vector<std::uint8_t> is_joined_;  ///< per chain
};

/// Where pixels of chains are.
class EndSnapper {
 public:
  EndSnapper(const Context& context, const PixelChains& chains)
      : context_(context), chains_(chains) {}

  /// Errors: limit (memory), cancelled.
  Status list_places(const EdgeMap& edges) {
    SFUMATO_TRY(table_.create(context_, edges));
    SFUMATO_TRY(memory_.reserve(context_, places_, chains_.place.size()));
    for (std::uint32_t i = 0; i < chains_.size(); ++i) {
      if (context_.cancelled()) return context_.cancel_status();
      for (std::uint32_t j = 0; j < chains_[i].size(); ++j) {
        table_.at(chains_[i][j]) = static_cast<std::int32_t>(places_.size());
        places_.push_back({i, j});
      }
    }
    return ok_status();
  }

  /// Adds the chain with its ends run on, for which there is room.
  Status add_snapped(std::uint32_t i, double reach, PixelChains& to) {
    const PixelChain chain = chains_[i];
    constexpr std::size_t kLongLoopPixels = 12;
    const bool closes = chain.size() >= kLongLoopPixels &&
                        length(center(chain.front()) - center(chain.back())) <= reach;
    const std::optional<PixelPlace> first = closes ? std::nullopt : ahead(i, false, reach);
    const std::optional<PixelPlace> last = closes ? chain.front() : ahead(i, true, reach);
    if (first) to.place.push_back(*first);
    Status status = to.memory.append(context_, chain, to.place);
    if (status && last) to.place.push_back(*last);
    to.end_chain();
    return status;
  }

 private:
  struct Place {
    std::uint32_t chain, index;
  };

  std::optional<PixelPlace> ahead(std::uint32_t i, bool is_last, double reach) {
    const PixelChain chain = chains_[i];
    const PixelPlace end = end_of(chain, is_last);
    const Vec2 out = outwards(chain, is_last);
    const double own_index = is_last ? static_cast<double>(chain.size() - 1) : 0.0;
    std::optional<PixelPlace> best;
    double least = 0;
    table_.near(end, reach, [&](PixelPlace q, std::int32_t entry) {
      const Place& place = places_[static_cast<std::size_t>(entry)];
      if (place.chain == i && std::fabs(place.index - own_index) < 3 * reach + 4) return;
      const Vec2 way = center(q) - center(end);
      const double far = length(way);
      const double cosine = far > 0 ? dot(way, out) / far : 0.0;
      if (cosine < kFacing) return;
      const double cost = far * (1.5 - cosine);
      if (!best || cost < least) best = q, least = cost;
    });
    return best;
  }

  const Context& context_;
  const PixelChains& chains_;
  PixelTable table_;
  TableMemory memory_{"the edges of a picture"};
  std::vector<Place> places_;
};

}  // namespace

Result<PixelChains> pixel_chains(Context& context, const EdgeMap& edges) {
  return ChainWalker(context, edges).run();
}

Status join_gaps(const Context& context, PixelChains& chains, const EdgeMap& edges, double gap) {
  return GapJoiner(context, chains, gap).run(edges);
}

Status snap_ends(const Context& context, const EdgeMap& edges, const std::vector<double>& scales,
                 double base, double rise, PixelChains& chains) {
  EndSnapper snapper(context, chains);
  SFUMATO_TRY(snapper.list_places(edges));
  PixelChains snapped;
  const std::size_t most = chains.place.size() + 2 * chains.size();
  SFUMATO_TRY(snapped.memory.reserve(context, snapped.place, most));
  SFUMATO_TRY(snapped.memory.reserve(context, snapped.end, chains.size()));
  for (std::uint32_t i = 0; i < chains.size(); ++i) {
    if (context.cancelled()) return context.cancel_status();
    SFUMATO_TRY(snapper.add_snapped(i, base + rise * std::sqrt(scales[i]), snapped));
  }
  chains = std::move(snapped);
  return ok_status();
}

}  // namespace sfumato::tracing
