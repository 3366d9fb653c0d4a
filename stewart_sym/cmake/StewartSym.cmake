# stewart_generate(): a robot file in a CMake build, as a library of the kit that stewart-sym writes for it.
#
#     find_package(stewart-sym CONFIG REQUIRED)
#     stewart_generate(hexapod ROBOT hexapod.toml FUNCTIONS forces motion)
#     target_link_libraries(controller PRIVATE hexapod)
#
#     stewart_generate(<target> ROBOT <file> [FUNCTIONS <name>...] [FORMULATION exact|paper]
#         [FIDELITY <level>] [BAKE] [SCALAR] [PRECISION double|float] [EXECUTABLE <path>])
#
# ROBOT is relative to the current source folder; the other arguments are the options of `stewart-sym generate`.
# EXECUTABLE: the generator, otherwise STEWART_SYM_EXECUTABLE, found beside this package or on the PATH.
#
# The kit is written to <target>_kit in the current binary folder while CMake configures, since only the
# generator knows the names of its files. <target>_selftest, built when asked for, is its self-test. Robot file, generator and every file of the kit are watched: where
# one is newer than the last run, or gone, the build configures itself anew before it compiles anything.
# Files that come out equal keep their time, so nothing is compiled in vain; one that was edited by hand makes
# the generator reject. What the generator says against a robot stops the build.

cmake_policy(VERSION 3.15...3.31)

# The scripts of an environment lie beside its lib/python3.x/site-packages or Lib/site-packages.
find_program(STEWART_SYM_EXECUTABLE stewart-sym
  HINTS "${CMAKE_CURRENT_LIST_DIR}/../../../../../bin" "${CMAKE_CURRENT_LIST_DIR}/../../../../Scripts"
  DOC "The generator of stewart_generate()"
  NO_CMAKE_FIND_ROOT_PATH)

function(stewart_generate target)
  cmake_parse_arguments(PARSE_ARGV 1 arg
    "BAKE;SCALAR" "ROBOT;FORMULATION;FIDELITY;PRECISION;EXECUTABLE" "FUNCTIONS")
  if(arg_UNPARSED_ARGUMENTS OR arg_KEYWORDS_MISSING_VALUES OR NOT arg_ROBOT)
    list(JOIN arg_UNPARSED_ARGUMENTS " " unknown)
    list(JOIN arg_KEYWORDS_MISSING_VALUES " " empty)
    message(FATAL_ERROR
      "stewart_generate(${target}): expected ROBOT <file> and options with their values; "
      "not understood: ${unknown}; without a value: ${empty}")
  endif()
  set(executable "${arg_EXECUTABLE}")
  if(NOT executable)
    set(executable "${STEWART_SYM_EXECUTABLE}")
  endif()
  if(NOT executable)
    message(FATAL_ERROR
      "stewart_generate(${target}): stewart-sym not found; put it on the PATH or set STEWART_SYM_EXECUTABLE")
  endif()
  get_filename_component(robot "${arg_ROBOT}" ABSOLUTE)
  get_filename_component(executable "${executable}" ABSOLUTE)

  set(options "")
  if(arg_FUNCTIONS)
    list(JOIN arg_FUNCTIONS "," functions)
    list(APPEND options --functions "${functions}")
  endif()
  foreach(name FORMULATION FIDELITY PRECISION)
    if(arg_${name})
      string(TOLOWER "--${name}" option)
      list(APPEND options "${option}" "${arg_${name}}")
    endif()
  endforeach()
  foreach(name BAKE SCALAR)
    if(arg_${name})
      string(TOLOWER "--${name}" option)
      list(APPEND options "${option}")
    endif()
  endforeach()

  set(folder "${CMAKE_CURRENT_BINARY_DIR}/${target}_kit")
  set(command "${executable}" generate "${robot}" -o "${folder}" ${options})
  _stewart_files("${folder}.stamp" "${command}" "${robot};${executable}" files)
  if(NOT files)
    _stewart_run(${target} "${folder}" "${command}" files)
    list(JOIN command "\n" ran)
    list(JOIN files "\n" made)
    file(WRITE "${folder}.stamp" "${ran}\n${made}\n")
  endif()
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${robot}" "${executable}" ${files})

  # Programs of the kit, and what lies in folders of its own, are not for the library.
  set(sources ${files})
  list(FILTER sources INCLUDE REGEX "_kit/[^/]*\\.[ch]$")
  add_library(${target} STATIC ${sources})
  target_include_directories(${target} PUBLIC "$<BUILD_INTERFACE:${folder}>")
  set_target_properties(${target} PROPERTIES C_STANDARD 99 C_STANDARD_REQUIRED ON C_EXTENSIONS OFF)
  if(CMAKE_C_COMPILER_ID MATCHES "GNU|Clang" AND NOT MSVC)
    # One pose and a batch agree to the last bit; without errno, sqrt is an instruction.
    target_compile_options(${target} PRIVATE -ffp-contract=off -fno-math-errno)
  endif()
  if(UNIX OR (CMAKE_C_COMPILER_ID MATCHES "^(GNU|Clang)$" AND NOT MSVC))
    target_link_libraries(${target} PRIVATE m)
  endif()

  # Built and run on demand: cmake --build ... --target <target>_selftest
  add_executable(${target}_selftest EXCLUDE_FROM_ALL "${folder}/test/selftest.c")
  target_link_libraries(${target}_selftest PRIVATE ${target})
endfunction()

# The kit's files as of the last run; empty if it has to be run again: for the first time, by another command, or
# since one of the inputs or files is newer or gone.
function(_stewart_files stamp command inputs result)
  set(${result} "" PARENT_SCOPE)
  if(NOT EXISTS "${stamp}")
    return()
  endif()
  file(STRINGS "${stamp}" lines)
  list(LENGTH command words)
  list(SUBLIST lines 0 ${words} before)
  if(NOT "${before}" STREQUAL "${command}")
    return()
  endif()
  list(SUBLIST lines ${words} -1 files)
  foreach(file ${inputs} ${files})
    if(NOT EXISTS "${file}" OR "${file}" IS_NEWER_THAN "${stamp}")
      return()
    endif()
  endforeach()
  set(${result} "${files}" PARENT_SCOPE)
endfunction()

# Runs the generator; its words on standard error stop the build if it fails.
function(_stewart_run target folder command result)
  message(STATUS "stewart_generate(${target}): generating")
  file(REMOVE "${folder}.stamp")
  execute_process(COMMAND ${command} RESULT_VARIABLE code OUTPUT_VARIABLE output ERROR_VARIABLE said)
  string(STRIP "${said}" said)
  if(NOT code STREQUAL "0")
    if(said STREQUAL "")
      list(JOIN command " " line)
      set(said "${line}: ${code}")
    endif()
    # Indented: CMake breaks other lines.
    string(REPLACE "\n" "\n  " said "${said}")
    message(FATAL_ERROR "stewart_generate(${target}):\n  ${said}\n")
  endif()
  if(said)
    message(NOTICE "${said}")
  endif()
  # It prints the files that it wrote or found equal, one a line, and more.
  if(CMAKE_HOST_WIN32)
    string(REPLACE "\\" "/" output "${output}")
  endif()
  string(REPLACE "\n" ";" lines "${output}")
  set(files "")
  foreach(line IN LISTS lines)
    string(FIND "${line}" "${folder}/" at)
    if(at EQUAL 0)
      list(APPEND files "${line}")
    endif()
  endforeach()
  if(NOT files)
    message(FATAL_ERROR "stewart_generate(${target}): the generator named no files in ${folder}")
  endif()
  set(${result} "${files}" PARENT_SCOPE)
endfunction()
