#pragma once

#include <array>
#include <cassert>
#include <cstddef>
#include <initializer_list>
#include <utility>

namespace knotwork::web {

/// A list of at most `most` items that asks for no memory: what the interface makes anew in every frame.
template <class T, std::size_t most>
class Few {
 public:
  Few() = default;
  Few(std::initializer_list<T> items) {
    for (const T& item : items) push_back(item);
  }

  /// Precondition: there is room. Without it the item is left out.
  void push_back(T item) {
    assert(count_ < most);
    if (count_ < most) items_[count_++] = std::move(item);
  }

  std::size_t size() const { return count_; }
  bool empty() const { return count_ == 0; }
  T* begin() { return items_.data(); }
  T* end() { return items_.data() + count_; }
  const T* begin() const { return items_.data(); }
  const T* end() const { return items_.data() + count_; }
  const T& front() const { return items_.front(); }

 private:
  std::array<T, most> items_{};
  std::size_t count_ = 0;
};

}  // namespace knotwork::web
