// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Eight floats at once, where the processor has AVX2. For kernels whose lanes never meet: a sum over lanes
// would have another order than that of four, and the bytes of a result would depend on the processor.

#include <cstdint>
#include <cstring>
#if defined(__x86_64__)
#include <immintrin.h>
#endif

#include "vcg_ext/core/base/float4.h"

namespace vcg_ext
{

#if defined(__x86_64__) && defined(__GNUC__) && __GNUC__ >= 12 && !defined(__clang__)
#define VCG_EXT_HAS_FLOAT8
/// For the functions that work on Float8, and for them alone: they may be called where HasAvx2().
#define VCG_EXT_FOR_AVX2 [[gnu::target("avx2"), gnu::flatten]]

/// Eight numbers with the operators of a compiler's vector. In a class, because of a bare vector GCC warns
/// (-Wpsabi) in every template that returns one, although all of them are inlined.
template <class Number>
struct EightOf {
    typedef Number Vector __attribute__((vector_size(32)));
    using Mask = EightOf<std::int32_t>;

    Vector v;

    EightOf() = default;
    [[gnu::always_inline]] EightOf(const Vector& vector) : v(vector) {}
    [[gnu::always_inline]] EightOf(Number x) : v{x, x, x, x, x, x, x, x} {}

    [[gnu::always_inline]] friend EightOf operator+(const EightOf& a, const EightOf& b) { return a.v + b.v; }
    [[gnu::always_inline]] friend EightOf operator-(const EightOf& a, const EightOf& b) { return a.v - b.v; }
    [[gnu::always_inline]] friend EightOf operator*(const EightOf& a, const EightOf& b) { return a.v * b.v; }
    [[gnu::always_inline]] friend EightOf operator/(const EightOf& a, const EightOf& b) { return a.v / b.v; }
    [[gnu::always_inline]] friend EightOf operator&(const EightOf& a, const EightOf& b) { return a.v & b.v; }
    [[gnu::always_inline]] friend EightOf operator|(const EightOf& a, const EightOf& b) { return a.v | b.v; }
    [[gnu::always_inline]] friend EightOf operator^(const EightOf& a, const EightOf& b) { return a.v ^ b.v; }
    [[gnu::always_inline]] friend Mask operator<(const EightOf& a, const EightOf& b) { return a.v < b.v; }
    [[gnu::always_inline]] friend Mask operator>(const EightOf& a, const EightOf& b) { return a.v > b.v; }
    [[gnu::always_inline]] friend Mask operator==(const EightOf& a, const EightOf& b) { return a.v == b.v; }
    [[gnu::always_inline]] EightOf& operator*=(const EightOf& other) { return *this = *this * other; }
    [[gnu::always_inline]] EightOf& operator^=(const EightOf& other) { return *this = *this ^ other; }
    [[gnu::always_inline]] friend EightOf operator~(const EightOf& a) { return ~a.v; }
    [[gnu::always_inline]] friend EightOf operator<<(const EightOf& a, int bits) { return a.v << bits; }
    [[gnu::always_inline]] friend EightOf operator>>(const EightOf& a, int bits) { return a.v >> bits; }
};
using Float8 = EightOf<float>;
using Int8 = EightOf<std::int32_t>;
using Unsigned8 = EightOf<std::uint32_t>;
template <>
struct IntegersLike<Float8> {
    using Int = Int8;
    using Unsigned = Unsigned8;
};

inline bool HasAvx2()
{
    return __builtin_cpu_supports("avx2") != 0;
}
template <>
[[gnu::always_inline]] inline Float8 Broadcast<Float8>(float x)
{
    return x;
}
[[gnu::always_inline]] inline Int8 Bits(const Float8& a)
{
    return reinterpret_cast<Int8::Vector>(a.v);
}
[[gnu::always_inline]] inline Float8 Floats(const Int8& a)
{
    return reinterpret_cast<Float8::Vector>(a.v);
}
[[gnu::always_inline]] inline Float8 ToFloats(const Unsigned8& a)
{
    return __builtin_convertvector(reinterpret_cast<Int8::Vector>(a.v), Float8::Vector);
}
/// As Max of Float4: \p b where they do not compare.
[[gnu::always_inline]] inline Float8 Max(const Float8& a, const Float8& b)
{
    return a.v > b.v ? a.v : b.v;
}
[[gnu::target("avx2")]] inline Float8 Sqrt(const Float8& a)
{
    return _mm256_sqrt_ps(a.v);
}
[[gnu::target("avx2")]] inline bool AnyLane(const Int8& mask)
{
    return !_mm256_testz_si256(reinterpret_cast<__m256i>(mask.v), reinterpret_cast<__m256i>(mask.v));
}
[[gnu::always_inline]] inline Float8 Select(const Int8& mask, const Float8& yes, const Float8& no)
{
    return mask.v ? yes.v : no.v;
}
[[gnu::always_inline]] inline Float8 Joined(const Float4& low, const Float4& high)
{
    return __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7);
}
/// In either half rows become columns.
[[gnu::always_inline]] inline void Transpose(Float8& a, Float8& b, Float8& c, Float8& d)
{
    const Int8::Vector low{0, 8, 1, 9, 4, 12, 5, 13}, high{2, 10, 3, 11, 6, 14, 7, 15};
    const Int8::Vector first{0, 1, 8, 9, 4, 5, 12, 13}, second{2, 3, 10, 11, 6, 7, 14, 15};
    const Float8::Vector lowAB = __builtin_shuffle(a.v, b.v, low), highAB = __builtin_shuffle(a.v, b.v, high);
    const Float8::Vector lowCD = __builtin_shuffle(c.v, d.v, low), highCD = __builtin_shuffle(c.v, d.v, high);
    a.v = __builtin_shuffle(lowAB, lowCD, first);
    b.v = __builtin_shuffle(lowAB, lowCD, second);
    c.v = __builtin_shuffle(highAB, highCD, first);
    d.v = __builtin_shuffle(highAB, highCD, second);
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
    Float8 a = columns[0], b = columns[1], c = columns[2], d = columns[3];
    Float8 e = columns[4], f = columns[5], g = columns[6], h = columns[7];
    Transpose(a, b, c, d);
    Transpose(e, f, g, h);
    const auto store =
        [](float(*two)[8], const Float8& left, const Float8& right) __attribute__((always_inline))
    {
        const Float8 first = __builtin_shuffle(left.v, right.v, Int8::Vector{0, 1, 2, 3, 8, 9, 10, 11});
        const Float8 fifth = __builtin_shuffle(left.v, right.v, Int8::Vector{4, 5, 6, 7, 12, 13, 14, 15});
        std::memcpy(two[0], &first, sizeof first);
        std::memcpy(two[4], &fifth, sizeof fifth);
    };
    store(rows, a, e);
    store(rows + 1, b, f);
    store(rows + 2, c, g);
    store(rows + 3, d, h);
}
template <>
[[gnu::always_inline]] inline void AddRow<Float8>(float* sums, const float* row)
{
    Float8::Vector sum, other;
    std::memcpy(&sum, sums, sizeof sum);
    std::memcpy(&other, row, sizeof other);
    sum += other;
    std::memcpy(sums, &sum, sizeof sum);
}
[[gnu::always_inline]] inline Unsigned8 LoadEight(const std::uint32_t* p)
{
    Unsigned8 integers;
    std::memcpy(&integers.v, p, sizeof integers);
    return integers;
}
/// Lane i of the result is lane order[i] of the one among \p a, \p b, \p c that \p fromB and \p fromC tell.
template <int kFromB, int kFromC>
[[gnu::target("avx2")]] inline Unsigned8 Gathered(const Unsigned8& a, const Unsigned8& b, const Unsigned8& c,
                                                  const Int8& order)
{
    const auto ab =
        _mm256_blend_epi32(reinterpret_cast<__m256i>(a.v), reinterpret_cast<__m256i>(b.v), kFromB);
    const auto abc = _mm256_blend_epi32(ab, reinterpret_cast<__m256i>(c.v), kFromC);
    const auto permuted = _mm256_permutevar8x32_epi32(abc, reinterpret_cast<__m256i>(order.v));
    return reinterpret_cast<Unsigned8::Vector>(permuted);
}
[[gnu::always_inline]] inline void LoadTriples(const std::uint32_t* p, Unsigned8& first, Unsigned8& second,
                                               Unsigned8& third)
{
    using Places = Int8::Vector;
    const Unsigned8 a = LoadEight(p), b = LoadEight(p + 8), c = LoadEight(p + 16);
    first = Gathered<0b10010010, 0b00100100>(a, b, c, Places{0, 3, 6, 1, 4, 7, 2, 5});
    second = Gathered<0b00100100, 0b01001001>(a, b, c, Places{1, 4, 7, 2, 5, 0, 3, 6});
    third = Gathered<0b01001001, 0b10010010>(a, b, c, Places{2, 5, 0, 3, 6, 1, 4, 7});
}
[[gnu::target("avx2")]] inline Unsigned8 PowersOfTwo(const Unsigned8& bytes)
{
    const __m256i powers = _mm256_set1_epi64x(static_cast<long long>(0x8040201008040201));
    return reinterpret_cast<Unsigned8::Vector>(
        _mm256_shuffle_epi8(powers, reinterpret_cast<__m256i>(bytes.v)));
}
[[gnu::always_inline]] inline void StoreInterleaved(std::uint32_t* p, const Unsigned8& low,
                                                    const Unsigned8& high)
{
    using Places = Unsigned8::Vector;
    const Unsigned8 a = __builtin_shuffle(low.v, high.v, Places{0, 8, 1, 9, 2, 10, 3, 11});
    const Unsigned8 b = __builtin_shuffle(low.v, high.v, Places{4, 12, 5, 13, 6, 14, 7, 15});
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
