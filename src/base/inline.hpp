#pragma once

/// What a kernel is made of must not be called: a call would be bound to one instruction set.
#define SFUMATO_INLINE __attribute__((always_inline)) inline
