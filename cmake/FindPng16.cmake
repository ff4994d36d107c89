# Finds libpng and the zlib that it needs, the static archives first, as Png16::Png16. Installed beside
# blysk-config.cmake, because a program that links the static library needs them too.
find_path(Png16_INCLUDE_DIR png.h)
find_library(Png16_LIBRARY NAMES libpng16.a png16)
find_library(Png16_ZLIB_LIBRARY NAMES libz.a z)
mark_as_advanced(Png16_INCLUDE_DIR Png16_LIBRARY Png16_ZLIB_LIBRARY)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Png16 REQUIRED_VARS Png16_LIBRARY Png16_ZLIB_LIBRARY Png16_INCLUDE_DIR
  REASON_FAILURE_MESSAGE "on Debian: apt-get install libpng-dev zlib1g-dev")

if(Png16_FOUND AND NOT TARGET Png16::Png16)
  add_library(Png16::Png16 UNKNOWN IMPORTED)
  set_target_properties(Png16::Png16 PROPERTIES
    IMPORTED_LOCATION "${Png16_LIBRARY}" INTERFACE_INCLUDE_DIRECTORIES "${Png16_INCLUDE_DIR}"
    INTERFACE_LINK_LIBRARIES "${Png16_ZLIB_LIBRARY};m")
endif()
