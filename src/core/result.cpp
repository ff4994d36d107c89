#include "blysk/result.h"

namespace blysk {

std::string Error::text() const {
  std::string t = source;
  if (line > 0) t += (t.empty() ? "line " : ":") + std::to_string(line);
  if (!t.empty()) t += ": ";
  return t + message;
}

}  // namespace blysk
