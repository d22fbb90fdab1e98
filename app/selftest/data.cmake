# The self-test's reference cases, compiled into the program: the one source is tests/physics/*.json.
set(PDR_REFERENCE_FILES "")
foreach(name
    slab_all_orders
    half_space
    radiance_all_orders
    lamps
    surfaces
    lens
    furnace
    layers
    slab_one_order
    sphere_one_order
    transmittance
    free_flight
    phase_function
)
  set(file ${PROJECT_SOURCE_DIR}/tests/physics/${name}.json)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
  file(READ ${file} json)
  string(APPEND PDR_REFERENCE_FILES "    {\"${name}.json\", R\"json(${json})json\"},\n")
endforeach()
configure_file(data.cpp.in ${CMAKE_CURRENT_BINARY_DIR}/data.cpp @ONLY)
target_sources(pdr_selftest PRIVATE ${CMAKE_CURRENT_BINARY_DIR}/data.cpp)
