# What every source of ours is compiled with.
#
# -ffp-contract=off: a multiplication and an addition round separately on every target, so that pictures
# have the same bytes everywhere (docs/determinism.md). -fno-math-errno only spares the errno of sqrt.
add_library(blysk_flags INTERFACE)
target_compile_options(blysk_flags INTERFACE
  -ffp-contract=off -fno-math-errno -fno-trapping-math -fvisibility=hidden
  -Wall -Wextra -Wshadow -Wconversion -Wno-sign-conversion -Wno-psabi -Wdouble-promotion)
if(BLYSK_SANITIZE)
  target_compile_options(blysk_flags INTERFACE -fsanitize=${BLYSK_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  target_link_options(blysk_flags INTERFACE -fsanitize=${BLYSK_SANITIZE})
endif()

option(BLYSK_ROOMS "Compile the sources of a folder together: from nothing, far faster" OFF)

# GCC takes a source that is included for a header.
function(blysk_allow_rooms target)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    target_compile_options(${target} PRIVATE -Wno-subobject-linkage)
  endif()
endfunction()

# With BLYSK_ROOMS, the target's sources are one text a folder. Names in unnamed namespaces are then one folder's,
# those in kernels one instruction set's; that every source names the headers it needs is seen by the builds without.
function(blysk_compile_rooms target)
  if(NOT BLYSK_ROOMS)
    return()
  endif()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  blysk_allow_rooms(${target})
  get_target_property(sources ${target} SOURCES)
  foreach(source IN LISTS sources)
    get_filename_component(room ${source} DIRECTORY)
    get_filename_component(room ${room} NAME)
    set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${room})
  endforeach()
endfunction()

# The scalar build is the plain witness that the others are compared with. Its sixteen lanes are loops in functions:
# unrolled and inlined, they would take the compiler minutes. -Og compiles in less than half the time of -O1.
set(BLYSK_SCALAR_FLAGS -DHWY_COMPILE_ONLY_SCALAR -Og)

# Instruction sets that the kernels are built for: NAME and the flags that select it.
if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
  set(BLYSK_ISAS scalar sse4 avx2 avx512 CACHE STRING "Instruction sets to build; fewer build faster")
  set(BLYSK_ISA_FLAGS_scalar ${BLYSK_SCALAR_FLAGS})
  set(BLYSK_ISA_FLAGS_sse4 -msse4.2 -mpclmul -maes -O2)
  set(BLYSK_ISA_FLAGS_avx2 -mavx2 -mfma -mf16c -mbmi -mbmi2 -mpclmul -maes)
  set(BLYSK_ISA_FLAGS_avx512 -mavx512f -mavx512bw -mavx512cd -mavx512dq -mavx512vl
      -mavx2 -mfma -mf16c -mbmi -mbmi2 -mpclmul -maes -mprefer-vector-width=256)
elseif(CMAKE_SYSTEM_PROCESSOR MATCHES "aarch64|arm64")
  set(BLYSK_ISAS scalar neon CACHE STRING "Instruction sets to build")
  set(BLYSK_ISA_FLAGS_scalar ${BLYSK_SCALAR_FLAGS})
  set(BLYSK_ISA_FLAGS_neon -march=armv8-a+crypto)
else()
  set(BLYSK_ISAS scalar CACHE STRING "Instruction sets to build")
  set(BLYSK_ISA_FLAGS_scalar ${BLYSK_SCALAR_FLAGS})
endif()
