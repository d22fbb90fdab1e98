# Sets PDR_HAS_CUDA and, where it is on, enables CUDA. Builds for the GPU that is here; where there is none, for the
# oldest that the compiler knows; the drivers of others translate the PTX that is embedded too. PDR_CUDA_CODE, a list of
# compute capabilities without their point, names others. PDR_NO_CUDA: why CUDA is off.
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
if(NOT PDR_CUDA_CODE)
  execute_process(COMMAND nvidia-smi --query-gpu=compute_cap --format=csv,noheader
    OUTPUT_VARIABLE capabilities ERROR_QUIET RESULT_VARIABLE failed)
  if(failed EQUAL 0 AND capabilities MATCHES "([0-9]+)\\.([0-9]+)")
    set(PDR_CUDA_CODE ${CMAKE_MATCH_1}${CMAKE_MATCH_2})
  else()
    set(PDR_CUDA_CODE 75)
  endif()
endif()
# One PTX is the source of all machine code and is embedded too: tests/ptx proves what every GPU gets, newer ones can
# translate it, and the compiler's front runs once. CMake would make a PTX of its own for each architecture.
list(TRANSFORM PDR_CUDA_CODE PREPEND sm_ OUTPUT_VARIABLE code)
list(JOIN code "," code)
set(CMAKE_CUDA_ARCHITECTURES OFF)
enable_language(CUDA)
# By default nvcc leaves machine code as it is: five times as large.
string(APPEND CMAKE_CUDA_FLAGS " --compress-mode=size \"--generate-code=arch=compute_75,code=[compute_75,${code}]\"")
# CMake 3.25 does not know how to ask nvcc 13 for C++20.
set(CMAKE_CUDA20_STANDARD_COMPILE_OPTION "-std=c++20")
set(CMAKE_CUDA_STANDARD 20)
find_package(CUDAToolkit REQUIRED)
set(PDR_HAS_CUDA ON)
message(STATUS "CUDA: ${CMAKE_CUDA_COMPILER_VERSION}, for ${code}")
