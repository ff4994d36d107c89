#include "load.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return blysk::fuzz::load("x.obj", data, size);
}
