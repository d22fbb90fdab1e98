# For what reads files from anywhere: a fault in it must end the program and not be used to take it over.
# render/device and render/session read no files and are left out, since they are where the time goes.
set(PDR_HARDENING -fstack-protector-strong)
# The checks need the optimiser, and sanitizers have their own.
if(CMAKE_BUILD_TYPE AND NOT CMAKE_BUILD_TYPE STREQUAL "Debug")
  list(APPEND PDR_HARDENING -U_FORTIFY_SOURCE -D_FORTIFY_SOURCE=2)
endif()
add_link_options(LINKER:-z,relro,-z,now)

# pdr_harden(TARGET...): all of their sources.
function(pdr_harden)
  foreach(target ${ARGN})
    target_compile_options(${target} PRIVATE ${PDR_HARDENING})
  endforeach()
endfunction()
