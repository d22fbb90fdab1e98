# The look of the experiment's head, compiled into the program. It stays as it is, whatever becomes of the looks that are
# offered, so that measurements of another year can be compared.
set(file ${CMAKE_CURRENT_LIST_DIR}/bone_look.json)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
file(READ ${file} PDR_BONE_LOOK)
configure_file(paper/bone_look.cpp.in ${CMAKE_CURRENT_BINARY_DIR}/bone_look.cpp @ONLY)
target_sources(pdr_bench PRIVATE ${CMAKE_CURRENT_BINARY_DIR}/bone_look.cpp)
