// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <new>
#include <type_traits>
#include <utility>
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
    static constexpr std::align_val_t kAlignment{64};
    /// Values that vector code may read (never use) behind the last one.
    static constexpr std::size_t kReadablePadding = 64;

    struct Free {
        std::align_val_t alignment = kAlignment;
        void operator()(T* data) const { ::operator delete(data, alignment); }
    };
    std::unique_ptr<T, Free> data_;
    std::size_t size_ = 0;

    void Allocate(std::size_t size, std::size_t bytes, std::align_val_t alignment)
    {
        Release();
        data_ = std::unique_ptr<T, Free>(static_cast<T*>(::operator new(bytes, alignment)), Free{alignment});
        size_ = size;
    }

  public:
    Buffer() = default;
    explicit Buffer(std::size_t size) { Allocate(size); }
    Buffer(Buffer&& other) noexcept : data_(std::move(other.data_)), size_(std::exchange(other.size_, 0)) {}
    Buffer& operator=(Buffer&& other) noexcept
    {
        data_ = std::move(other.data_);
        size_ = std::exchange(other.size_, 0);
        return *this;
    }

    /// Drops the content and takes room for \p size values. \throws std::bad_alloc
    void Allocate(std::size_t size) { Allocate(size, (size + kReadablePadding) * sizeof(T), kAlignment); }

    /// The same for many values that are visited in no order of theirs: on pages of 2 MiB, where the system
    /// has them. The first touch of a small page costs as much as the work on all that is in it.
    void AllocateOnLargePages(std::size_t size)
    {
        const std::size_t pages = (size + kReadablePadding) * sizeof(T) / kLargePage + 1;
        if (pages == 1) return Allocate(size);
        Allocate(size, pages * kLargePage, std::align_val_t{kLargePage});
        AdviseLargePages(data(), pages * kLargePage);
    }
    void Release()
    {
        data_.reset();
        size_ = 0;
    }

    std::size_t size() const { return size_; }
    bool empty() const { return size_ == 0; }
    T* data() { return data_.get(); }
    const T* data() const { return data_.get(); }
    T* begin() { return data(); }
    T* end() { return data() + size_; }
    const T* begin() const { return data(); }
    const T* end() const { return data() + size_; }
    T& operator[](std::size_t i) { return data_.get()[i]; }
    const T& operator[](std::size_t i) const { return data_.get()[i]; }
};

} // namespace vcg_ext
