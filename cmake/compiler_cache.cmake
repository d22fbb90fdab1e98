# Objects that were compiled before come from ccache, where it is installed. Precompiled headers need its leave: their
# macros and times are not looked at, since CMake knows when to make them again.
if(DEFINED CMAKE_CXX_COMPILER_LAUNCHER OR DEFINED ENV{CMAKE_CXX_COMPILER_LAUNCHER})
  return()
endif()
find_program(PDR_CCACHE ccache)
if(PDR_CCACHE)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros ${PDR_CCACHE})
  set(CMAKE_CUDA_COMPILER_LAUNCHER ${PDR_CCACHE})
endif()
