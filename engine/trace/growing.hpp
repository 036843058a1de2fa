#pragma once
// An array of plain data that grows by std::realloc, which for large blocks moves pages instead of bytes: a recorder
// that has no memory yet spends most of its time on memory it touches for the first time, and a std::vector touches all
// of it twice. New elements are not initialized.

#include <algorithm>
#include <cstdlib>
#include <new>
#include <span>
#include <type_traits>
#include <utility>

namespace blossom {

template <class T>
class Growing {
  static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_destructible_v<T>);

 public:
  Growing() = default;
  Growing(const Growing& other) { append(other.begin(), other.end()); }
  Growing(Growing&& other) noexcept { swap(other); }
  Growing& operator=(Growing other) noexcept {
    swap(other);
    return *this;
  }
  ~Growing() { std::free(data_); }

  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  T* data() { return data_; }
  const T* data() const { return data_; }
  T* begin() { return data_; }
  T* end() { return data_ + size_; }
  const T* begin() const { return data_; }
  const T* end() const { return data_ + size_; }
  T& operator[](std::size_t i) { return data_[i]; }
  const T& operator[](std::size_t i) const { return data_[i]; }
  T& back() { return data_[size_ - 1]; }
  operator std::span<const T>() const { return {data_, size_}; }  // NOLINT: it is one

  void clear() { size_ = 0; }
  // `count` more elements, to be written at once: the first of them.
  T* add(std::size_t count) {
    if (capacity_ - size_ < count) [[unlikely]]
      enlarge(size_ + count);
    T* first = data_ + size_;
    size_ += count;
    return first;
  }
  void push_back(const T& value) {
    const T kept = value;  // it may be an element
    *add(1) = kept;
  }
  template <class Iterator>
  void append(Iterator first, Iterator last) {
    std::copy(first, last, add(static_cast<std::size_t>(last - first)));
  }

 private:
  void swap(Growing& other) noexcept {
    std::swap(data_, other.data_);
    std::swap(size_, other.size_);
    std::swap(capacity_, other.capacity_);
  }
  [[gnu::noinline]] void enlarge(std::size_t needed) {
    constexpr std::size_t first = 1024 / sizeof(T);
    const std::size_t capacity = std::max({needed, 2 * capacity_, first});
    void* moved = std::realloc(data_, capacity * sizeof(T));  // NOLINT: trivially copyable
    if (moved == nullptr) throw std::bad_alloc();
    data_ = static_cast<T*>(moved);
    capacity_ = capacity;
  }

  T* data_ = nullptr;
  std::size_t size_ = 0;
  std::size_t capacity_ = 0;
};

}  // namespace blossom
