#pragma once

/// SFUMATO_HAS_SANITIZER: 1 in builds with AddressSanitizer or ThreadSanitizer, which replace the
/// allocator, slow the program down, and use memory and stack of their own; 0 elsewhere.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define SFUMATO_HAS_SANITIZER 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define SFUMATO_HAS_SANITIZER 1
#endif
#endif
#if !defined(SFUMATO_HAS_SANITIZER)
#define SFUMATO_HAS_SANITIZER 0
#endif
