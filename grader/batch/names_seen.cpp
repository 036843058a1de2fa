#include <sys/random.h>
#include <utf8proc.h>

#include <bit>
#include <cstdlib>
#include <memory>

#include "grader/batch/archive.hpp"

namespace blossom {
namespace {

// As Unicode's canonical caseless matching has it (section 3.13, D145); a name that is no UTF-8, with A to Z as a to z.
std::string fold(std::string_view name) {
  std::string out;
  bool plain = true;
  for (const char c : name) {
    plain = plain && static_cast<unsigned char>(c) < 0x80;
    out += 'A' <= c && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  }
  if (plain) return out;
  utf8proc_uint8_t* folded = nullptr;
  const auto options = static_cast<utf8proc_option_t>(UTF8PROC_STABLE | UTF8PROC_DECOMPOSE | UTF8PROC_CASEFOLD);
  const utf8proc_ssize_t size = utf8proc_map(reinterpret_cast<const utf8proc_uint8_t*>(name.data()),
                                             static_cast<utf8proc_ssize_t>(name.size()), &folded, options);
  const std::unique_ptr<utf8proc_uint8_t, void (*)(void*)> owner(folded, std::free);
  if (size < 0) return out;
  return {reinterpret_cast<const char*>(folded), static_cast<std::size_t>(size)};
}

}  // namespace

std::uint64_t sip_hash(const std::uint64_t (&key)[2], std::string_view bytes) {
  std::uint64_t v0 = key[0] ^ 0x736f6d6570736575, v1 = key[1] ^ 0x646f72616e646f6d, v2 = key[0] ^ 0x6c7967656e657261,
                v3 = key[1] ^ 0x7465646279746573;
  const auto rounds = [&](int count) {
    for (; count > 0; --count) {
      v0 += v1, v1 = std::rotl(v1, 13), v1 ^= v0, v0 = std::rotl(v0, 32);
      v2 += v3, v3 = std::rotl(v3, 16), v3 ^= v2;
      v0 += v3, v3 = std::rotl(v3, 21), v3 ^= v0;
      v2 += v1, v1 = std::rotl(v1, 17), v1 ^= v2, v2 = std::rotl(v2, 32);
    }
  };
  const auto word = [&](std::size_t begin, std::size_t end) {
    std::uint64_t m = 0;
    for (std::size_t i = end; i > begin; --i) m = m << 8 | static_cast<unsigned char>(bytes[i - 1]);
    return m;
  };
  const auto take = [&](std::uint64_t m) {
    v3 ^= m;
    rounds(2);
    v0 ^= m;
  };
  const std::size_t whole = bytes.size() / 8 * 8;
  for (std::size_t i = 0; i < whole; i += 8) take(word(i, i + 8));
  take(word(whole, bytes.size()) | static_cast<std::uint64_t>(bytes.size()) << 56);
  v2 ^= 0xff;
  rounds(4);
  return v0 ^ v1 ^ v2 ^ v3;
}

NamesSeen::NamesSeen() : key_{}, slots_(1024) {
  // A fixed key if there is none to be had: then names can be made to collide, and are refused, but nothing else.
  if (::getrandom(key_, sizeof key_, 0) != sizeof key_) key_[0] = key_[1] = 0;
}

bool NamesSeen::add(std::string_view name) {
  if (4 * count_ >= 3 * slots_.size()) grow();
  const std::uint64_t hash = std::max<std::uint64_t>(sip_hash(key_, fold(name)), 1);
  for (std::size_t i = hash & (slots_.size() - 1);; i = (i + 1) & (slots_.size() - 1)) {
    if (slots_[i] == hash) return false;
    if (slots_[i] != 0) continue;
    slots_[i] = hash;
    ++count_;
    return true;
  }
}

void NamesSeen::grow() {
  std::vector<std::uint64_t> before(2 * slots_.size());
  before.swap(slots_);
  for (const std::uint64_t hash : before) {
    if (hash == 0) continue;
    std::size_t i = hash & (slots_.size() - 1);
    while (slots_[i] != 0) i = (i + 1) & (slots_.size() - 1);
    slots_[i] = hash;
  }
}

}  // namespace blossom
