# Sets PDR_HAS_CUDA and, where it is on, enables CUDA. Builds for the GPU that is here; where there is none, for the
# oldest architecture that the compiler knows, which newer drivers translate. The preset cuda-release names them all.
# PDR_NO_CUDA: why it is off.
set(PDR_HAS_CUDA OFF)
if(PDR_CUDA STREQUAL "off")
  set(PDR_NO_CUDA "PDR_CUDA is off")
  return()
endif()
# CUDA 12 packs what it embeds in another way, and CUDA 11 knows no C++20: both are passed over.
function(pdr_is_new_enough answer compiler)
  execute_process(COMMAND ${compiler} --version OUTPUT_VARIABLE told ERROR_QUIET)
  if(NOT told MATCHES "release ([0-9]+)" OR CMAKE_MATCH_1 LESS 13)
    set(${answer} FALSE PARENT_SCOPE)
  endif()
endfunction()
# build/nvcc: what ./bootstrap test fetches.
find_program(PDR_NVCC nvcc HINTS /usr/local/cuda/bin ENV CUDA_PATH PATH_SUFFIXES bin
  PATHS ${PROJECT_SOURCE_DIR}/build/nvcc/nvidia/cu13/bin VALIDATOR pdr_is_new_enough)
if(NOT PDR_NVCC)
  set(PDR_NO_CUDA "no compiler of CUDA 13 (nvcc) was found")
  if(PDR_CUDA STREQUAL "on")
    message(FATAL_ERROR "PDR_CUDA is on, but ${PDR_NO_CUDA}. Install the CUDA Toolkit or put nvcc on the PATH.")
  endif()
  message(STATUS "CUDA: ${PDR_NO_CUDA}; images are rendered by the CPU")
  return()
endif()
set(CMAKE_CUDA_COMPILER ${PDR_NVCC})
if(NOT DEFINED CMAKE_CUDA_ARCHITECTURES)
  execute_process(COMMAND nvidia-smi --query-gpu=compute_cap --format=csv,noheader
    OUTPUT_VARIABLE capabilities ERROR_QUIET RESULT_VARIABLE failed)
  if(failed EQUAL 0 AND capabilities MATCHES "([0-9]+)\\.([0-9]+)")
    set(CMAKE_CUDA_ARCHITECTURES ${CMAKE_MATCH_1}${CMAKE_MATCH_2} CACHE STRING "GPU architectures")
  else()
    set(CMAKE_CUDA_ARCHITECTURES 75 CACHE STRING "GPU architectures")
  endif()
endif()
enable_language(CUDA)
# CMake 3.25 does not know how to ask nvcc 13 for C++20.
set(CMAKE_CUDA20_STANDARD_COMPILE_OPTION "-std=c++20")
set(CMAKE_CUDA_STANDARD 20)
find_package(CUDAToolkit REQUIRED)
set(PDR_HAS_CUDA ON)
message(STATUS "CUDA: ${CMAKE_CUDA_COMPILER_VERSION}, for ${CMAKE_CUDA_ARCHITECTURES}")
