#pragma once
// Where files that nobody can trust are read: a process that has all it needs already, and may from now on only
// compute, read and write what is open, and end. No network, no new files, no new processes, no new privileges
// (no_new_privs and a seccomp filter on Linux; limits of memory, file size and descriptors everywhere). Whatever else
// it tries ends it with SIGSYS, before the kernel has looked at what was asked.

#include <cstddef>
#include <string>

namespace blossom {

// Whether this program was built with a sanitizer that keeps a shadow of the memory.
#if defined(__SANITIZE_ADDRESS__)
inline constexpr bool sanitized = true;
#elif defined(__has_feature)
inline constexpr bool sanitized = __has_feature(address_sanitizer) || __has_feature(memory_sanitizer);
#else
inline constexpr bool sanitized = false;
#endif

// Closes the calling process off, for good. What could not be closed, and why, in a sentence; empty: all is closed.
// memory_bytes: of address space beyond what it has; 0: no limit. No such limit where `sanitized`.
std::string enter_sandbox(std::size_t memory_bytes);

}  // namespace blossom
