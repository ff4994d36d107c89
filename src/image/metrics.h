// image/metrics.h - what the metrics share.
#pragma once

#include "blysk/metrics.h"
#include "blysk/result.h"

namespace blysk {

/// ErrorCode::input unless both have one size.
[[nodiscard]] Status check_same_size(const Image& reference, const Image& candidate);

}  // namespace blysk
