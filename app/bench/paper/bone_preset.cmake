# The look of the experiment's head, compiled into the program: the one source is resources/presets/ct_bone.json.
set(file ${PROJECT_SOURCE_DIR}/resources/presets/ct_bone.json)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
file(READ ${file} PDR_BONE_PRESET)
configure_file(paper/bone_preset.cpp.in ${CMAKE_CURRENT_BINARY_DIR}/bone_preset.cpp @ONLY)
target_sources(pdr_bench PRIVATE ${CMAKE_CURRENT_BINARY_DIR}/bone_preset.cpp)
