#pragma once

#include <cstdint>

#include "base/inline.hpp"

#if defined(__SSE2__)
#include <immintrin.h>
#elif defined(__wasm_simd128__)
#include <wasm_simd128.h>
#endif

/// The namespace of code that is compiled once for each instruction set, so that the linker never
/// mixes the copies; and the lanes of its registers.
#if defined(__AVX512F__)
#define SFUMATO_ISA isa_avx512
#define SFUMATO_ISA_LANES 16
#elif defined(__AVX2__)
#define SFUMATO_ISA isa_avx2
#define SFUMATO_ISA_LANES 8
#else
#define SFUMATO_ISA isa_base
#define SFUMATO_ISA_LANES 4
#endif

/// One register of W lanes, on which base/lanes.hpp is built. This is the only place of the project
/// that contains intrinsics. They are used where compilers generate poor code from vector types;
/// each gives the bits of the plain expression beside it.
namespace sfumato::inline SFUMATO_ISA::lane {

template <int W>
struct Register {
  typedef float Float __attribute__((vector_size(4 * W)));
  typedef std::int32_t Int __attribute__((vector_size(4 * W)));
  typedef std::uint32_t Word __attribute__((vector_size(4 * W)));
  using Mask = Int;  ///< all bits of a lane set, or none
};

template <>
struct Register<1> {
  using Float = float;
  using Int = std::int32_t;
  using Word = std::uint32_t;
  using Mask = bool;
};

/// Whether a mask of W lanes is a word of bits.
template <int W>
inline constexpr bool kMaskIsBits = W == 1;

#if defined(__AVX512F__)
template <>
struct Register<16> {
  typedef float Float __attribute__((vector_size(64)));
  typedef std::int32_t Int __attribute__((vector_size(64)));
  typedef std::uint32_t Word __attribute__((vector_size(64)));
  using Mask = __mmask16;
};
template <>
inline constexpr bool kMaskIsBits<16> = true;
inline constexpr __mmask16 kAll16 = 0xffff;
#endif

template <int W>
using Float = typename Register<W>::Float;
template <int W>
using Int = typename Register<W>::Int;
template <int W>
using Word = typename Register<W>::Word;
template <int W>
using Mask = typename Register<W>::Mask;

template <int W>
SFUMATO_INLINE Mask<W> greater(Float<W> a, Float<W> b) {
#if defined(__AVX512F__)
  if constexpr (W == 16)
    return _mm512_cmp_ps_mask(a, b, _CMP_GT_OQ);
  else
#endif
    return a > b;
}

template <int W>
SFUMATO_INLINE Mask<W> greater_equal(Float<W> a, Float<W> b) {
#if defined(__AVX512F__)
  if constexpr (W == 16)
    return _mm512_cmp_ps_mask(a, b, _CMP_GE_OQ);
  else
#endif
    return a >= b;
}

template <int W>
SFUMATO_INLINE Mask<W> equal(Float<W> a, Float<W> b) {
#if defined(__AVX512F__)
  if constexpr (W == 16)
    return _mm512_cmp_ps_mask(a, b, _CMP_EQ_OQ);
  else
#endif
    return a == b;
}

template <int W>
SFUMATO_INLINE Mask<W> and_not(Mask<W> a, Mask<W> b) {
  if constexpr (W == 1)
    return a && !b;
  else
    return static_cast<Mask<W>>(a & ~b);
}

template <int W>
SFUMATO_INLINE Float<W> select(Mask<W> mask, Float<W> a, Float<W> b) {
#if defined(__AVX512F__)
  if constexpr (W == 16)
    return _mm512_mask_blend_ps(mask, b, a);
  else
#endif
#if defined(__AVX__)
      if constexpr (W == 8)
    return _mm256_blendv_ps(b, a, (__m256)mask);
  else
#endif
      if constexpr (W == 1)
    return mask ? a : b;
  else
    return (Float<W>)(((Int<W>)a & mask) | ((Int<W>)b & ~mask));
}

template <int W>
SFUMATO_INLINE Float<W> zero_unless(Mask<W> mask, Float<W> a) {
#if defined(__AVX512F__)
  if constexpr (W == 16)
    return _mm512_maskz_mov_ps(mask, a);
  else
#endif
      if constexpr (W == 1)
    return mask ? a : 0.0f;
  else
    return (Float<W>)((Int<W>)a & mask);
}

/// Returns a < b ? a : b.
template <int W>
SFUMATO_INLINE Float<W> min(Float<W> a, Float<W> b) {
#if defined(__AVX512F__)
  if constexpr (W == 16)
    return _mm512_maskz_min_ps(kAll16, a, b);
  else
#endif
#if defined(__AVX__)
      if constexpr (W == 8)
    return _mm256_min_ps(a, b);
  else
#endif
#if defined(__SSE2__)
      if constexpr (W == 4)
    return _mm_min_ps(a, b);
  else
#elif defined(__wasm_simd128__)
  if constexpr (W == 4)
    return (Float<W>)wasm_f32x4_pmin((v128_t)b, (v128_t)a);
  else
#endif
    return select<W>(greater<W>(b, a), a, b);
}

/// Returns a > b ? a : b.
template <int W>
SFUMATO_INLINE Float<W> max(Float<W> a, Float<W> b) {
#if defined(__AVX512F__)
  if constexpr (W == 16)
    return _mm512_maskz_max_ps(kAll16, a, b);
  else
#endif
#if defined(__AVX__)
      if constexpr (W == 8)
    return _mm256_max_ps(a, b);
  else
#endif
#if defined(__SSE2__)
      if constexpr (W == 4)
    return _mm_max_ps(a, b);
  else
#elif defined(__wasm_simd128__)
  if constexpr (W == 4)
    return (Float<W>)wasm_f32x4_pmax((v128_t)b, (v128_t)a);
  else
#endif
    return select<W>(greater<W>(a, b), a, b);
}

template <int W>
SFUMATO_INLINE Float<W> sqrt(Float<W> a) {
#if defined(__AVX512F__)
  if constexpr (W == 16)
    return _mm512_maskz_sqrt_ps(kAll16, a);
  else
#endif
#if defined(__AVX__)
      if constexpr (W == 8)
    return _mm256_sqrt_ps(a);
  else
#endif
#if defined(__SSE2__)
      if constexpr (W == 4)
    return _mm_sqrt_ps(a);
  else
#elif defined(__wasm_simd128__)
  if constexpr (W == 4)
    return (Float<W>)wasm_f32x4_sqrt((v128_t)a);
  else
#endif
      if constexpr (W == 1)
    return __builtin_sqrtf(a);
  else {
    for (int i = 0; i < W; ++i) a[i] = __builtin_sqrtf(a[i]);
    return a;
  }
}

template <int W>
SFUMATO_INLINE Int<W> to_int(Float<W> a) {
  if constexpr (W == 1)
    return static_cast<std::int32_t>(a);
  else
    return __builtin_convertvector(a, Int<W>);
}

template <int W>
SFUMATO_INLINE Float<W> to_float(Int<W> a) {
  if constexpr (W == 1)
    return static_cast<float>(a);
  else
    return __builtin_convertvector(a, Float<W>);
}

/// Returns the lanes as bits: bit i of the result is lane i.
template <int W>
SFUMATO_INLINE std::uint32_t mask_bits(Mask<W> mask) {
#if defined(__AVX__)
  if constexpr (W == 8)
    return static_cast<std::uint32_t>(_mm256_movemask_ps((__m256)mask));
  else
#endif
#if defined(__SSE2__)
      if constexpr (W == 4)
    return static_cast<std::uint32_t>(_mm_movemask_ps((__m128)mask));
  else
#elif defined(__wasm_simd128__)
  if constexpr (W == 4)
    return wasm_i32x4_bitmask((v128_t)mask);
  else
#endif
      if constexpr (kMaskIsBits<W>)
    return mask;
  else {
    std::uint32_t bits = 0;
    for (int i = 0; i < W; ++i) bits |= static_cast<std::uint32_t>(mask[i] & 1) << i;
    return bits;
  }
}

/// Returns a mask: lane i is bit i; higher bits are ignored.
template <int W>
SFUMATO_INLINE Mask<W> mask_from_bits(std::uint32_t bits) {
  if constexpr (W == 1)
    return (bits & 1) != 0;
  else if constexpr (kMaskIsBits<W>)
    return static_cast<Mask<W>>(bits);
  else {
    Int<W> lane_bit{};
    for (int i = 0; i < W; ++i) lane_bit[i] = 1 << i;
    return (lane_bit & static_cast<std::int32_t>(bits)) != 0;
  }
}

}  // namespace sfumato::inline SFUMATO_ISA::lane
