#include "blysk/version.h"

namespace blysk {
std::string_view version() { return BLYSK_VERSION; }
}  // namespace blysk
