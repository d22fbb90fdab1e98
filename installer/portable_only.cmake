# Read by cpack before it packs anything.
if(CPACK_PDR_ARCH STREQUAL "native")
  message(FATAL_ERROR "These programs are built for this machine's processor alone and may crash on another. Build the "
    "package with: cmake --preset release-portable && cmake --build --preset release-portable --target package")
endif()
