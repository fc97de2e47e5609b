// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

namespace vcg_ext
{

/// A point or direction in the engine's single precision frame.
struct Vector3 {
    float x = 0, y = 0, z = 0;
};

inline Vector3 operator+(const Vector3& a, const Vector3& b)
{
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Vector3 operator-(const Vector3& a, const Vector3& b)
{
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Vector3 operator*(float s, const Vector3& a)
{
    return {s * a.x, s * a.y, s * a.z};
}
inline float Dot(const Vector3& a, const Vector3& b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline Vector3 Cross(const Vector3& a, const Vector3& b)
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline float SquaredNorm(const Vector3& a)
{
    return Dot(a, a);
}
inline float Norm(const Vector3& a)
{
    return std::sqrt(SquaredNorm(a));
}

} // namespace vcg_ext
