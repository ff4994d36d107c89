// What tools/check-kernels must find: code that the whole program would share, and code that runs at start-up.
#include <vector>

namespace blysk {

inline int shared(int x) {
  std::vector<int> many;
  for (int i = 0; i < x; ++i) many.push_back(i);
  return many.back();
}

namespace isa_leaky {

int start = shared(3);

int run(int x) { return shared(x) + start; }

}  // namespace isa_leaky
}  // namespace blysk
