// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Four floats at once, on the compiler's portable vector types. Arithmetic and comparisons are the built-in
// operators (a comparison gives an Int4 of 0 or -1 per lane). Only this header and float8.h have intrinsics;
// where the processor has no SSE2, plain loops do the same.

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
typedef std::uint32_t Unsigned4 __attribute__((vector_size(16)));
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
/// The three floats at \p p and 0.
inline Float4 LoadThree(const void* p)
{
    const auto* bytes = static_cast<const unsigned char*>(p);
    double xy;
    float z;
    std::memcpy(&xy, bytes, sizeof xy);
    std::memcpy(&z, bytes + sizeof xy, sizeof z);
    return _mm_movelh_ps(_mm_castpd_ps(_mm_set_sd(xy)), _mm_set_ss(z));
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
inline Float4 LoadThree(const void* p)
{
    float xyz[3];
    std::memcpy(xyz, p, sizeof xyz);
    return Float4{xyz[0], xyz[1], xyz[2], 0};
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
inline void Transpose(Float4& a, Float4& b, Float4& c, Float4& d)
{
    const Float4 r0 = a, r1 = b, r2 = c, r3 = d;
    a = Float4{r0[0], r1[0], r2[0], r3[0]};
    b = Float4{r0[1], r1[1], r2[1], r3[1]};
    c = Float4{r0[2], r1[2], r2[2], r3[2]};
    d = Float4{r0[3], r1[3], r2[3], r3[3]};
}
#endif

// What follows is what kernels need that are templates on the number: on float or double, Float4 or Float8.

/// Of Float4 or Float8.
template <class Real>
constexpr std::size_t kLanesOf = sizeof(Real) / sizeof(float);

/// \p x in every lane; of float and double, the number itself.
template <class Real>
[[gnu::always_inline]] inline Real Broadcast(float x)
{
    return x;
}
template <>
[[gnu::always_inline]] inline Float4 Broadcast<Float4>(float x)
{
    return Splat(x);
}
inline float Min(float a, float b)
{
    return a < b ? a : b;
}
inline double Min(double a, double b)
{
    return a < b ? a : b;
}
inline float Max(float a, float b)
{
    return a > b ? a : b;
}
inline double Max(double a, double b)
{
    return a > b ? a : b;
}
inline float Sqrt(float a)
{
    return std::sqrt(a);
}
inline double Sqrt(double a)
{
    return std::sqrt(a);
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

/// The integers as wide as a Real. \tparam Real Float4 or Float8
template <class Real>
struct IntegersLike;
template <>
struct IntegersLike<Float4> {
    using Int = Int4;
    using Unsigned = Unsigned4;
};
template <class Real>
using IntLike = typename IntegersLike<Real>::Int;
template <class Real>
using UnsignedLike = typename IntegersLike<Real>::Unsigned;

/// As numbers, not as bits. \pre below 2^31
inline Float4 ToFloats(Unsigned4 integers)
{
    return __builtin_convertvector(reinterpret_cast<Int4>(integers), Float4);
}
/// \p a becomes NaN in the lanes of \p mask.
inline void MakeNan(Float4& a, Int4 mask)
{
    a = Floats(Bits(a) | mask);
}
/// As many triples as lanes, their first, second and third members.
inline void LoadTriples(const std::uint32_t* p, Unsigned4& first, Unsigned4& second, Unsigned4& third)
{
    first = Unsigned4{p[0], p[3], p[6], p[9]};
    second = Unsigned4{p[1], p[4], p[7], p[10]};
    third = Unsigned4{p[2], p[5], p[8], p[11]};
}
/// 2^k for every byte k below 8.
inline Unsigned4 PowersOfTwo(Unsigned4 bytes)
{
    const Unsigned4 one = Unsigned4{} + 0x01010101u;
    const Unsigned4 two = bytes >> 1 & one, four = bytes >> 2 & one;
    const Unsigned4 byFour = (two << 8) - two, bySixteen = (four << 8) - four; // 0 or 255
    Unsigned4 power = one + (bytes & one);
    power = (power & ~byFour) | (power << 2 & byFour);
    return (power & ~bySixteen) | (power << 4 & bySixteen);
}
/// low[0], high[0], low[1], high[1], ...
inline void StoreInterleaved(std::uint32_t* p, Unsigned4 low, Unsigned4 high)
{
    const Unsigned4 first{low[0], high[0], low[1], high[1]}, second{low[2], high[2], low[3], high[3]};
    std::memcpy(p, &first, sizeof first);
    std::memcpy(p + kLanes, &second, sizeof second);
}
/// The first three members of the rows, by column.
inline void ToColumns(const Float4* rows, Float4& x, Float4& y, Float4& z)
{
    Float4 rest = rows[3];
    x = rows[0];
    y = rows[1];
    z = rows[2];
    Transpose(x, y, z, rest);
}
/// Eight columns as rows of eight floats.
inline void StoreRows(float (*rows)[8], const Float4* columns)
{
    for (std::size_t half = 0; half < 2; ++half) {
        const Float4* c = columns + 4 * half;
        StoreTransposed(rows[0] + 4 * half, rows[1] + 4 * half, rows[2] + 4 * half, rows[3] + 4 * half, c[0],
                        c[1], c[2], c[3]);
    }
}
/// Adds a row of eight floats. \tparam Real to work with: the sums are the same
template <class Real>
void AddRow(float* sums, const float* row);
template <>
inline void AddRow<Float4>(float* sums, const float* row)
{
    for (std::size_t half = 0; half < 8; half += kLanes)
        StoreUnaligned(sums + half, LoadUnaligned(sums + half) + Load(row + half));
}

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

} // namespace vcg_ext
