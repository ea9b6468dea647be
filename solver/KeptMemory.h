#pragma once
// What a step frees the next one needs again.

#include <cstdlib>
#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace vesicle
{

/// From now on the process keeps memory that is freed, instead of giving it back to the system and
/// having it cleared page by page when it is asked for again (a quarter of a shape's time on small
/// meshes). For the main() of a program that steps; glibc's allocator only.
inline void keep_freed_memory()
{
#ifdef __GLIBC__
  mallopt(M_MMAP_THRESHOLD, 32 << 20); // bytes, the most that glibc takes
  mallopt(M_TRIM_THRESHOLD, 1 << 30);
#endif
}

}
