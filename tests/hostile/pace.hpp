#pragma once

namespace sfumato::hostile {

/// How much longer than on the machine that the limits were set on, quiet, this one takes now: the
/// processor time of a fixed piece of work (arithmetic, and new memory that is touched) by that of
/// then; at least 1 and at most 3. Another program on a core's other thread, or a machine that is
/// virtual, lengthens processor time too.
double slowness();

}  // namespace sfumato::hostile
