// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Four floats at once, on the compiler's portable vector types. Arithmetic and comparisons are the built-in
// operators (a comparison gives an Int4 of 0 or -1 per lane). This is the only header with intrinsics; where
// the processor has no SSE2 plain loops do the same. Eight at once, where the processor has AVX2, are for
// kernels whose lanes never meet: a sum over lanes would have another order, and the bytes of a result would
// depend on the processor.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace vcg_ext
{

typedef float Float4 __attribute__((vector_size(16)));
typedef std::int32_t Int4 __attribute__((vector_size(16)));
typedef double Double2 __attribute__((vector_size(16)));

constexpr int kLanes = 4;

inline Float4 Splat(float x)
{
    return Float4{x, x, x, x};
}
inline Int4 Splat(std::int32_t x)
{
    return Int4{x, x, x, x};
}
inline Int4 Bits(Float4 a)
{
    return reinterpret_cast<Int4>(a);
}
inline Float4 Floats(Int4 a)
{
    return reinterpret_cast<Float4>(a);
}
/// Per lane: \p yes where the mask is -1, \p no where it is 0.
inline Float4 Select(Int4 mask, Float4 yes, Float4 no)
{
    return Floats((mask & Bits(yes)) | (~mask & Bits(no)));
}
inline Int4 Select(Int4 mask, Int4 yes, Int4 no)
{
    return (mask & yes) | (~mask & no);
}

#if defined(__SSE2__)
/// Rounded to single precision.
inline Float4 Narrow(Double2 xy, Double2 zw)
{
    return _mm_movelh_ps(_mm_cvtpd_ps(xy), _mm_cvtpd_ps(zw));
}
/// \pre 16-byte aligned
inline Float4 Load(const float* p)
{
    return _mm_load_ps(p);
}
inline Float4 LoadUnaligned(const float* p)
{
    return _mm_loadu_ps(p);
}
/// \pre 16-byte aligned
inline void Store(float* p, Float4 a)
{
    _mm_store_ps(p, a);
}
inline void StoreUnaligned(float* p, Float4 a)
{
    _mm_storeu_ps(p, a);
}
inline Float4 Min(Float4 a, Float4 b)
{
    return _mm_min_ps(a, b);
}
inline Float4 Max(Float4 a, Float4 b)
{
    return _mm_max_ps(a, b);
}
inline Float4 Sqrt(Float4 a)
{
    return _mm_sqrt_ps(a);
}
/// Bit i is set where lane i of the mask is.
inline int LaneBits(Int4 mask)
{
    return _mm_movemask_ps(Floats(mask));
}
/// \p a with the first lane of \p b.
inline Float4 FirstOfOther(Float4 a, Float4 b)
{
    return _mm_move_ss(a, b);
}
/// Rows become columns.
inline void Transpose(Float4& a, Float4& b, Float4& c, Float4& d)
{
    __m128 r0 = a, r1 = b, r2 = c, r3 = d;
    _MM_TRANSPOSE4_PS(r0, r1, r2, r3);
    a = r0;
    b = r1;
    c = r2;
    d = r3;
}
#else
inline Float4 Narrow(Double2 xy, Double2 zw)
{
    return Float4{static_cast<float>(xy[0]), static_cast<float>(xy[1]), static_cast<float>(zw[0]),
                  static_cast<float>(zw[1])};
}
inline Float4 LoadUnaligned(const float* p)
{
    return Float4{p[0], p[1], p[2], p[3]};
}
inline Float4 Load(const float* p)
{
    return LoadUnaligned(p);
}
inline void StoreUnaligned(float* p, Float4 a)
{
    for (int i = 0; i < kLanes; ++i) p[i] = a[i];
}
inline void Store(float* p, Float4 a)
{
    StoreUnaligned(p, a);
}
inline Float4 Min(Float4 a, Float4 b)
{
    return Select(a < b, a, b);
}
inline Float4 Max(Float4 a, Float4 b)
{
    return Select(a > b, a, b);
}
inline Float4 Sqrt(Float4 a)
{
    return Float4{std::sqrt(a[0]), std::sqrt(a[1]), std::sqrt(a[2]), std::sqrt(a[3])};
}
inline int LaneBits(Int4 mask)
{
    return (mask[0] & 1) | (mask[1] & 2) | (mask[2] & 4) | (mask[3] & 8);
}
inline Float4 FirstOfOther(Float4 a, Float4 b)
{
    return Float4{b[0], a[1], a[2], a[3]};
}
inline void Transpose(Float4& a, Float4& b, Float4& c, Float4& d)
{
    const Float4 r0 = a, r1 = b, r2 = c, r3 = d;
    a = Float4{r0[0], r1[0], r2[0], r3[0]};
    b = Float4{r0[1], r1[1], r2[1], r3[1]};
    c = Float4{r0[2], r1[2], r2[2], r3[2]};
    d = Float4{r0[3], r1[3], r2[3], r3[3]};
}
#endif

/// Of Float4 or Float8.
template <class Real>
constexpr std::size_t kLanesOf = sizeof(Real) / sizeof(float);

/// \p x in every lane. \tparam Real Float4 or Float8
template <class Real>
Real Broadcast(float x);
template <>
inline Float4 Broadcast<Float4>(float x)
{
    return Splat(x);
}
/// Four floats of each row, transposed: as many rows as \p a has lanes. \pre 16-byte aligned
inline void LoadRows(const float* const* rows, int place, Float4& a, Float4& b, Float4& c, Float4& d)
{
    a = Load(rows[0] + place);
    b = Load(rows[1] + place);
    c = Load(rows[2] + place);
    d = Load(rows[3] + place);
    Transpose(a, b, c, d);
}

#if defined(__x86_64__) && defined(__GNUC__) && __GNUC__ >= 12 && !defined(__clang__)
#define VCG_EXT_HAS_FLOAT8
/// For the functions that work on Float8, and for them alone: they may be called where HasAvx2().
#define VCG_EXT_FOR_AVX2 [[gnu::target("avx2"), gnu::flatten]]
#pragma GCC diagnostic ignored "-Wpsabi" // no call passes a Float8, as all of them are inlined

typedef float Float8 __attribute__((vector_size(32)));
typedef std::int32_t Int8 __attribute__((vector_size(32)));

inline bool HasAvx2()
{
    return __builtin_cpu_supports("avx2") != 0;
}
template <>
[[gnu::always_inline]] inline Float8 Broadcast<Float8>(float x)
{
    return Float8{x, x, x, x, x, x, x, x};
}
/// As Max of Float4: \p b where they do not compare.
[[gnu::always_inline]] inline Float8 Max(const Float8& a, const Float8& b)
{
    return a > b ? a : b;
}
[[gnu::always_inline]] inline void LoadRows(const float* const* rows, int place, Float8& a, Float8& b,
                                            Float8& c, Float8& d)
{
    const auto join = [&](int i) __attribute__((always_inline))
    {
        return __builtin_shufflevector(Load(rows[i] + place), Load(rows[i + 4] + place), 0, 1, 2, 3, 4, 5, 6,
                                       7);
    };
    const Float8 r0 = join(0), r1 = join(1), r2 = join(2), r3 = join(3);
    const Int8 low{0, 8, 1, 9, 4, 12, 5, 13}, high{2, 10, 3, 11, 6, 14, 7, 15};
    const Int8 first{0, 1, 8, 9, 4, 5, 12, 13}, second{2, 3, 10, 11, 6, 7, 14, 15};
    const Float8 low01 = __builtin_shuffle(r0, r1, low), high01 = __builtin_shuffle(r0, r1, high);
    const Float8 low23 = __builtin_shuffle(r2, r3, low), high23 = __builtin_shuffle(r2, r3, high);
    a = __builtin_shuffle(low01, low23, first);
    b = __builtin_shuffle(low01, low23, second);
    c = __builtin_shuffle(high01, high23, first);
    d = __builtin_shuffle(high01, high23, second);
}
#else
inline bool HasAvx2()
{
    return false;
}
#endif

/// Starts to bring the line of \p p into the cache.
inline void Prefetch(const void* p)
{
    __builtin_prefetch(p);
    asm volatile(""); // or GCC sees no effect in a function that only prefetches, and drops its calls
}

inline bool AnyLane(Int4 mask)
{
    return LaneBits(mask) != 0;
}
inline bool AllLanes(Int4 mask)
{
    return LaneBits(mask) == 15;
}
/// The sum in one fixed order.
inline float SumLanes(Float4 a)
{
    return (a[0] + a[1]) + (a[2] + a[3]);
}
inline float MinLane(Float4 a)
{
    return std::min(std::min(a[0], a[1]), std::min(a[2], a[3]));
}
inline float MaxLane(Float4 a)
{
    return std::max(std::max(a[0], a[1]), std::max(a[2], a[3]));
}
/// -1 in the first \p count lanes, 0 in the others.
inline Int4 FirstLanes(int count)
{
    return Int4{0, 1, 2, 3} < Splat(std::int32_t{count});
}
/// 1 in the first \p count lanes, 0 in the others.
inline Float4 LaneWeights(std::uint32_t count)
{
    return Select(FirstLanes(count > 4 ? 4 : static_cast<int>(count)), Splat(1.0f), Splat(0.0f));
}
/// Four integers from anywhere.
inline Int4 LoadIntegers(const std::uint32_t* p)
{
    Int4 integers;
    std::memcpy(&integers, p, sizeof integers);
    return integers;
}
/// Four points of {x, y, z, payload} as three coordinate vectors and one of payloads.
inline void LoadTransposed(const float* p0, const float* p1, const float* p2, const float* p3, Float4& x,
                           Float4& y, Float4& z, Float4& payload)
{
    x = Load(p0);
    y = Load(p1);
    z = Load(p2);
    payload = Load(p3);
    Transpose(x, y, z, payload);
}
/// The columns {a, b, c, d} as four rows. \pre 16-byte aligned
inline void StoreTransposed(float* p0, float* p1, float* p2, float* p3, Float4 a, Float4 b, Float4 c,
                            Float4 d)
{
    Transpose(a, b, c, d);
    Store(p0, a);
    Store(p1, b);
    Store(p2, c);
    Store(p3, d);
}

} // namespace vcg_ext
