# cmake --install: headers, libraries, the package for CMake and pkg-config, the
# program with its manual.  Two parts: `command`, and `development`.
include(CMakePackageConfigHelpers)
set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/certet)

install(DIRECTORY ${PROJECT_SOURCE_DIR}/cpp/include/certet
  DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development)

get_property(components GLOBAL PROPERTY CERTET_COMPONENTS)
set(CERTET_PACKAGE_NEEDS "")
set(runtime_part development)
if(BUILD_SHARED_LIBS)
  set(runtime_part command)  # the program needs the libraries too
endif()
foreach(name IN LISTS components)
  get_property(target GLOBAL PROPERTY CERTET_TARGET_OF_${name})
  install(TARGETS ${target} EXPORT certet_${name}
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}
      COMPONENT ${runtime_part} NAMELINK_COMPONENT development
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)
  install(EXPORT certet_${name} NAMESPACE certet:: FILE certet-${name}.cmake
    DESTINATION ${package_folder} COMPONENT development)
  get_property(needs GLOBAL PROPERTY CERTET_NEEDS_OF_${name})
  set(quoted "")
  if(NOT BUILD_SHARED_LIBS)
    foreach(need IN LISTS needs)
      string(APPEND quoted " \"${need}\"")
    endforeach()
  endif()
  string(APPEND CERTET_PACKAGE_NEEDS "set(certet_needs_of_${name}${quoted})\n")

  # pkg-config: certet.pc for the core, certet-<component>.pc for the others.
  get_target_property(CERTET_PC_LIBRARY ${target} OUTPUT_NAME)
  if(NOT CERTET_PC_LIBRARY)
    set(CERTET_PC_LIBRARY ${target})
  endif()
  get_property(CERTET_PC_PRIVATE GLOBAL PROPERTY CERTET_PC_PRIVATE_OF_${name})
  if(name STREQUAL certet)
    set(pc certet)
    set(CERTET_PC_REQUIRES "")
  else()
    set(pc certet-${name})
    set(CERTET_PC_REQUIRES "certet = ${PROJECT_VERSION}")
  endif()
  set(CERTET_PC_NAME ${pc})
  configure_file(${CMAKE_CURRENT_LIST_DIR}/certet.pc.in ${PROJECT_BINARY_DIR}/package/${pc}.pc @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/package/${pc}.pc
    DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT development)
endforeach()

list(JOIN components " " CERTET_PACKAGE_COMPONENTS)
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/certetConfig.cmake.in
  ${PROJECT_BINARY_DIR}/package/certetConfig.cmake INSTALL_DESTINATION ${package_folder})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/package/certetConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES
  ${PROJECT_BINARY_DIR}/package/certetConfig.cmake
  ${PROJECT_BINARY_DIR}/package/certetConfigVersion.cmake
  ${CMAKE_CURRENT_LIST_DIR}/FindHdf5C.cmake
  ${CMAKE_CURRENT_LIST_DIR}/FindOpenVDB.cmake
  DESTINATION ${package_folder} COMPONENT development)

if(TARGET certet_command)
  # The program finds what it loads from where it is: the libraries, or the folder of its parts.
  file(RELATIVE_PATH to_libraries
    ${CMAKE_INSTALL_FULL_BINDIR} ${CMAKE_INSTALL_FULL_LIBDIR})
  if(BUILD_SHARED_LIBS)
    set_target_properties(certet_command PROPERTIES INSTALL_RPATH "$ORIGIN/${to_libraries}")
  else()
    set_target_properties(certet_command PROPERTIES
      INSTALL_RPATH "$ORIGIN/${to_libraries}/certet")
  endif()
  get_property(parts GLOBAL PROPERTY CERTET_PARTS)
  foreach(name IN LISTS parts)
    install(TARGETS certet_part_${name} LIBRARY
      DESTINATION ${CMAKE_INSTALL_LIBDIR}/certet COMPONENT ${name})
  endforeach()
  install(TARGETS certet_command RUNTIME COMPONENT command)
  if(TARGET certet_mpi)
    get_target_property(path certet_command INSTALL_RPATH)
    set_target_properties(certet_mpi PROPERTIES INSTALL_RPATH "${path}")
    install(TARGETS certet_mpi RUNTIME COMPONENT mpi)
  endif()
  set(manual ${PROJECT_BINARY_DIR}/manual)
  install(DIRECTORY ${manual}/man1 DESTINATION ${CMAKE_INSTALL_MANDIR} COMPONENT command)
  install(FILES ${manual}/bash/certet COMPONENT command
    DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
  install(FILES ${manual}/zsh/_certet COMPONENT command
    DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions)
  install(FILES ${manual}/fish/certet.fish COMPONENT command
    DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d)
endif()
set(documented command development ${parts})
if(TARGET certet_mpi)
  list(APPEND documented mpi)
endif()
foreach(part IN LISTS documented)
  set(document certet)
  if(part STREQUAL development)
    set(document libcertet-dev)
  elseif(NOT part STREQUAL command)
    set(document certet-${part})
  endif()
  install(FILES ${PROJECT_SOURCE_DIR}/LICENSE RENAME copyright
    DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${document} COMPONENT ${part})
endforeach()
