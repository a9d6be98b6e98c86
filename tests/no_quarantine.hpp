#pragma once

/// For test programs that measure memory: AddressSanitizer keeps freed memory for a while, which
/// looks like growth. Include it once in a program.
#ifdef __SANITIZE_ADDRESS__
extern "C" const char* __asan_default_options() { return "quarantine_size_mb=0"; }
#endif
