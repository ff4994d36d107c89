// lighting/set_lobe.h - the constants of a lobe, once a draw.
#pragma once

#include "lighting/lamp.h"

namespace blysk {

/// Gives the surface its lobe; `shininess` is set already, 1..1000. Where a lobe would not reach zero within
/// 90 degrees the surface gets the exact power instead: what is seen edge-on must not shine.
void set_lobe(Surface& s, Lobe lobe);

}  // namespace blysk
