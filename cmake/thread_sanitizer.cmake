# Looks for data races between the window's thread, the render thread and the import thread: what runs on them and what
# they hand over is instrumented, and the tests that drive it. Kernels are not, nor Qt and TBB, whose own
# synchronisation could not be seen.
if(NOT PDR_THREAD_SANITIZER)
  return()
endif()

function(pdr_watch_threads directory)
  foreach(pattern ${ARGN})
    file(GLOB files CONFIGURE_DEPENDS ${directory}/${pattern})
    if(NOT files)
      message(FATAL_ERROR "${directory}/${pattern}: no such file; what moved must be looked for at its new place")
    endif()
    set_source_files_properties(${files} DIRECTORY ${directory} PROPERTIES
                                COMPILE_OPTIONS "-fsanitize=thread;-O1;-g;-includeoneapi/tbb/profiling.h"
                                SKIP_PRECOMPILE_HEADERS ON)  # which includes TBB before Qt makes a macro of emit
  endforeach()
endfunction()

pdr_watch_threads(${PROJECT_SOURCE_DIR}/render session/*.cpp tiles/*.cpp)
pdr_watch_threads(${PROJECT_SOURCE_DIR}/app rendering/*.cpp jobs/background_job.cpp jobs/import_job.cpp document/document.cpp
                  presenters/series_presenter.cpp presenters/image_presenter.cpp desktop/desktop.cpp)
pdr_watch_threads(${PROJECT_SOURCE_DIR}/tests/render session/session_test.cpp session/first_look_test.cpp
                  session/faults_test.cpp device/exceptions_test.cpp tiles/shared_device_test.cpp)
pdr_watch_threads(${PROJECT_SOURCE_DIR}/tests/app jobs/import_job_test.cpp desktop/image_on_screen_test.cpp)
