#include "trace/fit/bounded_solve.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>

#include "base/try.hpp"

namespace sfumato::tracing {
namespace {

constexpr int kSteps = 60;
/// How often unknowns outside their bounds are held and the rest is solved again.
constexpr int kRounds = 3;
/// Against weights of pixels that add up to some dozen for a stop.
constexpr float kTie = 300;

using FourDoubles = std::array<double, 4>;

class BoundedSolver {
 public:
  BoundedSolver(Context& context, const BoundedProblem& problem, std::span<FourFloats> x)
      : context_(context), problem_(problem), x_(x) {}

  Status run() {
    const std::size_t count = x_.size();
    SFUMATO_TRY(memory_.assign(context_, x_, start_));
    SFUMATO_TRY(memory_.resize(context_, is_free_, count, {1, 1, 1, 1}));
    SFUMATO_TRY(memory_.resize(context_, diagonal_, count));
    SFUMATO_TRY(memory_.resize_all(context_, count, residual_, direction_, image_, scaled_));
    find_diagonal();
    for (int round = 0; round < kRounds; ++round) {
      SFUMATO_TRY(descend());
      if (!hold_outside()) break;
    }
    return ok_status();
  }

 private:
  void find_diagonal() {
    const SparseMatrix& normal = problem_.normal;
    for (std::uint32_t i = 0; i < normal.row_count(); ++i) {
      float own = problem_.pull[i];
      for (std::uint32_t k = normal.begin[i]; k < normal.begin[i + 1]; ++k) {
        if (normal.column[k] == i) own += normal.value[k];
      }
      if (problem_.has_next[i]) own += problem_.even;
      if (i > 0 && problem_.has_next[i - 1]) own += problem_.even;
      diagonal_[i] = own;
    }
    for (const Tie& tie : problem_.ties) {
      diagonal_[tie.first] += kTie;
      diagonal_[tie.second] += kTie;
    }
  }

  /// image = (N + diag(pull) + even D) v.
  Status apply(std::span<const FourFloats> v) {
    SFUMATO_TRY(multiply(context_, problem_.normal, v, image_));
    for (std::size_t i = 0; i < v.size(); ++i) {
      for (std::size_t c = 0; c < 4; ++c) {
        image_[i][c] += problem_.pull[i] * v[i][c];
        if (!problem_.has_next[i]) continue;
        const float step = problem_.even * (v[i][c] - v[i + 1][c]);
        image_[i][c] += step;
        image_[i + 1][c] -= step;
      }
    }
    for (const auto& [first, second] : problem_.ties) {
      for (std::size_t c = 0; c < 4; ++c) {
        const float step = kTie * (v[first][c] - v[second][c]);
        image_[first][c] += step;
        image_[second][c] -= step;
      }
    }
    return ok_status();
  }

  /// Returns Σ a b over the free unknowns, per channel.
  FourDoubles inner(std::span<const FourFloats> a, std::span<const FourFloats> b) const {
    FourDoubles sum{};
    for (std::size_t i = 0; i < a.size(); ++i) {
      for (std::size_t c = 0; c < 4; ++c) sum[c] += double{a[i][c]} * b[i][c];
    }
    return sum;
  }

  void keep_free(std::span<FourFloats> v) const {
    for (std::size_t i = 0; i < v.size(); ++i) {
      for (std::size_t c = 0; c < 4; ++c) v[i][c] *= is_free_[i][c];
    }
  }

  void scale_residual() {
    for (std::size_t i = 0; i < x_.size(); ++i) {
      for (std::size_t c = 0; c < 4; ++c) scaled_[i][c] = residual_[i][c] / diagonal_[i];
    }
  }

  /// Runs conjugate gradients in all channels at once, over the free unknowns.
  Status descend() {
    SFUMATO_TRY(apply(x_));
    for (std::size_t i = 0; i < x_.size(); ++i) {
      for (std::size_t c = 0; c < 4; ++c) {
        residual_[i][c] =
            problem_.right_side[i][c] + problem_.pull[i] * start_[i][c] - image_[i][c];
      }
    }
    keep_free(residual_);
    scale_residual();
    direction_ = scaled_;
    FourDoubles slope = inner(residual_, scaled_);
    if (!first_) first_ = slope;
    for (int step = 0; step < kSteps; ++step) {
      bool is_done = true;
      for (std::size_t c = 0; c < 4; ++c) {
        is_done = is_done && slope[c] <= problem_.tolerance * problem_.tolerance * (*first_)[c];
      }
      if (is_done) break;
      SFUMATO_TRY(apply(direction_));
      keep_free(image_);
      const FourDoubles bend = inner(direction_, image_);
      FourFloats go{};
      for (std::size_t c = 0; c < 4; ++c) {
        go[c] = bend[c] > 0 ? static_cast<float>(slope[c] / bend[c]) : 0.0f;
      }
      for (std::size_t i = 0; i < x_.size(); ++i) {
        for (std::size_t c = 0; c < 4; ++c) {
          x_[i][c] += go[c] * direction_[i][c];
          residual_[i][c] -= go[c] * image_[i][c];
        }
      }
      scale_residual();
      const FourDoubles next = inner(residual_, scaled_);
      for (std::size_t i = 0; i < x_.size(); ++i) {
        for (std::size_t c = 0; c < 4; ++c) {
          const auto turn = static_cast<float>(slope[c] > 0 ? next[c] / slope[c] : 0.0);
          direction_[i][c] = scaled_[i][c] + turn * direction_[i][c];
        }
      }
      slope = next;
    }
    return ok_status();
  }

  /// Moves unknowns outside their bounds onto the bounds and holds them. Returns whether there were
  /// any.
  bool hold_outside() {
    bool any = false;
    for (std::size_t i = 0; i < x_.size(); ++i) {
      for (std::size_t c = 0; c < 4; ++c) {
        const float inside = std::clamp(x_[i][c], problem_.low[i][c], problem_.high[i][c]);
        if (inside == x_[i][c]) continue;
        x_[i][c] = inside;
        is_free_[i][c] = 0;
        any = true;
      }
    }
    return any;
  }

  Context& context_;
  const BoundedProblem& problem_;
  std::span<FourFloats> x_;
  TableMemory memory_{"the solution of a fit"};
  std::vector<FourFloats> start_;
  std::vector<FourFloats> is_free_;  ///< 1 or 0
  std::vector<float> diagonal_;
  std::vector<FourFloats> residual_, direction_, image_, scaled_;
  std::optional<FourDoubles> first_;  ///< the residual's square at the very first
};

}  // namespace

Status solve_bounded(Context& context, const BoundedProblem& problem, std::span<FourFloats> x) {
  return BoundedSolver(context, problem, x).run();
}

}  // namespace sfumato::tracing
