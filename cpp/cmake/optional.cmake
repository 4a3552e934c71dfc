# certet_find(<part> <arguments of find_package...>)
# Sets CERTET_HAS_<part> by the switch CERTET_<part>.  A macro, so that the
# variables of the package are set where it is called.
macro(certet_find part package)
  set(CERTET_HAS_${part} FALSE)
  if(NOT CERTET_${part} STREQUAL "OFF")
    # Some packages talk at length about parts of theirs that are not asked for.
    set(certet_log_level "${CMAKE_MESSAGE_LOG_LEVEL}")
    set(CMAKE_MESSAGE_LOG_LEVEL WARNING)
    find_package(${package} ${ARGN} QUIET)
    set(CMAKE_MESSAGE_LOG_LEVEL "${certet_log_level}")
    if(${package}_FOUND)
      set(CERTET_HAS_${part} TRUE)
    elseif(CERTET_${part} STREQUAL "ON")
      message(FATAL_ERROR "CERTET_${part} is ON, but ${package} was not found")
    endif()
  endif()
  message(STATUS "certet: ${part} ${CERTET_HAS_${part}}")
endmacro()

# certet_optional(<target> <part> SOURCES <file>... LIBRARIES <target>... ABSENT <file>...)
# What a target has of a part that certet_find looked for, or has in its place.  A part is an object
# library <target>_<part>, so that a program can link the target without it (command/parts/).
function(certet_optional target part)
  cmake_parse_arguments(PARSE_ARGV 2 arg "" "" "SOURCES;LIBRARIES;ABSENT")
  if(NOT CERTET_HAS_${part})
    target_sources(${target} PRIVATE ${arg_ABSENT})
    return()
  endif()
  target_link_libraries(${target} PRIVATE ${arg_LIBRARIES})
  string(TOLOWER ${target}_${part} objects)
  add_library(${objects} OBJECT ${arg_SOURCES})
  set_target_properties(${objects} PROPERTIES
    POSITION_INDEPENDENT_CODE ON
    UNITY_BUILD_BATCH_SIZE 16)  # headers of such parts take longer than the sources
  target_compile_features(${objects} PRIVATE cxx_std_20)
  target_link_libraries(${objects} PRIVATE ${arg_LIBRARIES})
  foreach(what INCLUDE_DIRECTORIES COMPILE_DEFINITIONS COMPILE_OPTIONS)
    set_property(TARGET ${objects} APPEND PROPERTY ${what} $<TARGET_PROPERTY:${target},${what}>)
  endforeach()
  target_sources(${target} PRIVATE $<TARGET_OBJECTS:${objects}>)
endfunction()

# certet_uses_library(<target>)
# What makes a library stand beside the first one: it is built on it, and sees the headers of all
# rooms by their folders.
function(certet_uses_library target)
  target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR}/cpp)
  target_link_libraries(${target} PUBLIC certet::certet PRIVATE $<BUILD_INTERFACE:certet_flags>)
endfunction()

# What every target of the project is compiled with.  Contraction to fused
# multiply-add would make results depend on compiler and machine; a square root
# that need not set errno vectorises.
add_library(certet_flags INTERFACE)
target_compile_options(certet_flags INTERFACE
  -Wall -Wextra -Wconversion
  $<$<BOOL:${CERTET_WERROR}>:-Werror>
  -ffp-contract=off -fno-math-errno
  -fno-semantic-interposition)

# Ranks in bit sets are counted by the popcount instruction, which every x86-64
# machine since 2009 has.
if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
  target_compile_options(certet_flags INTERFACE -march=x86-64-v2)
endif()
