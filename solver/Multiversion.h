#pragma once
// Functions that are compiled for several instruction sets; the widest that the processor has is
// chosen when the program starts. (Not with sanitizers: that happens before their runtimes are there.)

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) &&                             \
  !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define VESICLE_MULTIVERSION                                                                       \
  __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#else
#define VESICLE_MULTIVERSION
#endif
/// Inlined into each of its callers' versions.
#define VESICLE_INLINE inline __attribute__((always_inline))
