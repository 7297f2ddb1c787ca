#pragma once

/// For functions that kernels use. They must be inlined, because a call would be bound to one
/// instruction set.
#define SFUMATO_INLINE __attribute__((always_inline)) inline
