// The one table of studies.
#include "blysk/study.h"
#include "study/shading_study.h"

namespace blysk {
namespace {

constexpr Study kStudies[] = {
    {"shading", "Shading methods: the thesis on shading, the papers on Gouraud shading and on vectors",
     study::run_shading_study},
};

}  // namespace

std::span<const Study> studies() { return kStudies; }

std::string_view verdict_name(Verdict verdict) {
  switch (verdict) {
    case Verdict::holds:
      return "holds";
    case Verdict::in_part:
      return "holds in part";
    case Verdict::fails:
      return "does not hold";
  }
  return "";
}

}  // namespace blysk
