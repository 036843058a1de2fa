#pragma once
// Values as bytes, for what one process of ours hands to another and for files between two stages of a run: numbers in
// the machine's own order, texts with their length before them.

#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>

namespace blossom {

class ByteWriter {
 public:
  explicit ByteWriter(std::string& out) : out_(&out) {}

  template <class T>
  requires std::is_arithmetic_v<T>
  void number(T value) {
    char bytes[sizeof(T)];
    std::memcpy(bytes, &value, sizeof(T));
    out_->append(bytes, sizeof(T));
  }
  void text(std::string_view value) {
    number(static_cast<std::uint64_t>(value.size()));
    out_->append(value);
  }

 private:
  std::string* out_;
};

// Throws std::runtime_error where the bytes end too early: they are our own, so that is no mistake of any input.
class ByteReader {
 public:
  explicit ByteReader(std::string_view in) : in_(in) {}

  template <class T>
  requires std::is_arithmetic_v<T> T number() {
    T value;
    std::memcpy(&value, take(sizeof(T)).data(), sizeof(T));
    return value;
  }
  std::string_view text() { return take(number<std::uint64_t>()); }
  bool at_end() const { return in_.empty(); }

 private:
  std::string_view take(std::uint64_t size) {
    if (size > in_.size()) throw std::runtime_error("a record ends too early");
    const std::string_view taken = in_.substr(0, size);
    in_.remove_prefix(size);
    return taken;
  }

  std::string_view in_;
};

}  // namespace blossom
