# For what reads files from anywhere: a fault in it must end the program and not be used to take it over.
# render/device and render/session read no files and do without the guarded stack, since they are where the time goes.
set(PDR_GUARDED_STACK -fstack-protector-strong)
set(PDR_CHECKED_CALLS "")
# The checks need the optimiser, and sanitizers have their own.
if(CMAKE_BUILD_TYPE AND NOT CMAKE_BUILD_TYPE STREQUAL "Debug")
  set(PDR_CHECKED_CALLS -U_FORTIFY_SOURCE -D_FORTIFY_SOURCE=2)
endif()
add_link_options(LINKER:-z,relro,-z,now)

# pdr_harden(TARGET...): all of their sources.
function(pdr_harden)
  foreach(target ${ARGN})
    target_compile_options(${target} PRIVATE ${PDR_GUARDED_STACK} ${PDR_CHECKED_CALLS})
  endforeach()
endfunction()
