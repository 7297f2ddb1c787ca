#pragma once

/// For functions that kernels use. They must be inlined, because a call would be bound to one
/// instruction set.
#define SFUMATO_INLINE __attribute__((always_inline)) inline
/// The same for a lambda, after its parameters.
#define SFUMATO_INLINE_LAMBDA __attribute__((always_inline))
