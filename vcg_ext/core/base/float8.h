// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Eight floats at once, where the processor has AVX2. For kernels whose lanes never meet: a sum over lanes
// would have another order than that of four, and the bytes of a result would depend on the processor.

#include <cstdint>
#include <cstring>

#include "vcg_ext/core/base/float4.h"

#if defined(__x86_64__) && defined(__GNUC__) && __GNUC__ >= 12 && !defined(__clang__)
#define VCG_EXT_HAS_FLOAT8
#include <immintrin.h>
#endif

namespace vcg_ext
{

#ifdef VCG_EXT_HAS_FLOAT8
/// For the functions that work on Float8, and for them alone: they may be called where HasAvx2().
#define VCG_EXT_FOR_AVX2 [[gnu::target("avx2"), gnu::flatten]]

inline bool HasAvx2()
{
    return __builtin_cpu_supports("avx2") != 0;
}

/// Eight numbers. A class whose copy is not trivial, so that it is passed by address: as a bare vector it
/// would be passed in a register that not every processor has, and GCC warns of that though all calls are
/// inlined.
template <class Number>
struct Eight {
    typedef Number Lanes __attribute__((vector_size(32)));
    Lanes lanes;

    Eight() = default;
    [[gnu::always_inline]] Eight(Number x) : lanes{x, x, x, x, x, x, x, x} {}
    [[gnu::always_inline]] explicit Eight(const Lanes& other) : lanes(other) {}
    [[gnu::always_inline]] Eight(const Eight& other) : lanes(other.lanes) {}
    Eight& operator=(const Eight&) = default;

    [[gnu::always_inline]] friend Eight operator+(const Eight& a, const Eight& b)
    {
        return Eight(a.lanes + b.lanes);
    }
    [[gnu::always_inline]] friend Eight operator-(const Eight& a, const Eight& b)
    {
        return Eight(a.lanes - b.lanes);
    }
    [[gnu::always_inline]] friend Eight operator*(const Eight& a, const Eight& b)
    {
        return Eight(a.lanes * b.lanes);
    }
    [[gnu::always_inline]] friend Eight operator/(const Eight& a, const Eight& b)
    {
        return Eight(a.lanes / b.lanes);
    }
    [[gnu::always_inline]] friend Eight operator&(const Eight& a, const Eight& b)
    {
        return Eight(a.lanes & b.lanes);
    }
    [[gnu::always_inline]] friend Eight operator|(const Eight& a, const Eight& b)
    {
        return Eight(a.lanes | b.lanes);
    }
    [[gnu::always_inline]] friend Eight operator>>(const Eight& a, int bits)
    {
        return Eight(a.lanes >> bits);
    }
    [[gnu::always_inline]] Eight operator~() const { return Eight(~lanes); }
    [[gnu::always_inline]] void operator*=(const Eight& a) { lanes *= a.lanes; }
    [[gnu::always_inline]] void operator^=(const Eight& a) { lanes ^= a.lanes; }

    // -1 in the lanes where it is so, 0 in the others
    [[gnu::always_inline]] friend Eight<std::int32_t> operator<(const Eight& a, const Eight& b)
    {
        return Eight<std::int32_t>(a.lanes < b.lanes);
    }
    [[gnu::always_inline]] friend Eight<std::int32_t> operator>(const Eight& a, const Eight& b)
    {
        return Eight<std::int32_t>(a.lanes > b.lanes);
    }
    [[gnu::always_inline]] friend Eight<std::int32_t> operator==(const Eight& a, const Eight& b)
    {
        return Eight<std::int32_t>(a.lanes == b.lanes);
    }
};
using Float8 = Eight<float>;
using Int8 = Eight<std::int32_t>;
using Unsigned8 = Eight<std::uint32_t>;

template <>
struct IntegersLike<Float8> {
    using Int = Int8;
    using Unsigned = Unsigned8;
};

template <>
[[gnu::always_inline]] inline Float8 Broadcast<Float8>(float x)
{
    return x;
}
/// As Max of Float4: \p b where they do not compare.
[[gnu::always_inline]] inline Float8 Max(const Float8& a, const Float8& b)
{
    return Float8(a.lanes > b.lanes ? a.lanes : b.lanes);
}
[[gnu::target("avx2")]] inline Float8 Sqrt(const Float8& a)
{
    return Float8(_mm256_sqrt_ps(a.lanes));
}
[[gnu::target("avx2")]] inline bool AnyLane(const Int8& mask)
{
    const auto bits = reinterpret_cast<__m256i>(mask.lanes);
    return !_mm256_testz_si256(bits, bits);
}
[[gnu::always_inline]] inline Float8 Select(const Int8& mask, const Float8& yes, const Float8& no)
{
    return Float8(mask.lanes ? yes.lanes : no.lanes);
}
[[gnu::always_inline]] inline Float8 ToFloats(const Unsigned8& integers)
{
    return Float8(__builtin_convertvector(reinterpret_cast<Int8::Lanes>(integers.lanes), Float8::Lanes));
}
[[gnu::always_inline]] inline void MakeNan(Float8& a, const Int8& mask)
{
    a.lanes = reinterpret_cast<Float8::Lanes>(reinterpret_cast<Int8::Lanes>(a.lanes) | mask.lanes);
}
[[gnu::always_inline]] inline Float8 Joined(const Float4& low, const Float4& high)
{
    return Float8(__builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7));
}
/// In either half rows become columns.
[[gnu::always_inline]] inline void Transpose(Float8& a, Float8& b, Float8& c, Float8& d)
{
    using Lanes = Int8::Lanes;
    const Lanes low{0, 8, 1, 9, 4, 12, 5, 13}, high{2, 10, 3, 11, 6, 14, 7, 15};
    const Lanes first{0, 1, 8, 9, 4, 5, 12, 13}, second{2, 3, 10, 11, 6, 7, 14, 15};
    const Float8::Lanes lowAB = __builtin_shuffle(a.lanes, b.lanes, low);
    const Float8::Lanes highAB = __builtin_shuffle(a.lanes, b.lanes, high);
    const Float8::Lanes lowCD = __builtin_shuffle(c.lanes, d.lanes, low);
    const Float8::Lanes highCD = __builtin_shuffle(c.lanes, d.lanes, high);
    a.lanes = __builtin_shuffle(lowAB, lowCD, first);
    b.lanes = __builtin_shuffle(lowAB, lowCD, second);
    c.lanes = __builtin_shuffle(highAB, highCD, first);
    d.lanes = __builtin_shuffle(highAB, highCD, second);
}
[[gnu::always_inline]] inline void LoadRows(const float* const* rows, int place, Float8& a, Float8& b,
                                            Float8& c, Float8& d)
{
    a = Joined(Load(rows[0] + place), Load(rows[4] + place));
    b = Joined(Load(rows[1] + place), Load(rows[5] + place));
    c = Joined(Load(rows[2] + place), Load(rows[6] + place));
    d = Joined(Load(rows[3] + place), Load(rows[7] + place));
    Transpose(a, b, c, d);
}
[[gnu::always_inline]] inline void ToColumns(const Float4* rows, Float8& x, Float8& y, Float8& z)
{
    Float8 rest = Joined(rows[3], rows[7]);
    x = Joined(rows[0], rows[4]);
    y = Joined(rows[1], rows[5]);
    z = Joined(rows[2], rows[6]);
    Transpose(x, y, z, rest);
}
[[gnu::always_inline]] inline void StoreRows(float (*rows)[8], const Float8* columns)
{
    Float8 left[4]{columns[0], columns[1], columns[2], columns[3]};
    Float8 right[4]{columns[4], columns[5], columns[6], columns[7]};
    Transpose(left[0], left[1], left[2], left[3]);
    Transpose(right[0], right[1], right[2], right[3]);
    for (int i = 0; i < 4; ++i) {
        const Float8::Lanes &a = left[i].lanes, &b = right[i].lanes;
        const Float8::Lanes upper = __builtin_shuffle(a, b, Int8::Lanes{0, 1, 2, 3, 8, 9, 10, 11});
        const Float8::Lanes lower = __builtin_shuffle(a, b, Int8::Lanes{4, 5, 6, 7, 12, 13, 14, 15});
        std::memcpy(rows[i], &upper, sizeof upper);
        std::memcpy(rows[i + 4], &lower, sizeof lower);
    }
}
template <>
[[gnu::always_inline]] inline void AddRow<Float8>(float* sums, const float* row)
{
    Float8::Lanes sum, other;
    std::memcpy(&sum, sums, sizeof sum);
    std::memcpy(&other, row, sizeof other);
    sum += other;
    std::memcpy(sums, &sum, sizeof sum);
}
[[gnu::always_inline]] inline Unsigned8 LoadEight(const std::uint32_t* p)
{
    Unsigned8::Lanes integers;
    std::memcpy(&integers, p, sizeof integers);
    return Unsigned8(integers);
}
/// Lane i of the result is lane order[i] of the one among \p a, \p b, \p c that \p kFromB and \p kFromC tell.
template <int kFromB, int kFromC>
[[gnu::target("avx2")]] inline Unsigned8 Gathered(const Unsigned8& a, const Unsigned8& b, const Unsigned8& c,
                                                  const Int8::Lanes& order)
{
    const __m256i ab =
        _mm256_blend_epi32(reinterpret_cast<__m256i>(a.lanes), reinterpret_cast<__m256i>(b.lanes), kFromB);
    const __m256i abc = _mm256_blend_epi32(ab, reinterpret_cast<__m256i>(c.lanes), kFromC);
    return Unsigned8(reinterpret_cast<Unsigned8::Lanes>(
        _mm256_permutevar8x32_epi32(abc, reinterpret_cast<__m256i>(order))));
}
[[gnu::always_inline]] inline void LoadTriples(const std::uint32_t* p, Unsigned8& first, Unsigned8& second,
                                               Unsigned8& third)
{
    const Unsigned8 a = LoadEight(p), b = LoadEight(p + 8), c = LoadEight(p + 16);
    using Lanes = Int8::Lanes;
    first = Gathered<0b10010010, 0b00100100>(a, b, c, Lanes{0, 3, 6, 1, 4, 7, 2, 5});
    second = Gathered<0b00100100, 0b01001001>(a, b, c, Lanes{1, 4, 7, 2, 5, 0, 3, 6});
    third = Gathered<0b01001001, 0b10010010>(a, b, c, Lanes{2, 5, 0, 3, 6, 1, 4, 7});
}
[[gnu::target("avx2")]] inline Unsigned8 PowersOfTwo(const Unsigned8& bytes)
{
    const __m256i powers = _mm256_set1_epi64x(static_cast<long long>(0x8040201008040201));
    return Unsigned8(reinterpret_cast<Unsigned8::Lanes>(
        _mm256_shuffle_epi8(powers, reinterpret_cast<__m256i>(bytes.lanes))));
}
[[gnu::always_inline]] inline void StoreInterleaved(std::uint32_t* p, const Unsigned8& low,
                                                    const Unsigned8& high)
{
    using Lanes = Unsigned8::Lanes;
    const Lanes a = __builtin_shuffle(low.lanes, high.lanes, Lanes{0, 8, 1, 9, 2, 10, 3, 11});
    const Lanes b = __builtin_shuffle(low.lanes, high.lanes, Lanes{4, 12, 5, 13, 6, 14, 7, 15});
    std::memcpy(p, &a, sizeof a);
    std::memcpy(p + 8, &b, sizeof b);
}

#else
inline bool HasAvx2()
{
    return false;
}
#endif

} // namespace vcg_ext
