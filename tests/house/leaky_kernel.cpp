// What tools/check-kernels must find: code that the program would share, and code that runs at start-up.
namespace blysk {

[[gnu::noinline]] inline int shared(int x) { return x * x; }

namespace isa_leaky {

volatile int three = 3;
int start = shared(three);

int run(int x) { return shared(x) + start; }

}  // namespace isa_leaky
}  // namespace blysk
