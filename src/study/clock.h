// study/clock.h - the processor's clock as measured, so that times can be told in cycles.
#pragma once

namespace blysk::study {

/// Hz, measured once in about 0.2 s: the best of several loops of additions that wait for each other, one a
/// cycle.
[[nodiscard]] double clock_hz();

}  // namespace blysk::study
