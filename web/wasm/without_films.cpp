// Replaces solve/session/solution_film.cpp in a module that makes no frames.
#include "solve/session/solution_state.hpp"

namespace sfumato {

Status Solution::State::solve_next(Context&, const DiffuseOptions&, FrameLayers&, DiffuseStats*) {
  return make_error(StatusCode::unavailable, "this module makes no frames of films");
}

}  // namespace sfumato
