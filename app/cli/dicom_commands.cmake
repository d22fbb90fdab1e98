# The commands of pdrender-cli that read and write DICOM folders.
add_library(pdr_cli_dicom STATIC
  ${CMAKE_CURRENT_LIST_DIR}/scan/cranium.cpp
  ${CMAKE_CURRENT_LIST_DIR}/scan/example_command.cpp
  ${CMAKE_CURRENT_LIST_DIR}/scan/info_command.cpp
  ${CMAKE_CURRENT_LIST_DIR}/scan/series_report.cpp
)
target_link_libraries(pdr_cli_dicom PUBLIC Qt6::Core PRIVATE pdr_cli pdr_dicom nlohmann_json::nlohmann_json)
pdr_harden(pdr_cli_dicom)
