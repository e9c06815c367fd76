#pragma once

/// Before a function whose loops compilers turn into vector instructions: the widest vectors that
/// the processor has are chosen when the program starts. Sanitizers run before that choice could be
/// made, so their builds keep to the compiler's default. Results are the same to the bit, as long
/// as no sum runs from one side of a vector to the other.
#if defined(__x86_64__) && defined(__gnu_linux__) && !defined(__clang__)
#define MOONTRACE_WIDE __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#else
#define MOONTRACE_WIDE
#endif
