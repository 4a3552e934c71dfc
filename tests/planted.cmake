# Defects planted in the library, each of which a test must catch.

# certet_planted(<test> <defect> FILE <file> FROM <text> TO <text> ONLY <filter> SAYS <words>)
#
# The program of <test> with the sources of the file's folder, in which <text> is another, must say
# <words> of the tests that the filter chooses.  The sources are compiled into the program, whose
# own come before those of the library.
function(certet_planted test defect)
  cmake_parse_arguments(PARSE_ARGV 2 arg "" "FILE;FROM;TO;ONLY;SAYS" "")
  set(name ${test}_${defect})
  set(from ${PROJECT_SOURCE_DIR}/cpp)
  set(to ${CMAKE_CURRENT_BINARY_DIR}/planted/${defect})
  get_filename_component(folder ${arg_FILE} DIRECTORY)
  file(GLOB sources RELATIVE ${from} CONFIGURE_DEPENDS ${from}/${folder}/*.?pp)
  foreach(source ${sources})
    if(NOT source STREQUAL arg_FILE)
      configure_file(${from}/${source} ${to}/${source} COPYONLY)
    endif()
  endforeach()
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${from}/${arg_FILE})
  file(READ ${from}/${arg_FILE} right)
  string(REPLACE "${arg_FROM}" "${arg_TO}" wrong "${right}")
  if(wrong STREQUAL right)
    message(FATAL_ERROR "${arg_FILE} has no '${arg_FROM}' to plant a defect in")
  endif()
  file(CONFIGURE OUTPUT ${to}/${arg_FILE} CONTENT "${wrong}" @ONLY)
  list(FILTER sources INCLUDE REGEX "cpp$")
  list(TRANSFORM sources PREPEND ${to}/)
  add_executable(${name} ${sources} $<TARGET_OBJECTS:${test}>)
  set_target_properties(${name} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 0)
  target_include_directories(${name} PRIVATE ${to} ${from})
  get_target_property(libraries ${test} LINK_LIBRARIES)
  target_link_libraries(${name} PRIVATE ${libraries})
  target_link_options(${name} PRIVATE LINKER:-z,muldefs)
  add_test(NAME planted.${defect} COMMAND ${name} --gtest_filter=${arg_ONLY})
  set_tests_properties(planted.${defect} PROPERTIES
    LABELS property
    PASS_REGULAR_EXPRESSION ${arg_SAYS})
endfunction()
