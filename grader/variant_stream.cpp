#include <openssl/evp.h>
#include <openssl/hmac.h>

#include <cassert>
#include <limits>

#include "grader/variant.hpp"

namespace blossom {
namespace {

std::string hmac_sha256(std::string_view key, std::string_view message) {
  unsigned char digest[EVP_MAX_MD_SIZE];
  unsigned int size = 0;
  // Only a machine out of memory makes this fail; the digest must never be made up then.
  if (HMAC(EVP_sha256(), key.data(), static_cast<int>(key.size()),
           reinterpret_cast<const unsigned char*>(message.data()), message.size(), digest, &size) == nullptr)
    throw std::bad_alloc();
  return {reinterpret_cast<const char*>(digest), size};
}

}  // namespace

VariantStream::VariantStream(std::string_view secret, std::string_view exercise_id, std::string_view student_id) {
  std::string message = "blossom.variant/1\n";
  message.append(exercise_id).append("\n").append(student_id);
  key_ = hmac_sha256(secret, message);
}

std::uint64_t VariantStream::next() {
  if (used_ == 4) {
    std::string number;
    for (int shift = 56; shift >= 0; shift -= 8) number += static_cast<char>((block_ >> shift) & 0xff);
    ++block_;
    const std::string block = hmac_sha256(key_, number);
    for (std::size_t i = 0; i < 4; ++i) {
      words_[i] = 0;
      for (std::size_t b = 0; b < 8; ++b) words_[i] = words_[i] << 8 | static_cast<unsigned char>(block[8 * i + b]);
    }
    used_ = 0;
  }
  return words_[used_++];
}

std::uint64_t VariantStream::below(std::uint64_t n) {
  assert(n > 0);
  constexpr std::uint64_t most = std::numeric_limits<std::uint64_t>::max();
  const std::uint64_t end = most - most % n;
  std::uint64_t word = next();
  while (word >= end) word = next();
  return word % n;
}

}  // namespace blossom
