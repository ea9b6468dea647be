#pragma once
// OpenBLAS needs two words before it can be used well here.

#include <string>

namespace vesicle
{

/// Debian's OpenBLAS 0.3.21 does not know recent processors and falls back to SSE kernels (a
/// quarter of the speed or less). The choice is made when the library is loaded, so a program calls
/// this first thing in main(): it sets OPENBLAS_CORETYPE by the processor's flags and starts itself
/// again, once. Does nothing where the variable is set already or not needed.
void restart_with_blas_kernel(char** argv);

/// From now on OpenBLAS works on the caller's thread alone: our tasks are the threads, its own would
/// compete with them and change the rounding.
void use_one_blas_thread();

/// The kernel that OpenBLAS runs ("SkylakeX", "Haswell", …).
std::string blas_kernel();

}
