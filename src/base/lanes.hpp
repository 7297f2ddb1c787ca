#pragma once

#include <cstdint>

#include "base/lane_register.hpp"

#define SFUMATO_EACH(i) _Pragma("GCC unroll 16") for (int i = 0; i < K; ++i)

/// Numbers in lanes: a kernel is written once on Lanes<W, K> and runs as W lanes to a register, K
/// registers side by side (Lanes<1, 1> is a float). Every operation gives the same bits for every
/// W and K, instruction set and compiler: plain IEEE arithmetic, no fused multiply-add
/// (-ffp-contract=off), no estimates of the hardware.
///
/// A kernel that is compiled for several instruction sets stands in namespace SFUMATO_ISA too.
namespace sfumato::inline SFUMATO_ISA {

/// Truth values, one to a lane.
template <int W, int K = 1>
struct LaneMask {
  using Register = lane::Mask<W>;
  Register part[K];

  friend SFUMATO_INLINE LaneMask operator&(const LaneMask& a, const LaneMask& b) {
    LaneMask r;
    SFUMATO_EACH(i) r.part[i] = static_cast<Register>(a.part[i] & b.part[i]);
    return r;
  }
  friend SFUMATO_INLINE LaneMask operator|(const LaneMask& a, const LaneMask& b) {
    LaneMask r;
    SFUMATO_EACH(i) r.part[i] = static_cast<Register>(a.part[i] | b.part[i]);
    return r;
  }
  /// Returns a and not b.
  friend SFUMATO_INLINE LaneMask and_not(const LaneMask& a, const LaneMask& b) {
    LaneMask r;
    SFUMATO_EACH(i) r.part[i] = lane::and_not<W>(a.part[i], b.part[i]);
    return r;
  }
  /// Returns register i: lanes [W i, W i + W).
  SFUMATO_INLINE LaneMask<W> row(int i) const { return {{part[i]}}; }

  /// Returns a mask: lane i is bit i.
  SFUMATO_INLINE static LaneMask from_bits(std::uint32_t bits) {
    static_assert(W * K <= 32);
    LaneMask r;
    SFUMATO_EACH(i) r.part[i] = lane::mask_from_bits<W>(bits >> (i * W));
    return r;
  }
};

/// 32-bit integers, one to a lane. Sums and products wrap; unused lanes may hold any value. >>
/// keeps the sign.
template <int W, int K = 1>
struct IntLanes {
  using Register = lane::Int<W>;
  using Word = lane::Word<W>;

  Register part[K];

  IntLanes() = default;
  SFUMATO_INLINE IntLanes(std::int32_t x) { SFUMATO_EACH(i) part[i] = Register{} + x; }

  /// Loads W K integers in a row; any alignment.
  SFUMATO_INLINE static IntLanes load(const std::int32_t* source) {
    IntLanes r;
    __builtin_memcpy(r.part, source, sizeof(r.part));
    return r;
  }
  SFUMATO_INLINE void store(std::int32_t* target) const {
    __builtin_memcpy(target, part, sizeof(part));
  }

  friend SFUMATO_INLINE IntLanes operator+(const IntLanes& a, const IntLanes& b) {
    IntLanes r;
    SFUMATO_EACH(i) r.part[i] = (Register)((Word)a.part[i] + (Word)b.part[i]);
    return r;
  }
  friend SFUMATO_INLINE IntLanes operator-(const IntLanes& a, const IntLanes& b) {
    IntLanes r;
    SFUMATO_EACH(i) r.part[i] = (Register)((Word)a.part[i] - (Word)b.part[i]);
    return r;
  }
  friend SFUMATO_INLINE IntLanes operator*(const IntLanes& a, const IntLanes& b) {
    IntLanes r;
    SFUMATO_EACH(i) r.part[i] = (Register)((Word)a.part[i] * (Word)b.part[i]);
    return r;
  }
  friend SFUMATO_INLINE IntLanes operator&(const IntLanes& a, const IntLanes& b) {
    IntLanes r;
    SFUMATO_EACH(i) r.part[i] = a.part[i] & b.part[i];
    return r;
  }
  friend SFUMATO_INLINE IntLanes operator>>(const IntLanes& a, int count) {
    IntLanes r;
    SFUMATO_EACH(i) r.part[i] = a.part[i] >> count;
    return r;
  }
};

/// Single-precision numbers, one to a lane.
template <int W, int K = 1>
struct Lanes {
  using Register = lane::Float<W>;
  using Mask = LaneMask<W, K>;
  using Int = IntLanes<W, K>;
  static constexpr int kCount = W * K;

  Register part[K];

  Lanes() = default;
  /// Sets every lane to x. (x - 0 is x, also where x is -0.)
  SFUMATO_INLINE Lanes(float x) { SFUMATO_EACH(i) part[i] = x - Register{}; }

  /// Loads W K floats in a row; any alignment.
  SFUMATO_INLINE static Lanes load(const float* source) {
    Lanes r;
    __builtin_memcpy(r.part, source, sizeof(r.part));
    return r;
  }
  SFUMATO_INLINE void store(float* target) const { __builtin_memcpy(target, part, sizeof(part)); }

  /// Returns register i: lanes [W i, W i + W).
  SFUMATO_INLINE Lanes<W> row(int i) const {
    Lanes<W> r;
    r.part[0] = part[i];
    return r;
  }

  SFUMATO_INLINE float operator[](int lane) const {
    float all[kCount];
    store(all);
    return all[lane];
  }

  friend SFUMATO_INLINE Lanes operator+(const Lanes& a, const Lanes& b) {
    Lanes r;
    SFUMATO_EACH(i) r.part[i] = a.part[i] + b.part[i];
    return r;
  }
  friend SFUMATO_INLINE Lanes operator-(const Lanes& a, const Lanes& b) {
    Lanes r;
    SFUMATO_EACH(i) r.part[i] = a.part[i] - b.part[i];
    return r;
  }
  friend SFUMATO_INLINE Lanes operator*(const Lanes& a, const Lanes& b) {
    Lanes r;
    SFUMATO_EACH(i) r.part[i] = a.part[i] * b.part[i];
    return r;
  }
  friend SFUMATO_INLINE Lanes operator/(const Lanes& a, const Lanes& b) {
    Lanes r;
    SFUMATO_EACH(i) r.part[i] = a.part[i] / b.part[i];
    return r;
  }
  friend SFUMATO_INLINE Mask operator>(const Lanes& a, const Lanes& b) {
    Mask r;
    SFUMATO_EACH(i) r.part[i] = lane::greater<W>(a.part[i], b.part[i]);
    return r;
  }
  friend SFUMATO_INLINE Mask operator>=(const Lanes& a, const Lanes& b) {
    Mask r;
    SFUMATO_EACH(i) r.part[i] = lane::greater_equal<W>(a.part[i], b.part[i]);
    return r;
  }
  friend SFUMATO_INLINE Mask operator==(const Lanes& a, const Lanes& b) {
    Mask r;
    SFUMATO_EACH(i) r.part[i] = lane::equal<W>(a.part[i], b.part[i]);
    return r;
  }
  friend SFUMATO_INLINE Mask operator<(const Lanes& a, const Lanes& b) { return b > a; }
  friend SFUMATO_INLINE Mask operator<=(const Lanes& a, const Lanes& b) { return b >= a; }

  /// Returns, lane by lane: mask ? a : b.
  friend SFUMATO_INLINE Lanes select(const Mask& mask, const Lanes& a, const Lanes& b) {
    Lanes r;
    SFUMATO_EACH(i) r.part[i] = lane::select<W>(mask.part[i], a.part[i], b.part[i]);
    return r;
  }
  /// Returns mask ? a : 0.
  friend SFUMATO_INLINE Lanes zero_unless(const Mask& mask, const Lanes& a) {
    Lanes r;
    SFUMATO_EACH(i) r.part[i] = lane::zero_unless<W>(mask.part[i], a.part[i]);
    return r;
  }
  /// Returns a < b ? a : b, hence b where either is not a number.
  friend SFUMATO_INLINE Lanes min(const Lanes& a, const Lanes& b) {
    Lanes r;
    SFUMATO_EACH(i) r.part[i] = lane::min<W>(a.part[i], b.part[i]);
    return r;
  }
  /// Returns a > b ? a : b, hence b where either is not a number.
  friend SFUMATO_INLINE Lanes max(const Lanes& a, const Lanes& b) {
    Lanes r;
    SFUMATO_EACH(i) r.part[i] = lane::max<W>(a.part[i], b.part[i]);
    return r;
  }
  /// Returns the correctly rounded square root.
  friend SFUMATO_INLINE Lanes sqrt(const Lanes& a) {
    Lanes r;
    SFUMATO_EACH(i) r.part[i] = lane::sqrt<W>(a.part[i]);
    return r;
  }
};

/// Returns the bits of a float as an integer; as_float() does the reverse.
template <int W, int K>
SFUMATO_INLINE IntLanes<W, K> as_int(const Lanes<W, K>& a) {
  IntLanes<W, K> r;
  __builtin_memcpy(r.part, a.part, sizeof(r.part));
  return r;
}
template <int W, int K>
SFUMATO_INLINE Lanes<W, K> as_float(const IntLanes<W, K>& a) {
  Lanes<W, K> r;
  __builtin_memcpy(r.part, a.part, sizeof(r.part));
  return r;
}

template <int W, int K>
SFUMATO_INLINE Lanes<W, K> abs(const Lanes<W, K>& a) {
  return as_float(as_int(a) & IntLanes<W, K>(0x7fffffff));
}

/// Towards zero. Precondition: |a| < 2^31 in every lane.
template <int W, int K>
SFUMATO_INLINE IntLanes<W, K> to_int(const Lanes<W, K>& a) {
  IntLanes<W, K> r;
  SFUMATO_EACH(i) r.part[i] = lane::to_int<W>(a.part[i]);
  return r;
}
template <int W, int K>
SFUMATO_INLINE Lanes<W, K> to_float(const IntLanes<W, K>& a) {
  Lanes<W, K> r;
  SFUMATO_EACH(i) r.part[i] = lane::to_float<W>(a.part[i]);
  return r;
}

/// Returns 1/a with a relative error of at most 2e-6, for |a| from 1e-37 to 1e37: a seed from the
/// exponent (error 5 %), a balanced quadratic step (0.15 %) and a Newton step. Constants are scaled
/// so that neither step multiplies by one. For other a the result is some number or infinity, the
/// same in every width.
template <int W, int K>
SFUMATO_INLINE Lanes<W, K> reciprocal(const Lanes<W, K>& a) {
  using F = Lanes<W, K>;
  F y = as_float(IntLanes<W, K>(0x7EF338D3) - as_int(a));
  y = y * (F(2.00128007f) - a * y);
  return y * (F(2.00000072f) - a * y);
}

/// Returns 1/sqrt(a) with a relative error of at most 5e-7, for a from 1e-37 to 1e37; computed like
/// `reciprocal`.
template <int W, int K>
SFUMATO_INLINE Lanes<W, K> reciprocal_sqrt(const Lanes<W, K>& a) {
  using F = Lanes<W, K>;
  F y = as_float(IntLanes<W, K>(0x5F1FFFF9) - (as_int(a) >> 1));
  y = y * (F(1.33492804f) - F(0.558729529f) * (a * (y * y)));
  return y * (F(1.88988197f) - a * (y * y));
}

/// Returns the mask as bits: bit i is lane i.
template <int W, int K>
SFUMATO_INLINE std::uint32_t mask_bits(const LaneMask<W, K>& mask) {
  static_assert(W * K <= 32);
  std::uint32_t bits = 0;
  SFUMATO_EACH(i) bits |= lane::mask_bits<W>(mask.part[i]) << (i * W);
  return bits;
}

template <int W, int K>
SFUMATO_INLINE bool any(const LaneMask<W, K>& mask) {
  lane::Mask<W> joined = mask.part[0];
  for (int i = 1; i < K; ++i) joined = static_cast<lane::Mask<W>>(joined | mask.part[i]);
  return lane::mask_bits<W>(joined) != 0;
}

template <int W, int K>
SFUMATO_INLINE bool all(const LaneMask<W, K>& mask) {
  lane::Mask<W> joined = mask.part[0];
  for (int i = 1; i < K; ++i) joined = static_cast<lane::Mask<W>>(joined & mask.part[i]);
  return lane::mask_bits<W>(joined) == (1u << W) - 1;
}

}  // namespace sfumato::inline SFUMATO_ISA
