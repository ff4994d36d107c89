// blysk/blysk.h - the whole public API.
#pragma once

#include "blysk/fragments.h"  // IWYU pragma: export
#include "blysk/image.h"      // IWYU pragma: export
#include "blysk/methods.h"    // IWYU pragma: export
#include "blysk/metrics.h"    // IWYU pragma: export
#include "blysk/model.h"      // IWYU pragma: export
#include "blysk/render.h"     // IWYU pragma: export
#include "blysk/scene.h"      // IWYU pragma: export
#include "blysk/shapes.h"     // IWYU pragma: export
#include "blysk/study.h"      // IWYU pragma: export
#include "blysk/version.h"    // IWYU pragma: export
