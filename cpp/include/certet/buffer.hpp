#pragma once
/// \file
/// An array of numbers whose memory is not touched before it is written.

#include <cstddef>
#include <span>
#include <type_traits>
#include <utility>

namespace certet {

namespace detail {
/// Memory for large arrays, in huge pages where the system has them.
/// \throws std::bad_alloc
void* allocate_array(std::size_t bytes);
void release_array(void* array) noexcept;
}  // namespace detail

/// Owns `size()` numbers.  Unlike std::vector it does not fill them first: a
/// mesh of gigabytes is written exactly once.
template <class T>
class Buffer {
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  Buffer() = default;
  explicit Buffer(std::size_t size)
      : data_(static_cast<T*>(detail::allocate_array(size * sizeof(T)))), size_(size) {}
  ~Buffer() { detail::release_array(data_); }
  Buffer(Buffer&& other) noexcept
      : data_(std::exchange(other.data_, nullptr)), size_(std::exchange(other.size_, 0)) {}
  Buffer& operator=(Buffer&& other) noexcept {
    std::swap(data_, other.data_);
    std::swap(size_, other.size_);
    return *this;
  }

  [[nodiscard]] T* data() { return data_; }
  [[nodiscard]] const T* data() const { return data_; }
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] bool empty() const { return size_ == 0; }
  [[nodiscard]] T& operator[](std::size_t i) { return data_[i]; }
  [[nodiscard]] const T& operator[](std::size_t i) const { return data_[i]; }
  [[nodiscard]] T* begin() { return data_; }
  [[nodiscard]] T* end() { return data_ + size_; }
  [[nodiscard]] const T* begin() const { return data_; }
  [[nodiscard]] const T* end() const { return data_ + size_; }

 private:
  T* data_ = nullptr;
  std::size_t size_ = 0;
};

}  // namespace certet
