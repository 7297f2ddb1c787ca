#pragma once

namespace sfumato::cli {

/// Sets up the process's heap for tables that are large, made once and freed together. Call it
/// once, before threads start. Has an effect with glibc alone, and changes no result.
///
/// Freed memory stays in the process, because the next table uses it again: fetching it again from
/// the system, page by page and in one thread, takes up to a sixth of the time. The first 256 MiB
/// of the heap may lie in large pages (2 MiB), one page fault instead of 512: solving roses takes
/// 0.75 of the time. Memory that is not used is not taken from the system.
void prepare_heap();

/// Returns freed blocks of a MiB to the system if the user sets a bound; glibc would keep them in
/// addition to the charged memory.
void return_freed_memory();

}  // namespace sfumato::cli
