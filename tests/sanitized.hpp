#pragma once
// Whether the tests run under the address sanitizer, which takes more memory and makes them ten times as slow.

#if defined(__has_feature)
#if __has_feature(address_sanitizer)
#define BLOSSOM_SANITIZED 1
#endif
#elif defined(__SANITIZE_ADDRESS__)
#define BLOSSOM_SANITIZED 1
#endif

namespace blossom::test {

#ifdef BLOSSOM_SANITIZED
constexpr bool sanitized = true;
#else
constexpr bool sanitized = false;
#endif

}  // namespace blossom::test
