// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>
#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace vcg_ext
{

constexpr std::size_t kLargePage = std::size_t{1} << 21;

/// Asks for \p bytes from \p begin on to lie on large pages. A hint: nothing but the time depends on it.
inline void AdviseLargePages([[maybe_unused]] void* begin, [[maybe_unused]] std::size_t bytes)
{
#if defined(__linux__)
    madvise(begin, bytes, MADV_HUGEPAGE);
#endif
}

/// A fixed-size array of plain values, aligned to a cache line and left uninitialised.
///
/// std::vector writes zeros over memory that the next line fills anyway; on meshes of millions of faces that
/// is a measurable share of the run. The size is chosen once by Allocate.
/// \tparam T trivially copyable
template <class T>
class Buffer
{
    static_assert(std::is_trivially_copyable_v<T>, "Buffer leaves its values uninitialised");
    static constexpr std::size_t kAlignment = 64;
    /// Values that vector code may read (never use) behind the last one.
    static constexpr std::size_t kReadablePadding = 64;

    struct Free {
        void operator()(void* block) const { std::free(block); }
    };
    std::unique_ptr<void, Free> block_;
    T* data_ = nullptr; ///< in it, aligned
    std::size_t size_ = 0;

    static std::size_t BytesFor(std::size_t size) { return (size + kReadablePadding) * sizeof(T); }

    /// \param block with room for \p alignment more than the values
    void Take(void* block, std::size_t size, std::size_t alignment)
    {
        block_.reset(block);
        if (block == nullptr) throw std::bad_alloc();
        const auto address = reinterpret_cast<std::uintptr_t>(block);
        const std::uintptr_t aligned = (address + alignment - 1) / alignment * alignment;
        data_ = reinterpret_cast<T*>(static_cast<unsigned char*>(block) + (aligned - address));
        size_ = size;
    }

  public:
    Buffer() = default;
    explicit Buffer(std::size_t size) { Allocate(size); }
    Buffer(Buffer&& other) noexcept
        : block_(std::move(other.block_)), data_(std::exchange(other.data_, nullptr)),
          size_(std::exchange(other.size_, 0))
    {
    }
    Buffer& operator=(Buffer&& other) noexcept
    {
        block_ = std::move(other.block_);
        data_ = std::exchange(other.data_, nullptr);
        size_ = std::exchange(other.size_, 0);
        return *this;
    }

    /// Drops the content and takes room for \p size values. \throws std::bad_alloc
    void Allocate(std::size_t size)
    {
        Release();
        Take(std::malloc(BytesFor(size) + kAlignment), size, kAlignment);
    }

    /// The first \p count values. \pre they are there \throws std::bad_alloc
    Buffer Copy(std::size_t count) const
    {
        Buffer copy(count);
        std::copy_n(data_, count, copy.data_);
        return copy;
    }
    Buffer Copy() const { return Copy(size_); }

    /// The same with all bits 0, for many values that are visited in no order of theirs: on pages of 2 MiB,
    /// where the system has them. The first touch of a small page costs as much as the work on all that is in
    /// it, and fresh pages are zero already.
    void AllocateZeros(std::size_t size)
    {
        Release();
        const std::size_t pages = BytesFor(size) / kLargePage + 1;
        const std::size_t alignment = pages > 1 ? kLargePage : kAlignment;
        const std::size_t bytes = pages > 1 ? pages * kLargePage : BytesFor(size);
        Take(std::calloc(bytes + alignment, 1), size, alignment);
        if (pages > 1) AdviseLargePages(data(), bytes);
    }
    void Release()
    {
        block_.reset();
        data_ = nullptr;
        size_ = 0;
    }

    std::size_t size() const { return size_; }
    bool empty() const { return size_ == 0; }
    T* data() { return data_; }
    const T* data() const { return data_; }
    T* begin() { return data(); }
    T* end() { return data() + size_; }
    const T* begin() const { return data(); }
    const T* end() const { return data() + size_; }
    T& operator[](std::size_t i) { return data_[i]; }
    const T& operator[](std::size_t i) const { return data_[i]; }
};

/// Reusable room for values that are written before they are read; never shrinks.
template <class T>
class Scratch
{
    std::vector<T> values_;
    std::size_t size_ = 0;

  public:
    /// Values behind the old size are whatever was there.
    void Resize(std::size_t size)
    {
        if (size > values_.size()) values_.resize(size + size / 2);
        size_ = size;
    }
    T& Append()
    {
        Resize(size_ + 1);
        return values_[size_ - 1];
    }
    void Clear() { size_ = 0; }
    std::size_t size() const { return size_; }
    T* begin() { return values_.data(); }
    T* end() { return values_.data() + size_; }
    const T* begin() const { return values_.data(); }
    const T* end() const { return values_.data() + size_; }
    T& operator[](std::size_t i) { return values_[i]; }
    const T& operator[](std::size_t i) const { return values_[i]; }
};

/// A part of an array that somebody else owns.
template <class T>
struct ArrayView {
    const T* first;
    std::size_t count;

    const T* begin() const { return first; }
    const T* end() const { return first + count; }
    std::size_t size() const { return count; }
    const T& operator[](std::size_t i) const { return first[i]; }
};

} // namespace vcg_ext
