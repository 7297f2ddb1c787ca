#pragma once

#include <cstdint>

namespace sfumato::outputs {

/// Iterations between two checks of the cancel flag (RarePoll), in loops over vertices, half-edges,
/// nodes or pixels that compute little.
inline constexpr std::uint32_t kTurnsPerPoll = 65'536;
/// The same in loops that write text or gather numbers from several tables.
inline constexpr std::uint32_t kWritesPerPoll = 4096;

}  // namespace sfumato::outputs
