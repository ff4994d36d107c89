// The one table of studies.
#include "blysk/study.h"

namespace blysk {
namespace {

constexpr Study kStudies[] = {
    {"shading", "shading methods: their operations, errors and speed", study_shading, false},
    {"abuffer", "the modified A-buffer: its policies for full lists and its memory", study_abuffer, true},
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
      break;
  }
  return "does not hold";
}

}  // namespace blysk
